#include "studio/session/history/place_editor.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include "studio/session/history/group_fields.h"
#include "studio/session/inbox/generated/command_traits.h"

namespace muster {
namespace {

constexpr std::size_t kMostWaiting = 256;  // Edits.
constexpr std::size_t kMostLabel = 80;     // [bytes]

/// The properties that a command sets, of things that are there.
std::vector<PartKey> keysOf(const CommandBody& body, Names& names) {
    std::vector<PartKey> keys;
    for (const CommandBody& single : singleFields(body))
        if (const PartKey key = keyOf(single, names); key.subject.name != 0) keys.push_back(key);
    return keys;
}

/// True where both do the same to the same thing, so that the later one stands for both.
bool doesTheSame(const CommandBody& a, const CommandBody& b, Names& names) {
    if (a.index() != b.index()) return false;
    if (const auto* bodies = std::get_if<ChangeCharacters>(&a))
        return bodies->ids == std::get<ChangeCharacters>(b).ids;
    const std::vector<PartKey> keys = keysOf(a, names);
    return !keys.empty() && keys == keysOf(b, names);
}

/// True where the one that waits need not be carried out, because the later one stands for it.
bool overtakes(const std::vector<CommandBody>& later, const std::vector<CommandBody>& waiting, Names& names) {
    return std::equal(later.begin(), later.end(), waiting.begin(), waiting.end(),
                      [&](const CommandBody& a, const CommandBody& b) { return doesTheSame(a, b, names); });
}

/// True where others are about to change the same things.
bool isBusy(const std::vector<Subject>& things, const std::vector<Subject>& touched) {
    return std::any_of(things.begin(), things.end(), [&](const Subject& thing) {
        return std::find(touched.begin(), touched.end(), thing) != touched.end();
    });
}

/// Groups that are not there come back as the place has them.
void startAgain(Difference& difference) {
    difference.queues.clear();
    // Numbers of people follow from who comes and leaves, but these are others now.
    for (std::size_t k = 0, count = difference.parts.size(); k < count; ++k) {
        PartChange counted = difference.parts[k];
        if (counted.key.subject.kind != SubjectKind::Start || !counted.before ||
            !changesField(*counted.before, &ChangeGroup::count))
            continue;
        counted.key.subject.kind = SubjectKind::Group;
        difference.parts.push_back(std::move(counted));
    }
    for (Crew& crew : difference.crews) {
        crew.characters.clear();
        for (PartChange& part : difference.parts) {
            if (!crew.start || !(part.key.subject == Subject{SubjectKind::Group, crew.group})) continue;
            for (auto* said : {&part.before, &part.after})
                if (*said && std::holds_alternative<AddGroup>(**said)) *said = AddGroup{*crew.start};
        }
    }
}

}  // namespace

void PlaceEditor::forget(std::uint32_t client) {
    histories_.erase(client);
    drags_.forget(client);
    std::erase_if(acts_, [&](const Given& act) { return act.client == client; });
    std::erase_if(waiting_, [&](const Waiting& one) { return one.client == client; });
}

void PlaceEditor::begin(const WorldDef& def) {
    place_.begin(def);
    names_.clear();
    histories_.clear();
    waiting_.clear();
    acts_.clear();
    record_.clear();
    births_.clear();
    drags_.clear();
    ++revision_;
}

void PlaceEditor::beginAgain(const PlaceDefinition& before) {
    std::vector<std::uint32_t> characters;
    for (const std::uint32_t id : before.characters)
        characters.push_back(names_.nameOf(SubjectKind::Character, id));
    std::sort(characters.begin(), characters.end());
    // What was done to groups is undone by the new beginning.
    for (auto& [client, history] : histories_) {
        for (std::deque<HistoryStep>* steps : {&history.done, &history.undone}) {
            std::erase_if(*steps, [](const HistoryStep& step) { return step.directs; });
            for (HistoryStep& step : *steps) {
                startAgain(step.difference);
                std::erase_if(step.difference.members, [&](const MemberChange& member) {
                    return member.before.group != member.after.group ||
                           !std::binary_search(characters.begin(), characters.end(), member.character);
                });
            }
        }
    }
    names_.renumber(SubjectKind::Obstacle, before.obstacles);
    names_.renumber(SubjectKind::Patch, before.patches);
    names_.renumber(SubjectKind::Item, before.items);
    names_.renumber(SubjectKind::Checkpoint, before.checkpoints);
    names_.renumber(SubjectKind::Group, before.groups);
    names_.renumber(SubjectKind::Area, before.areas);
    names_.renumber(SubjectKind::Character, before.characters);
    place_.beginAgain(before);
    waiting_.clear();
    acts_.clear();
    record_.clear();
    births_.clear();
    drags_.clear();
    ++revision_;
}

Status PlaceEditor::want(std::uint32_t client, std::string label, std::uint32_t gesture,
                         std::vector<CommandBody> bodies) {
    if (bodies.empty()) return invalidArgument("found no event, expected at least one");
    if (label.size() > kMostLabel)
        return invalidArgument("found a label of " + std::to_string(label.size()) +
                               " bytes, expected at most " + std::to_string(kMostLabel));
    for (std::size_t k = 0; k < bodies.size(); ++k) {
        const std::string where = "edit: $[" + std::to_string(k) + "]: ";
        if (!traitsOf(bodies[k]).edits)
            return invalidArgument(where + "found a command of another kind, expected a change of the place");
        for (std::size_t other = 0; other < k; ++other)
            if (!std::holds_alternative<ChangeCharacters>(bodies[k]) &&
                !std::holds_alternative<SetParameter>(bodies[k]) &&
                doesTheSame(bodies[k], bodies[other], names_))
                return invalidArgument(where + "found a thing that was named before, expected each once");
    }
    Waiting waiting;
    waiting.client = client;
    waiting.step.label = std::move(label);
    waiting.step.gesture = gesture;
    waiting.bodies = std::move(bodies);
    return wait(std::move(waiting));
}

// A drag that is faster than the world leaves out what it has passed in the meantime.
Status PlaceEditor::wait(Waiting wanted) {
    const auto last = std::find_if(waiting_.rbegin(), waiting_.rend(),
                                   [&](const Waiting& one) { return one.client == wanted.client; });
    if (last != waiting_.rend() && wanted.way == Given::Way::Do && last->way == Given::Way::Do &&
        wanted.step.gesture != 0 && last->step.gesture == wanted.step.gesture &&
        overtakes(wanted.bodies, last->bodies, names_)) {
        last->step = std::move(wanted.step);
        last->bodies = std::move(wanted.bodies);
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
        const HistoryStep* step;
        bool fetched;
    };
    std::vector<Coming> coming;
    for (const Given& act : acts_)
        if (act.client == client && (act.drag == 0 || act.endsDrag))
            coming.push_back({act.arrival, Given::Way::Do, &act.step, false});
    for (const Waiting& one : waiting_)
        if (one.client == client && one.way != Given::Way::Follow)
            coming.push_back({one.arrival, one.way, &one.step, one.fetched});
    std::sort(coming.begin(), coming.end(),
              [](const Coming& a, const Coming& b) { return a.arrival < b.arrival; });
    Foreseen foreseen;
    auto& [done, undone] = foreseen;
    if (const auto found = histories_.find(client); found != histories_.end()) {
        for (const HistoryStep& step : found->second.done) done.push_back(&step);
        for (const HistoryStep& step : found->second.undone) undone.push_back(&step);
    }
    for (const Coming& one : coming) {
        if (one.way == Given::Way::Do) {
            undone.clear();
            if (done.empty() || !joins(*done.back(), *one.step)) done.push_back(one.step);
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

// Takes the step that a director takes back, or does again, out of the history. False where there is none.
bool PlaceEditor::fetch(Waiting& waiting) {
    if (waiting.way == Given::Way::Do) return true;
    History& history = histories_[waiting.client];
    std::deque<HistoryStep>& from = waiting.way == Given::Way::Undo ? history.done : history.undone;
    if (from.empty()) return false;
    waiting.step = std::move(from.back());
    from.pop_back();
    waiting.fetched = true;
    return true;
}

std::vector<Subject> PlaceEditor::subjectsOf(const std::vector<CommandBody>& bodies,
                                             const std::vector<Concern>& concerns) {
    std::vector<Subject> things;
    const auto put = [&](const CommandBody& body) {
        for (const PartKey& key : keysOf(body, names_)) things.push_back(key.subject);
    };
    for (const CommandBody& body : bodies) put(body);
    for (const Concern& concern : concerns)
        for (const Concern::Part& part : concern.parts) put(part.asked);
    return things;
}

std::vector<Subject> PlaceEditor::subjectsOf(const Waiting& waiting) {
    return waiting.way == Given::Way::Do ? subjectsOf(waiting.bodies, {})
                                         : muster::subjectsOf(waiting.step.difference);
}

// What others have done since the step does not begin from it any more.
void PlaceEditor::takeOutOfOthers(std::uint32_t client, HistoryStep& step) {
    std::vector<HistoryStep*> later;
    for (auto& [other, history] : histories_)
        for (HistoryStep& one : history.done)
            if (other != client && one.arrival > step.arrival) later.push_back(&one);
    std::sort(later.begin(), later.end(),
              [](const HistoryStep* a, const HistoryStep* b) { return a->arrival < b->arrival; });
    for (HistoryStep* one : later) takeOut(step.difference, one->difference);
}

/// Makes the commands of a step. False where nothing of it is left to do.
bool PlaceEditor::ready(Waiting& waiting, Given& given, const World& world) {
    const Scene scene{world, place_, names_};
    given.client = waiting.client;
    given.way = waiting.way;
    given.arrival = waiting.arrival;
    births_.begin(world);
    if (waiting.way == Given::Way::Do) {
        given.step = std::move(waiting.step);
        given.step.step = world.stepCount();
        given.batch.bodies = std::move(waiting.bodies);
        for (const CommandBody& body : given.batch.bodies)
            given.concerns.push_back(record_.read(body, scene, true));
        return true;
    }
    for (PartChange& part : waiting.step.difference.parts) part.passed = false;
    for (MemberChange& member : waiting.step.difference.members) member.passed = false;
    if (waiting.way == Given::Way::Undo) {
        takeOutOfOthers(waiting.client, waiting.step);
        waiting.step.difference = reversed(std::move(waiting.step.difference));
    }
    given.step = std::move(waiting.step);
    given.batch = commandsBetween(given.step.difference, {waiting.client, waiting.fresh}, scene);
    return !given.batch.empty();
}

std::vector<PlaceEditor::Given> PlaceEditor::due(const World& world) {
    std::vector<Given> given;
    if (waiting_.empty()) return given;
    std::vector<Subject> touched;
    for (const Given& act : acts_)
        for (const Subject& thing : subjectsOf(act.batch.bodies, act.concerns)) touched.push_back(thing);
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
        const std::vector<Subject> things = subjectsOf(*next);
        const bool waits = next->behindAct || isBusy(things, touched);
        touched.insert(touched.end(), things.begin(), things.end());
        if (waits) {
            busy.push_back(next->client);
            ++next;
            continue;
        }
        Given one;
        if (!ready(*next, one, world)) {
            ++revision_;
            if (next->way == Given::Way::Follow) {
                next = waiting_.erase(next);
                continue;
            }
            next->fetched = false;  // Then the one before is taken back.
            next->step = {};
            continue;
        }
        busy.push_back(next->client);
        given.push_back(std::move(one));
        next = waiting_.erase(next);
    }
    return given;
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
