#include "studio/session/history/place_editor.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "studio/session/history/place_edit.h"

namespace muster {
namespace {

constexpr std::size_t kMostSteps = 1000;       // Of a history.
constexpr std::size_t kMostBytes = 64u << 20;  // Of a history.
constexpr std::size_t kMostWaiting = 256;      // Edits.
constexpr std::size_t kMostLabel = 80;         // [bytes]

/// True where two edits are about the same thing and have to follow each other.
bool collide(const Thing& a, const Thing& b) {
    return a.id != 0 && a == b;
}

/// The steps that take this one back.
PlaceStep reversed(PlaceStep step) {
    std::reverse(step.changes.begin(), step.changes.end());
    for (PlaceChange& change : step.changes) std::swap(change.redo, change.undo);
    std::reverse(step.crowdChanges.begin(), step.crowdChanges.end());
    for (CrowdChange& crowdChange : step.crowdChanges) crowdChange = reversed(std::move(crowdChange));
    return step;
}

/// Things that a step is about.
std::vector<Thing> thingsOf(const PlaceStep& step) {
    std::vector<Thing> things;
    for (const PlaceChange& change : step.changes) things.push_back(change.thing);
    for (const CrowdChange& crowdChange : step.crowdChanges) {
        if (const auto* queue = std::get_if<QueueChange>(&crowdChange))
            things.push_back({ThingKind::Group, queue->group.value});
        if (const auto* division = std::get_if<DivisionChange>(&crowdChange)) {
            things.push_back({ThingKind::Group, division->whole.id.value});
            for (const PartState& part : division->parts) things.push_back({ThingKind::Group, part.id.value});
        }
    }
    return things;
}

std::size_t bytesOf(const PlaceStep& step) {
    std::size_t bytes = 0;
    for (const PlaceChange& change : step.changes) bytes += bytesOf(change.redo) + bytesOf(change.undo);
    for (const CrowdChange& crowdChange : step.crowdChanges) bytes += bytesOf(crowdChange);
    return bytes;
}

void push(std::deque<PlaceStep>& steps, PlaceStep step) {
    step.bytes = bytesOf(step);
    steps.push_back(std::move(step));
    std::size_t bytes = 0;
    for (const PlaceStep& one : steps) bytes += one.bytes;
    while (steps.size() > kMostSteps || (bytes > kMostBytes && steps.size() > 1)) {
        bytes -= steps.front().bytes;
        steps.pop_front();
    }
}

/// The thing has been made and has that id, by which it is taken away.
void nameThing(PlaceChange& change, std::uint32_t id) {
    rename(change.undo, {change.thing.kind, 0}, id);
    change.thing.id = id;
}

}  // namespace

void PlaceEditor::forget(std::uint32_t client) {
    histories_.erase(client);
    std::erase_if(acts_, [&](const Given& act) { return act.client == client; });
    std::erase_if(waiting_, [&](const Waiting& one) { return one.client == client; });
}

void PlaceEditor::begin(const WorldDef& def) {
    place_.begin(def);
    histories_.clear();
    waiting_.clear();
    acts_.clear();
    planned_.clear();
    ++revision_;
}

/// Ids in the histories of things that the place lacks. They may come back, and other things get such ids
/// now.
std::vector<std::uint32_t> PlaceEditor::goneThings(ThingKind kind, const std::vector<std::uint32_t>& ids) {
    std::vector<std::uint32_t> gone;
    eachStep([&](const PlaceStep& step) {
        for (const PlaceChange& change : step.changes) {
            const Thing thing = change.thing;
            if (thing.kind != kind || thing.id == 0 || thing.id > kGoneThings) continue;
            const auto holds = [&](const std::vector<std::uint32_t>& list) {
                return std::find(list.begin(), list.end(), thing.id) != list.end();
            };
            if (!holds(ids) && !holds(gone)) gone.push_back(thing.id);
        }
    });
    return gone;
}

void PlaceEditor::beginAgain(const PlaceDefinition& before) {
    // New ids are first set apart, because old and new ones overlap.
    constexpr std::uint32_t kApart = 0x80000000u;
    const auto renumber = [&](ThingKind kind, const std::vector<std::uint32_t>& ids) {
        for (const std::uint32_t gone : goneThings(kind, ids)) renameEverywhere({kind, gone}, ++lastGone_);
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
    renumber(ThingKind::Area, before.areas);
    place_.beginAgain(before);
    waiting_.clear();
    acts_.clear();
    planned_.clear();
    // What was done to groups is undone by the new beginning.
    for (auto& [client, history] : histories_)
        for (std::deque<PlaceStep>* steps : {&history.done, &history.undone})
            std::erase_if(*steps, [](const PlaceStep& step) { return step.directs; });
    ++revision_;
}

Status PlaceEditor::want(std::uint32_t client, std::string label, std::uint32_t gesture,
                         std::vector<CommandBody> bodies) {
    if (bodies.empty()) return invalidArgument("found no event, expected at least one");
    if (label.size() > kMostLabel)
        return invalidArgument("found a label of " + std::to_string(label.size()) +
                               " bytes, expected at most " + std::to_string(kMostLabel));
    Waiting waiting;
    waiting.client = client;
    waiting.step.label = std::move(label);
    waiting.step.gesture = gesture;
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
    if (last != waiting_.rend() && wanted.way == Given::Way::Do && last->way == Given::Way::Do &&
        wanted.step.gesture != 0 && last->step.gesture == wanted.step.gesture &&
        overtakes(wanted.step.changes, last->step.changes)) {
        last->step = std::move(wanted.step);
        return {};
    }
    if (waiting_.size() >= kMostWaiting)
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(kMostWaiting) + " edits wait for the next step"};
    wanted.arrival = ++lastArrival_;
    wanted.behindAct = std::any_of(acts_.begin(), acts_.end(),
                                   [&](const Given& act) { return act.client == wanted.client; });
    waiting_.push_back(std::move(wanted));
    ++revision_;
    return {};
}

// The history as it will be: what is known to come counts at once, also while the world is paused.
PlaceEditor::Foreseen PlaceEditor::foresee(std::uint32_t client) const {
    struct Coming {
        std::uint32_t arrival;
        Given::Way way;
        const PlaceStep* step;
        bool fetched;
    };
    std::vector<Coming> coming;
    for (const Given& act : acts_)
        if (act.client == client) coming.push_back({act.arrival, Given::Way::Do, &act.step, false});
    for (const Waiting& one : waiting_)
        if (one.client == client && one.way != Given::Way::Follow)
            coming.push_back({one.arrival, one.way, &one.step, one.fetched});
    std::sort(coming.begin(), coming.end(),
              [](const Coming& a, const Coming& b) { return a.arrival < b.arrival; });
    Foreseen foreseen;
    auto& [done, undone] = foreseen;
    if (const auto found = histories_.find(client); found != histories_.end()) {
        for (const PlaceStep& step : found->second.done) done.push_back(&step);
        for (const PlaceStep& step : found->second.undone) undone.push_back(&step);
    }
    for (const Coming& one : coming) {
        if (one.way == Given::Way::Do) {
            undone.clear();
            const bool joins = !done.empty() &&
                               (joinsAct(*done.back(), *one.step) ||
                                (one.step->gesture != 0 && done.back()->gesture == one.step->gesture));
            if (!joins) done.push_back(one.step);
            continue;
        }
        auto [from, to] = one.way == Given::Way::Undo ? std::tie(done, undone) : std::tie(undone, done);
        to.push_back(one.fetched || from.empty() ? one.step : from.back());
        if (!one.fetched && !from.empty()) from.pop_back();
    }
    return foreseen;
}

bool PlaceEditor::nextDirects(std::uint32_t client, bool redo) const {
    const Foreseen foreseen = foresee(client);
    const auto& steps = redo ? foreseen.undone : foreseen.done;
    return !steps.empty() && steps.back()->directs;
}

Status PlaceEditor::wantUndo(std::uint32_t client, bool redo) {
    const Foreseen foreseen = foresee(client);
    if ((redo ? foreseen.undone : foreseen.done).empty())
        return {StatusCode::NotFound, redo ? "nothing to do again" : "nothing to take back"};
    Waiting waiting;
    waiting.client = client;
    waiting.way = redo ? Given::Way::Redo : Given::Way::Undo;
    return wait(std::move(waiting));
}

// Puts what takes the changes back, as the world is now.
void PlaceEditor::complete(PlaceStep& step, const World& world) const {
    if (step.directs)  // Others have ended what it was about.
        std::erase_if(step.changes, [&](const PlaceChange& change) {
            return !adds(change.redo) && !inverseOf(change.redo, world, place_);
        });
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

/// True where the step has to wait for another one about the same things.
bool PlaceEditor::keepsWaiting(const Waiting& waiting, const std::vector<Thing>& touched) const {
    const std::vector<Thing> things = thingsOf(waiting.step);
    const auto met = [&](const std::vector<Thing>& others) {
        return std::any_of(things.begin(), things.end(), [&](const Thing& thing) {
            return std::any_of(others.begin(), others.end(),
                               [&](const Thing& other) { return collide(thing, other); });
        });
    };
    if (met(touched)) return true;
    return waiting.step.directs &&
           std::any_of(acts_.begin(), acts_.end(), [&](const Given& act) { return met(thingsOf(act.step)); });
}

/// Makes the commands of a step that has been fetched. False where nothing of it is left to do.
bool PlaceEditor::ready(Waiting& waiting, Given& given, const World& world) {
    complete(waiting.step, world);
    given.client = waiting.client;
    given.way = waiting.way;
    given.arrival = waiting.arrival;
    given.crowdChanges = std::move(waiting.commands);
    for (CrowdChange& crowdChange : waiting.step.crowdChanges)
        commandsOf(crowdChange, world, given.crowdChanges);
    given.step = std::move(waiting.step);
    return !given.step.changes.empty() || !given.crowdChanges.bodies.empty();
}

std::vector<PlaceEditor::Given> PlaceEditor::due(const World& world) {
    std::vector<Given> given;
    std::vector<Thing> touched;
    std::vector<std::uint32_t> busy;  // One step of each director's history at a time.
    for (auto next = waiting_.begin(); next != waiting_.end();) {
        if (std::find(busy.begin(), busy.end(), next->client) != busy.end()) {
            ++next;
            continue;
        }
        if (!next->behindAct && !next->fetched && !fetch(*next)) {
            next = waiting_.erase(next);
            continue;
        }
        const bool waits = next->behindAct || keepsWaiting(*next, touched);
        for (const Thing& thing : thingsOf(next->step)) touched.push_back(thing);
        if (waits) {
            busy.push_back(next->client);
            ++next;
            continue;
        }
        Given one;
        if (!ready(*next, one, world)) {  // Then the one before is taken back.
            next->fetched = false;
            next->step = {};
            ++revision_;
            continue;
        }
        busy.push_back(next->client);
        given.push_back(std::move(one));
        next = waiting_.erase(next);
    }
    if (!given.empty() && acts_.empty()) highest_ = highestIds(world);
    return given;
}

void PlaceEditor::carriedOut(std::vector<Given> given, const World& world) {
    for (Given& act : acts_) given.push_back(std::move(act));
    acts_.clear();
    planned_.clear();
    std::sort(given.begin(), given.end(), [](const Given& a, const Given& b) {
        return a.client != b.client ? a.client < b.client : a.arrival < b.arrival;
    });
    nameOrders(given, world);
    std::vector<Event> added(world.events().begin(), world.events().end());
    for (Given& one : given) {
        std::vector<PlaceChange> accepted;
        for (std::size_t k = 0; k < one.step.changes.size() && k < one.sequences.size(); ++k)
            if (!isRefused(one, one.sequences[k], world)) accepted.push_back(std::move(one.step.changes[k]));
        one.step.changes = std::move(accepted);
        for (PlaceChange& change : one.step.changes) {
            if (adds(change.redo)) {
                std::uint32_t& highest = highest_[static_cast<std::size_t>(change.thing.kind)];
                const std::uint32_t id = addedId(change.redo, world, highest);
                highest = std::max(highest, id);
                if (change.thing.id != 0) renameEverywhere(change.thing, id);
                nameThing(change, id);
            }
            if (!one.step.directs) place_.apply(change.redo, world);
        }
        finishCrowdChanges(one, added, world);
        if (one.way != Given::Way::Follow && (!one.step.changes.empty() || !one.step.crowdChanges.empty()))
            keep(one);
        ++revision_;
    }
    for (Waiting& waiting : waiting_) waiting.behindAct = false;
}

void PlaceEditor::keep(Given& given) {
    History& history = histories_[given.client];
    if (given.way == Given::Way::Undo) return push(history.undone, reversed(std::move(given.step)));
    if (given.way == Given::Way::Redo) return push(history.done, std::move(given.step));
    history.undone.clear();
    const bool joins = !history.done.empty() &&
                       (joinsAct(history.done.back(), given.step) ||
                        (given.step.gesture != 0 && history.done.back().gesture == given.step.gesture));
    if (!joins) return push(history.done, std::move(given.step));
    history.done.back().step = given.step.step;
    join(history.done.back(), std::move(given.step.changes));
    if (history.done.back().changes.empty()) history.done.pop_back();
}

void PlaceEditor::renameEverywhere(Thing from, std::uint32_t to) {
    if (from.id == 0 || from.id == to) return;
    eachStep([&](PlaceStep& step) {
        for (PlaceChange& change : step.changes) {
            rename(change.redo, from, to);
            rename(change.undo, from, to);
            if (change.thing == from) change.thing.id = to;
        }
        if (from.kind != ThingKind::Group) return;
        for (CrowdChange& crowdChange : step.crowdChanges)
            renameGroup(crowdChange, GroupId{from.id}, GroupId{to});
    });
}

bool PlaceEditor::undoWaits(std::uint32_t client) const {
    return std::any_of(waiting_.begin(), waiting_.end(), [&](const Waiting& one) {
        return one.client == client && (one.way == Given::Way::Undo || one.way == Given::Way::Redo);
    });
}

protocol::EditHistory PlaceEditor::state(std::uint32_t client) const {
    protocol::EditHistory state;
    state.edited = place_.edited();
    const auto [done, undone] = foresee(client);
    state.undo = static_cast<std::uint32_t>(done.size());
    state.redo = static_cast<std::uint32_t>(undone.size());
    if (!done.empty()) state.undoLabel = done.back()->label;
    if (!undone.empty()) state.redoLabel = undone.back()->label;
    return state;
}

}  // namespace muster
