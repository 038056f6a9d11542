// A session's place: edits by directors, undo, and its file.
#include <algorithm>

#include "muster/scenario.h"
#include "studio/session/history/group_body.h"
#include "studio/session/history/place_editor.h"
#include "studio/session/inbox/received_commands.h"
#include "studio/session/session_state.h"

namespace muster {
namespace {

constexpr std::int32_t kMostEditSteps = 60;  // Steps that wait while paused.

/// A name for files, of letters, digits, - and _.
std::string fileStem(const std::string& name, const char* otherwise) {
    std::string stem = name.substr(name.find_last_of('/') + 1);
    std::erase_if(stem, [](char c) {
        const bool known = (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
        return !known && c != '-' && c != '_';
    });
    return stem.empty() ? otherwise : stem;
}

}  // namespace

Status Session::openScenario(const std::string& name, std::string_view text, std::uint32_t director) {
    const std::string stem = fileStem(name, "place");
    auto def = parseScenario(text, stem + ".json", "");
    if (!def.ok()) return def.status();
    def->gestures.clear();  // Its file lies elsewhere.
    return impl_->beginFor(impl_->idOf(director), protocol::WorldChange::Opened,
                           [&] { return impl_->begin(stem, *def); });
}

Result<std::string> Session::scenario() const {
    if (!impl_->world) return Status(StatusCode::NotFound, "there is no world yet");
    return writeScenario(impl_->placeNow());
}

WorldDef Session::Impl::placeNow() const {
    WorldDef now = worldDef;
    if (!player && editor.place().edited()) now = editor.place().definition(worldDef, *world).def;
    now.gestures.clear();
    return now;
}

std::string Session::scenarioName() const {
    return fileStem(impl_->name, "place") + ".json";
}

// The same place from its start, with all edits.
Status Session::Impl::beginAgain() {
    if (!editor.place().edited()) return begin(name, worldDef);
    const PlaceDefinition again = editor.place().definition(worldDef, *world);
    PlaceEditor kept = editor;
    if (Status s = begin(name, again.def); !s.ok()) return s;
    editor = std::move(kept);
    editor.beginAgain(again);
    return {};
}

Status Session::Impl::edit(SessionClient& client, const protocol::Edit& message) {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (player)
        return {StatusCode::Unsupported, "a take is being replayed; load a scenario to edit its place"};
    if (!message.bodies.empty() && !message.commands.empty())
        return invalidArgument("found commands and bodies of groups, expected only one of them");
    auto bodies = message.bodies.empty() ? readEdits(message.commands, def.limits)
                                         : bodiesOf(message.bodies, *world);
    if (!bodies.ok()) return bodies.status();
    for (CommandBody& body : *bodies) {
        const Command command{world->stepCount(), client.number, 0, body};
        if (Status valid = validateCommand(command); !valid.ok()) return valid;
        if (Status mine = directors.admit(client.number, body); !mine.ok()) return mine;
    }
    const std::size_t waiting = editor.waiting();
    if (Status s = editor.want(client.number, message.label, message.gesture, std::move(bodies).value());
        !s.ok())
        return s;
    if (!playing && editor.waiting() > waiting) singleSteps = std::min(singleSteps + 1, kMostEditSteps);
    return {};
}

Status Session::Impl::undoEdit(SessionClient& client, bool redo) {
    if (!world) return {StatusCode::NotFound, "there is no world yet"};
    if (player) return undoTakeEdit(redo);
    // Orders of a paused world wait for its next step, and so does what takes them back.
    const bool steps = !editor.nextDirects(client.number, redo);
    if (Status s = editor.wantUndo(client.number, redo); !s.ok()) return s;
    if (!playing && steps) singleSteps = std::min(singleSteps + 1, kMostEditSteps);
    return {};
}

// Edits become commands of their directors in the step that is about to be made.
void Session::Impl::submitEdits() {
    givenEdits = editor.due(*world);
    std::erase_if(givenEdits, [&](PlaceEditor::Given& given) {
        SessionClient* const found = clientOf(given.client);
        if (found == nullptr) return true;
        SessionClient& client = *found;
        std::vector<CommandBody> bodies = given.batch.bodies;
        const std::uint32_t before = client.sequence;
        if (const Status status = submit(client, bodies, false); !status.ok()) {
            notice(client, protocol::NoticeLevel::Error, "Edit", status.message());
            return true;
        }
        for (std::uint32_t s = before + 1; s <= client.sequence; ++s) given.sequences.push_back(s);
        return false;
    });
}

// Commands that direct groups are given at once, and remembered so that they can be taken back.
Status Session::Impl::act(SessionClient& client, std::vector<CommandBody> bodies) {
    const std::uint32_t before = client.sequence;
    for (CommandBody& body : bodies)  // It tells fingers which group they hold.
        if (Status mine = directors.admit(client.number, body); !mine.ok()) return mine;
    const std::vector<CommandBody> kept = bodies;
    Status status = submit(client, bodies);
    if (status.ok()) editor.acted(client.number, kept, before + 1, *world);
    return status;
}

void Session::Impl::editsCarriedOut() {
    if (!givenEdits.empty() || editor.acts()) {
        const bool edits = std::any_of(givenEdits.begin(), givenEdits.end(),
                                       [](const PlaceEditor::Given& given) { return !given.step.directs; });
        editor.carriedOut(std::move(givenEdits), *world);
        givenEdits.clear();
        if (edits) refreshScene();
    }
    if (!playing && editor.waits()) singleSteps = std::max(singleSteps, 1);
}

void Session::Impl::sendHistory(SessionClient& client) {
    const std::uint32_t revision = editor.revision() + editsRevision;
    if (client.sentHistory == revision) return;
    // What comes of it is known soon: the step may pass over what nothing is left of.
    if (playing && editor.undoWaits(client.number)) return;
    const bool first = client.sentHistory == 0;
    client.sentHistory = revision;
    const protocol::EditHistory history = player ? player->history().state() : editor.state(client.number);
    if (first && !history.edited && history.undo == 0 && history.redo == 0)
        return;  // A client takes for granted that there is nothing.
    client.outbox.push_back(protocol::encode(history));
}

}  // namespace muster
