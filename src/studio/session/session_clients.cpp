// A session's clients: joining, leaving and sending.
#include <algorithm>

#include "studio/session/frames/overlay.h"
#include "studio/session/inbox/chosen_scheme.h"
#include "studio/session/session_state.h"

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
    SessionClient& client = impl_->clients.emplace(id, SessionClient(impl_->def.limits)).first->second;
    client.id = client.number = id;
    return id;
}

void Session::disconnect(std::uint32_t client) {
    const auto found = impl_->clients.find(client);
    if (found == impl_->clients.end()) return;
    if (found->second.steers && !impl_->player) {
        std::vector<CommandBody> bodies{ReleaseClient{}};
        (void)impl_->submit(found->second, bodies);
    }
    impl_->directors.leave(found->second.number);
    impl_->editor.forget(found->second.number);
    impl_->clients.erase(found);
    impl_->endBuilding(client);
    if (impl_->shared.pausedBy == client || impl_->shared.changedBy == client) impl_->shared.touch();
    if (impl_->ask.asker() == client) impl_->closeAsk();
    impl_->ask.leave(client);
    impl_->settleAsk();
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

std::vector<protocol::ScenarioInfo> Session::Impl::scenarioInfos() const {
    std::vector<protocol::ScenarioInfo> infos;
    for (const ScenarioEntry& entry : def.scenarios)
        infos.push_back({entry.name, entry.title, entry.description, entry.characters});
    return infos;
}

void Session::Impl::greet(SessionClient& client, const std::string& called) {
    client.greeted = true;
    directors.join(client.number, called);
    protocol::Welcome welcome;
    welcome.client = client.number;
    welcome.version = def.version;
    welcome.scenarios = scenarioInfos();
    for (const NamedScheme& scheme : namedSchemes()) welcome.schemes.push_back(infoOf(scheme));
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
    if (to.greeted) impl_->sendShared(to);
    if (to.greeted && impl_->world) impl_->sendTake(to);
    if (to.greeted && impl_->world) impl_->sendEdits(to);
    if (to.greeted) impl_->sendHistory(to);
    to.scheme.send(to.outbox);
    if (to.greeted && impl_->world && !to.frames.waits()) {
        impl_->sendOverlay(to);
        impl_->sendStages(to);
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

// Builds the part of the frame that all clients share, once per state.
void Session::Impl::buildFrame() {
    if (frameState == state) return;
    frames.build(*world, frame, shown());
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
    buildFrame();
    const WorldPicture picture{*world, frames, motion, sceneRevision, sceneBytes, frame};
    client.frames.send(picture, client.touchShown, client.events, client.outbox);
    client.sentState = state;
    client.frameDue = realTime + frameSpacing(world->characters().size());
}

void Session::Impl::sendOverlay(SessionClient& client) {
    if (client.overlay == protocol::OverlayKind::None || realTime < client.overlayDue) return;
    if (client.overlayState == state) return;
    if (client.overlay == protocol::OverlayKind::Reach) {
        const ReachVersion version = reachVersion(*world);
        if (client.overlayState != 0 && client.sentReach == version) return;
        client.sentReach = version;
    }
    client.overlayDue = realTime + 1.0 / def.limits.overlaysPerSecond;
    client.overlayState = state;
    const auto overlay = buildOverlay(*world, client.overlay, client.overlayCharacter);
    if (overlay) client.outbox.push_back(protocol::encode(*overlay));
}

void Session::Impl::sendStages(SessionClient& client) {
    if (!client.watchesStages || client.sentStages == stages.revision()) return;
    client.sentStages = stages.revision();
    client.outbox.push_back(stages.message());
}

}  // namespace muster
