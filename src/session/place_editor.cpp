#include "session/place_editor.h"

#include <algorithm>
#include <utility>

#include "session/place_join.h"

namespace muster {
namespace {

constexpr std::size_t kMostSteps = 1000;   // Of a history.
constexpr std::size_t kMostWaiting = 256;  // Edits.
constexpr std::size_t kMostLabel = 80;     // [bytes]

/// True where two edits are about the same thing and have to follow each other.
bool collide(const Thing& a, const Thing& b) {
    return a.id != 0 && a == b;
}

/// The steps that take this one back.
PlaceStep reversed(PlaceStep step) {
    std::reverse(step.changes.begin(), step.changes.end());
    for (PlaceChange& change : step.changes) std::swap(change.redo, change.undo);
    return step;
}

void push(std::deque<PlaceStep>& steps, PlaceStep step) {
    steps.push_back(std::move(step));
    if (steps.size() > kMostSteps) steps.pop_front();
}

/// The thing has been made and has that id, by which it is taken away.
void nameThing(PlaceChange& change, std::uint32_t id) {
    rename(change.undo, {change.thing.kind, 0}, id);
    change.thing.id = id;
}

}  // namespace

void PlaceEditor::begin(const WorldDef& def) {
    place_.begin(def);
    histories_.clear();
    waiting_.clear();
    ++revision_;
}

void PlaceEditor::beginAgain(const PlaceDefinition& before) {
    // New ids are first set apart, because old and new ones overlap.
    constexpr std::uint32_t kApart = 0x80000000u;
    const auto renumber = [&](ThingKind kind, const std::vector<std::uint32_t>& ids) {
        for (std::size_t k = 0; k < ids.size(); ++k)
            renameEverywhere({kind, ids[k]}, kApart + static_cast<std::uint32_t>(k + 1));
        for (std::size_t k = 0; k < ids.size(); ++k)
            renameEverywhere({kind, kApart + static_cast<std::uint32_t>(k + 1)},
                             static_cast<std::uint32_t>(k + 1));
    };
    renumber(ThingKind::Obstacle, before.obstacles);
    renumber(ThingKind::Patch, before.patches);
    renumber(ThingKind::Item, before.items);
    renumber(ThingKind::Checkpoint, before.checkpoints);
    renumber(ThingKind::Group, before.groups);
    place_.beginAgain();
    waiting_.clear();
    ++revision_;
}

Status PlaceEditor::want(std::uint32_t client, std::string label, std::uint32_t gesture,
                         std::vector<CommandBody> bodies) {
    if (bodies.empty()) return invalidArgument("found no event, expected at least one");
    if (label.size() > kMostLabel)
        return invalidArgument("found a label of " + std::to_string(label.size()) +
                               " bytes, expected at most " + std::to_string(kMostLabel));
    Waiting waiting{client, Given::Way::Do, {std::move(label), gesture, {}}, false};
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const std::string where = "edit: $[" + std::to_string(k) + "]: ";
        const auto thing = thingOf(bodies[k]);
        if (!thing)
            return invalidArgument(where + "found a command of another kind, expected a change of the place");
        for (const PlaceChange& change : waiting.step.changes)
            if (collide(*thing, change.thing) && change.redo.index() == bodies[k].index())
                return invalidArgument(where + "found a thing that was named before, expected each once");
        waiting.step.changes.push_back({*thing, std::move(bodies[k]), {}});
    }
    return wait(std::move(waiting));
}

// A drag that is faster than the world leaves out what it has passed in the meantime.
Status PlaceEditor::wait(Waiting wanted) {
    const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [&](const Waiting& one) { return one.client == wanted.client; });
    if (last != waiting_.rend() && last->way == Given::Way::Do && wanted.step.gesture != 0 &&
        last->step.gesture == wanted.step.gesture && overtakes(wanted.step.changes, last->step.changes)) {
        last->step = std::move(wanted.step);
        return {};
    }
    if (waiting_.size() >= kMostWaiting)
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(kMostWaiting) + " edits wait for the next step"};
    waiting_.push_back(std::move(wanted));
    return {};
}

Status PlaceEditor::wantUndo(std::uint32_t client, bool redo) {
    const protocol::EditHistory now = state(client);
    std::int64_t left = redo ? now.redo : now.undo;
    for (const Waiting& one : waiting_) {
        if (one.client != client) continue;
        if (one.way == Given::Way::Do) left = redo ? 0 : left + 1;
        if (one.way == Given::Way::Undo) left += redo ? 1 : -1;
        if (one.way == Given::Way::Redo) left += redo ? -1 : 1;
    }
    if (left <= 0) return {StatusCode::NotFound, redo ? "nothing to do again" : "nothing to take back"};
    if (waiting_.size() >= kMostWaiting)
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(kMostWaiting) + " edits wait for the next step"};
    waiting_.push_back({client, redo ? Given::Way::Redo : Given::Way::Undo, {}, false});
    return {};
}

// Puts what takes the changes back, as the world is now.
void PlaceEditor::complete(PlaceStep& step, const World& world) const {
    for (PlaceChange& change : step.changes) {
        const auto undo = inverseOf(change.redo, world, place_);
        change.undo = undo ? *undo : change.redo;  // The world refuses to change what is gone.
    }
}

// Takes the step that a director takes back, or does again, out of the history. False where there is none.
bool PlaceEditor::fetch(Waiting& waiting) {
    if (waiting.way == Given::Way::Do) return true;
    History& history = histories_[waiting.client];
    std::deque<PlaceStep>& from = waiting.way == Given::Way::Undo ? history.done : history.undone;
    if (from.empty()) return false;
    waiting.step = waiting.way == Given::Way::Undo ? reversed(std::move(from.back()))
                                                   : std::move(from.back());
    from.pop_back();
    waiting.fetched = true;
    return true;
}

std::vector<PlaceEditor::Given> PlaceEditor::due(const World& world) {
    std::vector<Given> given;
    std::vector<Thing> touched;
    while (!waiting_.empty()) {
        Waiting& next = waiting_.front();
        // One step of each director's history at a time.
        if (std::any_of(given.begin(), given.end(),
                        [&](const Given& one) { return one.client == next.client; }))
            break;
        if (!next.fetched && !fetch(next)) {
            waiting_.pop_front();
            continue;
        }
        const std::vector<PlaceChange>& changes = next.step.changes;
        if (std::any_of(changes.begin(), changes.end(), [&](const PlaceChange& change) {
                return std::any_of(touched.begin(), touched.end(),
                                   [&](const Thing& thing) { return collide(thing, change.thing); });
            }))
            break;
        for (const PlaceChange& change : changes) touched.push_back(change.thing);
        complete(next.step, world);
        given.push_back({next.client, std::move(next.step), {}, next.way});
        waiting_.pop_front();
    }
    if (!given.empty()) highest_ = highestIds(world);
    return given;
}

void PlaceEditor::carriedOut(std::vector<Given> given, const World& world) {
    std::sort(given.begin(), given.end(), [](const Given& a, const Given& b) { return a.client < b.client; });
    for (Given& one : given) {
        std::vector<PlaceChange> accepted;
        for (std::size_t k = 0; k < one.step.changes.size() && k < one.sequences.size(); ++k) {
            const bool refused = std::any_of(world.rejections().begin(), world.rejections().end(),
                                             [&](const Rejection& rejection) {
                                                 return rejection.command.client == one.client &&
                                                        rejection.command.sequence == one.sequences[k];
                                             });
            if (!refused) accepted.push_back(std::move(one.step.changes[k]));
        }
        one.step.changes = std::move(accepted);
        for (PlaceChange& change : one.step.changes) {
            if (adds(change.redo)) {
                std::uint32_t& highest = highest_[static_cast<std::size_t>(change.thing.kind)];
                const std::uint32_t id = addedId(change.redo, world, highest);
                highest = std::max(highest, id);
                if (change.thing.id != 0) renameEverywhere(change.thing, id);
                nameThing(change, id);
            }
            place_.apply(change.redo, world);
        }
        if (!one.step.changes.empty()) keep(one);
        ++revision_;
    }
}

void PlaceEditor::keep(Given& given) {
    History& history = histories_[given.client];
    if (given.way == Given::Way::Undo) return push(history.undone, reversed(std::move(given.step)));
    if (given.way == Given::Way::Redo) return push(history.done, std::move(given.step));
    history.undone.clear();
    const bool joins = given.step.gesture != 0 && !history.done.empty() &&
                       history.done.back().gesture == given.step.gesture;
    if (!joins) return push(history.done, std::move(given.step));
    join(history.done.back(), std::move(given.step.changes));
    if (history.done.back().changes.empty()) history.done.pop_back();
}

void PlaceEditor::renameEverywhere(Thing from, std::uint32_t to) {
    if (from.id == 0 || from.id == to) return;
    const auto in = [&](std::deque<PlaceStep>& steps) {
        for (PlaceStep& step : steps) {
            for (PlaceChange& change : step.changes) {
                rename(change.redo, from, to);
                rename(change.undo, from, to);
                if (change.thing == from) change.thing.id = to;
            }
        }
    };
    for (auto& [client, history] : histories_) {
        in(history.done);
        in(history.undone);
    }
    for (Waiting& waiting : waiting_) {
        for (PlaceChange& change : waiting.step.changes) {
            rename(change.redo, from, to);
            if (change.thing == from) change.thing.id = to;
        }
    }
}

protocol::EditHistory PlaceEditor::state(std::uint32_t client) const {
    protocol::EditHistory state;
    state.edited = place_.edited();
    const auto found = histories_.find(client);
    if (found == histories_.end()) return state;
    const auto& [done, undone] = found->second;
    state.undo = static_cast<std::uint32_t>(done.size());
    state.redo = static_cast<std::uint32_t>(undone.size());
    if (!done.empty()) state.undoLabel = done.back().label;
    if (!undone.empty()) state.redoLabel = undone.back().label;
    return state;
}

}  // namespace muster
