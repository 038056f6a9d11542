// A session's edits of people in the open take: what pages ask for, undo, and what is wrong with them.
#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/edits/edit_findings.h"
#include "files/take/take_edits.h"
#include "studio/session/session_state.h"
#include "studio/session/takes/edit_history.h"

namespace muster {
namespace {

TakeEdit editOf(const protocol::PeopleEdit& from) {
    TakeEdit edit;
    edit.people = from.people;
    for (const auto& pin : from.pins) edit.pins.push_back({pin.time, {pin.x, pin.y}, pin.seconds});
    for (const auto& point : from.clock) edit.clock.push_back({point.time, point.own});
    for (const auto& part : from.clips) edit.clips.push_back({part.name, part.from, part.to});
    for (const auto& look : from.looks)
        edit.looks.push_back({look.person, {look.x, look.y}, look.height, look.from, look.to});
    return edit;
}

protocol::PeopleEdit messageOf(const TakeEdit& from) {
    protocol::PeopleEdit edit;
    edit.people = from.people;
    for (const PathPin& pin : from.pins)
        edit.pins.push_back({pin.time, pin.offset.x, pin.offset.y, pin.seconds});
    for (const ClockPoint& point : from.clock) edit.clock.push_back({point.time, point.own});
    for (const ClipPart& part : from.clips) edit.clips.push_back({part.name, part.from, part.to});
    for (const LookPart& look : from.looks)
        edit.looks.push_back({look.person, look.point.x, look.point.y, look.height, look.from, look.to});
    return edit;
}

/// Where everybody went, with the bodies of those who are there now.
std::vector<RecordedPath> recordedPaths(const TakePlayer& player, const World& world) {
    const Parameters& parameters = world.parameters();
    std::vector<RecordedPath> paths = player.paths().all(parameters.stepTime);
    const CharactersView now = world.characters();
    for (RecordedPath& path : paths) {
        path.radius = parameters.character.radius;
        path.topSpeed = parameters.character.maxSpeed;
        const auto at = std::lower_bound(now.id.begin(), now.id.end(), path.person);
        if (at == now.id.end() || *at != path.person) continue;
        const Body& body = now.body[static_cast<std::size_t>(at - now.id.begin())];
        if (body.radius > 0.0) path.radius = body.radius;
        if (body.maxSpeed > 0.0) path.topSpeed = body.maxSpeed;
    }
    return paths;
}

}  // namespace

Status Session::Impl::editPeople(const protocol::EditPeople& message) {
    if (!player) return {StatusCode::Unsupported, "no take is open, so nobody's path can be changed"};
    TakeEdit edit = editOf(message.edit);
    if (Status s = checkEdits({edit}); !s.ok()) return s;
    std::vector<std::string> names;
    for (const Clip& clip : motion.library().clips) names.push_back(clip.name);
    if (Status s = checkClips({edit}, names); !s.ok()) return s;
    if (!player->preparing() && player->paths().knowsPeople())
        for (const std::uint32_t id : edit.people)
            if (!player->paths().knows(id))
                return {StatusCode::NotFound, "there is no person " + std::to_string(id) + " in the take"};
    const double spacing = kPathSpacing * world->parameters().stepTime;
    if (message.clear) keepClear(edit, recordedPaths(*player, *world), spacing, inspect::environment(*world));
    const std::vector<TakeEdit> before = player->about().edits;
    std::vector<TakeEdit> edits = withEdit(before, edit);
    if (Status s = checkEdits(edits); !s.ok()) return s;
    if (edits != before) {
        player->history().add(before, whatChanges(before, edit), message.gesture);
        showEdits(std::move(edits));
    }
    return message.kept ? keepEdits() : Status();
}

// Everybody is shown by these edits from now on, in the present moment, too.
void Session::Impl::showEdits(std::vector<TakeEdit> edits) {
    player->setEdits(std::move(edits), motion.library());
    player->showAgain(*world);
    touchEdits();
}

void Session::Impl::touchEdits() {
    ++editsRevision;
    touchState();
}

Status Session::Impl::keepEdits() {
    player->history().rest();
    if (player->fileName().empty() || !def.keepAbout) return {};
    return def.keepAbout(player->fileName(), player->about());
}

Status Session::Impl::undoTakeEdit(bool redo) {
    std::vector<TakeEdit> edits = player->about().edits;
    if (!player->history().go(redo, edits))
        return {StatusCode::NotFound, redo ? "there is nothing to do again in this take"
                                           : "there is nothing to take back in this take"};
    showEdits(std::move(edits));
    return keepEdits();
}

void Session::Impl::sendEdits(SessionClient& client) {
    if (client.sentEdits == editsRevision) return;
    client.sentEdits = editsRevision;
    protocol::TakeEdits message;
    if (player) {
        for (const TakeEdit& edit : player->about().edits) message.edits.push_back(messageOf(edit));
        message.checked = !player->preparing();
        if (message.checked) message.findings = editFindings();
        // Transitions between motions play by themselves.
        for (const Clip& clip : motion.library().clips)
            if (clip.cyclic || clip.name == clip.motion) message.clips.push_back(clip.name);
    }
    client.outbox.push_back(protocol::encode(message));
}

const std::vector<protocol::EditFinding>& Session::Impl::editFindings() {
    if (troublesFor == editsRevision) return troubles;
    troublesFor = editsRevision;
    troubles.clear();
    const double step = world->parameters().stepTime;
    const std::vector<TakeEdit>& edits = player->about().edits;
    if (edits.empty()) return troubles;
    const auto found = findTroubles(edits, recordedPaths(*player, *world), kPathSpacing * step,
                                    player->steps() * step, inspect::environment(*world));
    for (const EditFinding& one : found)
        troubles.push_back({one.person, static_cast<protocol::EditFindingKind>(one.kind), one.other, one.from,
                            one.to, one.where.x, one.where.y, one.text});
    return troubles;
}

}  // namespace muster
