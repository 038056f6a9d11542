// A session's directors on the one world that they share: pausing, building, asking, and going back.
#include <algorithm>

#include "muster/scenario.h"
#include "studio/session/session_state.h"

namespace muster {
namespace {

constexpr std::size_t kMostRequestLetters = 100;
constexpr std::size_t kMostTitleLetters = 80;

}  // namespace

std::size_t Session::Impl::greetedClients() const {
    return static_cast<std::size_t>(std::count_if(clients.begin(), clients.end(),
                                                  [](const auto& entry) { return entry.second.greeted; }));
}

// ---- Pausing and building ----

void Session::Impl::pause(const SessionClient& client) {
    shared.pausedBy = playing ? client.id : shared.pausedBy;
    shared.goesOn = shared.goesOn && !playing;
    playing = false;
    shared.touch();
}

void Session::Impl::resume() {
    playing = true;
    waitsForHand = false;
    shared.pausedBy = 0;
    shared.touch();
}

Status Session::Impl::build(SessionClient& client, bool on) {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (on == shared.builders.contains(client.id)) return {};
    if (!on) {
        endBuilding(client.id);
        return {};
    }
    if (shared.builders.empty()) shared.goesOn = false;
    shared.builders.insert(client.id);
    shared.goesOn = shared.goesOn || playing;
    playing = false;
    shared.touch();
    touchState();
    return {};
}

// The world goes on for everybody where it went on before.
void Session::Impl::endBuilding(std::uint32_t id) {
    if (shared.builders.erase(id) == 0) return;
    shared.touch();
    if (!shared.builders.empty() || !shared.goesOn) return;
    resume();
    pacer.reset();
    touchState();
}

// ---- Asking ----

Status Session::Impl::askOthers(SessionClient& client, const protocol::AskOthers& message) {
    const std::string request = plainText(message.request, kMostRequestLetters);
    if (request.empty()) {
        if (ask.asker() == client.id) closeAsk();
        return {};
    }
    if (ask.open() && ask.asker() != client.id) {
        const std::uint32_t number = numberOf(ask.asker());
        client.outbox.push_back(protocol::encode(protocol::AskAnswered{false, number}));
        return {};
    }
    closeAsk();
    std::set<std::uint32_t> others;
    for (const auto& [id, other] : clients)
        if (other.greeted && id != client.id) others.insert(id);
    ask.begin(client.id, others, realTime);
    for (const std::uint32_t id : others)
        clients.at(id).outbox.push_back(protocol::encode(
            protocol::Ask{ask.number(), client.number, request, static_cast<float>(WorldAsk::kSeconds)}));
    settleAsk();
    return {};
}

Status Session::Impl::answerAsk(SessionClient& client, const protocol::AnswerAsk& message) {
    ask.answer(client.id, message.number, message.allow);
    settleAsk();
    return {};
}

// Nobody is asked any more, and nobody hears how it ended.
void Session::Impl::closeAsk() {
    if (!ask.open()) return;
    const std::uint32_t asker = ask.asker();
    ask.withdraw(asker);
    for (auto& [id, other] : clients)
        if (other.greeted && id != asker) other.outbox.push_back(protocol::encode(protocol::Ask{}));
}

void Session::Impl::settleAsk() {
    const auto end = ask.end(realTime);
    if (!end) return;
    for (auto& [id, client] : clients) {
        if (!client.greeted) continue;
        if (id == end->asker)
            client.outbox.push_back(
                protocol::encode(protocol::AskAnswered{end->minds == 0, numberOf(end->minds)}));
        else
            client.outbox.push_back(protocol::encode(protocol::Ask{}));
    }
}

std::uint32_t Session::Impl::numberOf(std::uint32_t id) const {
    const auto found = clients.find(id);
    return found == clients.end() ? 0 : found->second.number;
}

SessionClient* Session::Impl::clientOf(std::uint32_t number) {
    const auto found = std::find_if(clients.begin(), clients.end(),
                                    [&](const auto& entry) { return entry.second.number == number; });
    return found == clients.end() ? nullptr : &found->second;
}

std::uint32_t Session::Impl::idOf(std::uint32_t number) const {
    for (const auto& [id, client] : clients)
        if (client.greeted && client.number == number) return id;
    return 0;
}

// ---- Another world, and back ----

Status Session::Impl::beginFor(std::uint32_t id, protocol::WorldChange change,
                               const std::function<Status()>& work) {
    leaving = Leaving{recordedFrom >= 0.0};
    const Status status = work();
    leaving.reset();
    if (!status.ok()) return status;
    shared.change = change;
    shared.changedBy = id;
    shared.changer = directors.name(numberOf(id));
    shared.touch();
    return status;
}

// The world from which a take is opened waits beneath it, and beneath those that are opened over it. Any
// other world waits where others share it. Fingers let go: the pages forget them with the world that they
// see.
void Session::Impl::park(bool forTake) {
    parked.reset();
    if (!forTake) beneath.reset();
    if (!world) return;
    const bool beneathTake = forTake && !player;
    if (!beneathTake && greetedClients() < 2) return;
    ParkedWorld kept;
    kept.name = name;
    kept.def = worldDef;
    kept.playing = playing || shared.goesOn;
    kept.speed = speed;
    if (player) {
        kept.takenBytes = takenBytes;
        kept.takeName = player->fileName();
        kept.takeAbout = player->about();
        kept.takeLoops = player->loops();
        kept.takeStep = player->seeking() ? player->wanted() : world->stepCount();
        parked = std::move(kept);
        return;
    }
    for (auto& [id, client] : clients) {
        if (!client.steers) continue;
        std::vector<CommandBody> bodies{ReleaseClient{}};
        (void)submit(client, bodies);
        kept.sequences[client.number] = client.sequence;
    }
    kept.world = std::move(world);
    kept.editor = std::move(editor);
    kept.log = std::move(log);
    kept.layer = std::move(layer);
    kept.nextOfLayer = nextOfLayer;
    kept.waitsForHand = waitsForHand;
    kept.recorded = recorded;
    kept.recording = leaving->recording;
    kept.recordedAbout = recordedAbout;
    kept.recordedCommands = recordedCommands;
    kept.demonstratedUntil = demonstratedUntil;
    editor = {};
    log = {};
    (beneathTake ? beneath : parked) = std::move(kept);
}

Status Session::Impl::goBack(std::uint32_t id) {
    if (!parked && player) return leaveTake(id, true);
    if (!parked) return {StatusCode::NotFound, "there is no world to go back to"};
    ParkedWorld back = std::move(*parked);
    return beginFor(id, protocol::WorldChange::WentBack, [&] {
        if (!back.takenBytes.empty()) return reopen(back);
        bringBack(back);
        return Status();
    });
}

// A recording that the take has ended has been kept; `records` begins another one.
Status Session::Impl::leaveTake(std::uint32_t id, bool records) {
    if (!player || !beneath) return {StatusCode::NotFound, "there is no world to go back to"};
    ParkedWorld back = std::move(*beneath);
    back.recording = back.recording && records;
    return beginFor(id, protocol::WorldChange::WentBack, [&] {
        bringBack(back);
        return Status();
    });
}

Status Session::Impl::reopen(const ParkedWorld& back) {
    if (Status s = openTake(back.takenBytes, back.def.name, back.takeName); !s.ok()) return s;
    player->edit(back.takeAbout, back.takeLoops);
    showEdits(back.takeAbout.edits);
    player->want(back.takeStep);
    goOnAs(back);
    touchTake();
    return {};
}

// It runs as it ran; where somebody builds, when they have done.
void Session::Impl::goOnAs(const ParkedWorld& back) {
    playing = back.playing && shared.builders.empty();
    shared.goesOn = back.playing && !shared.builders.empty();
    speed = back.speed;
}

void Session::Impl::bringBack(ParkedWorld& back) {
    beginWith(std::move(*back.world), back.name, back.def);
    const std::uint32_t before = editor.revision();
    editor = std::move(back.editor);
    log = std::move(back.log);
    layer = std::move(back.layer);
    nextOfLayer = back.nextOfLayer;
    waitsForHand = back.waitsForHand;
    demonstratedUntil = back.demonstratedUntil;
    recorded = back.recorded;
    recordedAbout = back.recordedAbout;
    recordedCommands = back.recordedCommands;
    for (auto& [id, client] : clients) {
        const auto found = back.sequences.find(client.number);
        if (found == back.sequences.end()) continue;
        client.sequence = found->second;
        client.steers = true;
    }
    if (back.recording) beginRecording(back.recordedAbout.from, back.recordedAbout.title, nullptr);
    goOnAs(back);
    editor.touch(before);
    refreshScene();
}

void Session::Impl::sendShared(SessionClient& client) {
    if (client.sentShared == shared.revision) return;
    const ParkedWorld* before = parked ? &*parked : player && beneath ? &*beneath : nullptr;
    const bool nothing = shared.pausedBy == 0 && shared.builders.empty() &&
                         shared.change == protocol::WorldChange::None && before == nullptr;
    const bool first = client.sentShared == 0;
    client.sentShared = shared.revision;
    if (first && nothing) return;  // A client takes for granted that there is nothing.
    protocol::SharedWorld message;
    message.pausedBy = numberOf(shared.pausedBy);
    for (const std::uint32_t id : shared.builders) message.builders.push_back(numberOf(id));
    message.change = shared.change;
    message.changedBy = numberOf(shared.changedBy);
    message.changer = shared.changer;
    message.before = before != nullptr ? before->def.name : std::string();
    client.outbox.push_back(protocol::encode(message));
}

// ---- The place's name ----

Status Session::Impl::keepPlace(SessionClient& client, const protocol::KeepPlace& message) {
    const auto answer = [&](const protocol::PlaceKept& kept) {
        client.outbox.push_back(protocol::encode(kept));
        return Status();
    };
    const std::string title = plainText(message.title, kMostTitleLetters);
    if (title.empty()) return answer({{}, {}, "A place needs a name."});
    if (!world || player) return answer({{}, {}, "A take is open: close it to keep the place."});
    protocol::PlaceKept kept{title, {}, {}};
    if (def.keepScenario) {
        WorldDef place = placeNow();
        place.name = title;
        const auto entry = def.keepScenario(place);
        if (!entry.ok()) return answer({{}, {}, entry.status().message() + "."});
        kept.name = entry->name;
        keepEntry(*entry);
        name = entry->name;
        worldDef.gestures.clear();  // Its file holds none.
    }
    worldDef.name = title;
    refreshScene();
    if (def.opened) def.opened(name);
    return answer(kept);
}

void Session::Impl::keepEntry(const ScenarioEntry& entry) {
    auto& all = def.scenarios;
    const auto same = std::find_if(all.begin(), all.end(),
                                   [&](const ScenarioEntry& one) { return one.name == entry.name; });
    if (same == all.end())
        all.push_back(entry);
    else
        *same = entry;
    const MessageBytes bytes = protocol::encode(protocol::Scenarios{scenarioInfos()});
    for (auto& [id, to] : clients)
        if (to.greeted) to.outbox.push_back(bytes);
}

}  // namespace muster
