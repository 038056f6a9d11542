// A session's clients: joining, leaving and sending.
#include <algorithm>

#include "session/overlay.h"
#include "session/session_state.h"

namespace muster {
namespace {

// Shortest interval between large frames [s]; the page interpolates between frames. It is a little below the
// nominal interval, so that a frame that comes with a step does not wait for the next step.
double frameSpacing(std::size_t characters) {
    constexpr double kSlack = 0.004;
    if (characters > 20'000) return 1.0 / 20.0 - kSlack;
    return characters > 2'000 ? 1.0 / 30.0 - kSlack : 0.0;
}

}  // namespace

std::uint32_t Session::connect() {
    const std::uint32_t id = ++impl_->lastClient;
    impl_->clients.emplace(id, SessionClient(impl_->def.limits)).first->second.number = id;
    return id;
}

void Session::disconnect(std::uint32_t client) {
    const auto found = impl_->clients.find(client);
    if (found == impl_->clients.end()) return;
    if (found->second.steers && !impl_->player) {
        std::vector<CommandBody> bodies{ReleaseClient{}};
        (void)impl_->submit(found->second, bodies);
    }
    impl_->clients.erase(found);
    impl_->directors.leave(client);
}

void Session::notice(std::uint32_t client, bool error, const std::string& code, const std::string& text) {
    const auto found = impl_->clients.find(client);
    if (found == impl_->clients.end()) return;
    impl_->notice(found->second, error ? protocol::NoticeLevel::Error : protocol::NoticeLevel::Info, code,
                  text);
}

void Session::Impl::notice(SessionClient& client, protocol::NoticeLevel level, const std::string& code,
                           const std::string& text, std::optional<Vec2> place) {
    if (!client.notices.take(realTime)) return;
    protocol::Notice message;
    message.level = level;
    message.code = code;
    message.text = text;
    if (place) {
        message.hasPlace = true;
        message.x = static_cast<float>(place->x);
        message.y = static_cast<float>(place->y);
    }
    client.outbox.push_back(protocol::encode(message));
}

void Session::Impl::noticeAll(protocol::NoticeLevel level, const std::string& code, const std::string& text,
                              std::optional<Vec2> place) {
    for (auto& [id, client] : clients) {
        if (client.greeted) notice(client, level, code, text, place);
    }
}

void Session::Impl::tellOthers(std::uint32_t id, const std::string& did) {
    for (auto& [other, client] : clients) {
        if (client.greeted && other != id)
            notice(client, protocol::NoticeLevel::Info, "director", directors.name(id) + " " + did + ".");
    }
}

void Session::Impl::greet(SessionClient& client, const std::string& called) {
    client.greeted = true;
    directors.join(client.number, called);
    protocol::Welcome welcome;
    welcome.client = client.number;
    welcome.version = def.version;
    for (const ScenarioEntry& entry : def.scenarios)
        welcome.scenarios.push_back({entry.name, entry.title, entry.description, entry.characters});
    client.outbox.push_back(protocol::encode(welcome));
    if (world && !warning.empty()) notice(client, protocol::NoticeLevel::Warning, "scenario", warning + ".");
    if (world) warnOfClips(client);
}

void Session::Impl::warnOfClips(SessionClient& client) {
    if (!clipsRead.ok()) notice(client, protocol::NoticeLevel::Warning, "clips", clipsRead.message() + ".");
}

void Session::outgoing(std::uint32_t client, std::vector<MessageBytes>& messages) {
    messages.clear();
    const auto found = impl_->clients.find(client);
    if (found == impl_->clients.end()) return;
    SessionClient& to = found->second;
    if (to.greeted) impl_->sendDirectors(to);
    if (to.greeted && impl_->world) impl_->sendTake(to);
    if (to.greeted && impl_->world && !to.awaitsAck) {
        impl_->sendOverlay(to);
        const bool due = !impl_->playing || impl_->realTime >= to.frameDue;
        if (to.sentState != impl_->state && due) impl_->sendFrame(to);
    }
    messages.swap(to.outbox);
}

void Session::Impl::sendDirectors(SessionClient& client) {
    if (client.sentDirectors == directors.revision()) return;
    client.sentDirectors = directors.revision();
    client.outbox.push_back(protocol::encode(directors.message()));
}

// Sends everything that a frame refers to before the frame.
void Session::Impl::sendScene(SessionClient& client) {
    if (client.sentScene != sceneRevision) {
        client.outbox.push_back(sceneBytes);
        client.sentScene = sceneRevision;
        // The page forgets all characters and meshes when it gets a new scene.
        client.sentIds = 0;
        client.sentMeshes.clear();
    }
    if (client.sentMotions != motion.revision()) {
        client.outbox.push_back(motion.motions());
        client.sentMotions = motion.revision();
    }
    for (std::size_t g = 0; g < world->groupCount(); ++g) {
        const GroupView group = world->group(g);
        const auto sent = client.sentMeshes.find(group.id.value);
        if (sent != client.sentMeshes.end() && sent->second == group.formationVersion) continue;
        client.outbox.push_back(protocol::encode(buildGroupMesh(*world, g)));
        client.sentMeshes[group.id.value] = group.formationVersion;
        client.places[group.id.value].restart();
    }
}

// Builds the part of the frame that all clients share, once per state.
void Session::Impl::buildFrame() {
    if (frameState == state) return;
    frames.build(*world, frame);
    motion.build(frames.crowd());
    frame.playing = playing;
    frame.speed = static_cast<float>(speed);
    frame.recordedSeconds = recordedFrom < 0.0 ? -1.0f : static_cast<float>(world->time() - recordedFrom);
    frame.replaying = player != nullptr;
    frame.demonstrating = demonstrating();
    frame.sceneRevision = sceneRevision;
    frameState = state;
}

void Session::Impl::sendFrame(SessionClient& client) {
    sendScene(client);
    buildFrame();
    const bool known = client.sentIds == frames.idsVersion();
    client.crowd.encode(frames.crowd(), !known, frame.crowd);
    for (std::size_t g = 0; g < frame.groups.size(); ++g)
        client.places[frame.groups[g].id].encode(frames.places()[g], frame.groups[g]);
    frame.frame = ++client.frame;
    frame.touchEcho = client.touchShown;
    frame.events.swap(client.events);
    // Ids, groups and bodies are left out of this message where the client already has them.
    std::vector<std::uint32_t> ids;
    std::vector<std::uint8_t> groups, classes, radii;
    const auto swapMembers = [&] {
        if (!known) return;
        ids.swap(frame.ids);
        groups.swap(frame.group);
        classes.swap(frame.unitClass);
        radii.swap(frame.radius);
    };
    swapMembers();
    client.outbox.push_back(protocol::encode(frame));
    swapMembers();
    frame.events.swap(client.events);
    client.events.clear();
    client.sentIds = frames.idsVersion();
    client.sentState = state;
    client.frameDue = realTime + frameSpacing(world->characters().size());
    client.awaitsAck = true;
}

void Session::Impl::sendOverlay(SessionClient& client) {
    if (client.overlay == protocol::OverlayKind::None || realTime < client.overlayDue) return;
    if (client.overlayState == state) return;
    client.overlayDue = realTime + 1.0 / def.limits.overlaysPerSecond;
    client.overlayState = state;
    const auto overlay = buildOverlay(*world, client.overlay, client.overlayCharacter);
    if (overlay) client.outbox.push_back(protocol::encode(*overlay));
}

}  // namespace muster
