// Acts of directors, and what the steps of the world bring to their histories.
#include <algorithm>
#include <tuple>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/group_fields.h"
#include "studio/session/history/place_editor.h"
#include "studio/session/inbox/received_commands.h"

namespace muster {
namespace {

constexpr std::size_t kMostSteps = 1000;       // Of a history.
constexpr std::size_t kMostBytes = 64u << 20;  // Of a history.
/// A slider whose messages are no farther apart than this is one step [steps].
constexpr std::uint32_t kGesture = 30;

void push(std::deque<HistoryStep>& steps, HistoryStep step) {
    step.bytes = bytesOf(step.difference);
    steps.push_back(std::move(step));
    std::size_t bytes = 0;
    for (const HistoryStep& one : steps) bytes += one.bytes;
    while (steps.size() > kMostSteps || (bytes > kMostBytes && steps.size() > 1)) {
        bytes -= steps.front().bytes;
        steps.pop_front();
    }
}

bool isRefused(std::uint32_t client, std::uint32_t sequence, const World& world) {
    return std::any_of(world.rejections().begin(), world.rejections().end(), [&](const Rejection& rejection) {
        return rejection.command.client == client && rejection.command.sequence == sequence;
    });
}

}  // namespace

bool joins(const HistoryStep& last, const HistoryStep& next) {
    if (next.gesture != 0 && last.gesture == next.gesture) return true;
    if (next.sentence != 0 && last.sentence == next.sentence) return true;
    if (!last.directs || !next.directs || last.label != next.label || last.slides.empty() ||
        next.slides.empty() || next.step - last.step > kGesture)
        return false;
    // Several parameters that a page sets at once are one choice.
    const bool atOnce = next.step == last.step && next.slides.front().subject.kind == SubjectKind::Parameter;
    return atOnce || next.slides == last.slides;
}

void PlaceEditor::acted(std::uint32_t client, const std::vector<CommandBody>& bodies,
                        std::uint32_t firstSequence, const World& world) {
    const Drags::Part drag = drags_.note(client, bodies, {world, place_, names_});
    for (const bool folded : {true, false}) {
        std::vector<CommandBody> chosen;
        std::vector<std::uint32_t> sequences;
        for (std::size_t k = 0; k < bodies.size(); ++k) {
            if (!canTakeBack(bodies[k]) || (drag.folds[k] != 0) != folded) continue;
            chosen.push_back(bodies[k]);
            sequences.push_back(firstSequence + static_cast<std::uint32_t>(k));
        }
        if (!chosen.empty())
            addAct(client, std::move(chosen), std::move(sequences), folded ? drag.drag : 0, world);
    }
    for (const std::uint32_t ended : drag.ended) endDrag(client, ended, firstSequence, world);
}

void PlaceEditor::addAct(std::uint32_t client, std::vector<CommandBody> bodies,
                         std::vector<std::uint32_t> sequences, std::uint32_t drag, const World& world) {
    Given act;
    act.client = client;
    act.step.label = sentence_ != 0 ? said_ : actLabel(bodies, world);
    act.step.sentence = sentence_;
    act.step.directs = true;
    act.step.step = world.stepCount();
    act.step.arrival = act.arrival = ++lastArrival_;
    act.drag = drag;
    births_.begin(world);
    const Scene scene{world, place_, names_};
    for (const CommandBody& body : bodies) act.concerns.push_back(record_.read(body, scene, false));
    if (std::all_of(bodies.begin(), bodies.end(), isContinuous))
        for (const CommandBody& body : bodies)
            for (const CommandBody& single : singleFields(body))
                act.step.slides.push_back(keyOf(single, names_));
    act.batch.bodies = std::move(bodies);
    act.sequences = std::move(sequences);
    acts_.push_back(std::move(act));
    ++revision_;
}

void PlaceEditor::endDrag(std::uint32_t client, std::uint32_t drag, std::uint32_t sequence,
                          const World& world) {
    Given act;
    act.client = client;
    act.step.label = "Drag";
    act.step.directs = true;
    act.step.step = world.stepCount();
    act.step.arrival = act.arrival = ++lastArrival_;
    act.drag = drag;
    act.endsDrag = true;
    act.sequences = {sequence};
    births_.begin(world);
    acts_.push_back(std::move(act));
    ++revision_;
}

// Commands are looked at in the order in which the world has applied them.
void PlaceEditor::carriedOut(std::vector<Given> given, const World& world) {
    for (Given& act : acts_) given.push_back(std::move(act));
    acts_.clear();
    const auto place = [](const Given& one) {
        return std::tuple(one.client, one.sequences.empty() ? 0u : one.sequences.front(), one.arrival);
    };
    std::stable_sort(given.begin(), given.end(),
                     [&](const Given& a, const Given& b) { return place(a) < place(b); });
    births_.end(world);
    for (Given& one : given) finish(one, world);
    record_.clear();
    births_.clear();
    for (Waiting& waiting : waiting_) waiting.behindAct = false;
}

void PlaceEditor::finish(Given& one, const World& world) {
    ++revision_;
    if (one.way == Given::Way::Do)
        finishAct(one, world);
    else
        finishLead(one, world);
}

std::vector<std::size_t> PlaceEditor::accepted(const Given& one, const World& world) const {
    std::vector<std::size_t> accepted;
    for (std::size_t k = 0; k < one.batch.bodies.size() && k < one.sequences.size(); ++k)
        if (!isRefused(one.client, one.sequences[k], world)) accepted.push_back(k);
    return accepted;
}

void PlaceEditor::finishAct(Given& one, const World& world) {
    const std::vector<std::size_t> commands = accepted(one, world);
    applyToPlace(one, commands, world);
    std::vector<CommandBody> bodies;
    std::vector<Concern> concerns;
    for (const std::size_t k : commands) {
        bodies.push_back(std::move(one.batch.bodies[k]));
        concerns.push_back(std::move(one.concerns[k]));
    }
    Difference difference = record_.changed(bodies, concerns, {world, place_, names_}, births_);
    if (one.drag != 0) {
        drags_.add(one.drag, std::move(difference));
        if (!one.endsDrag) return;
        difference = drags_.take(one.drag);
        dropEqual(difference);
    }
    one.step.difference = std::move(difference);
    one.step.arrival = one.arrival;
    if (one.endsDrag || !one.step.difference.empty()) keep(one);
}

void PlaceEditor::finishLead(Given& one, const World& world) {
    const std::vector<std::size_t> commands = accepted(one, world);
    const std::vector<FreshGroup> fresh = bindBirths(one, commands, world);
    applyToPlace(one, commands, world);
    record_.assume(one.step.difference);
    if (commands.empty() && !one.batch.bodies.empty()) return;
    if ((one.batch.follows || !fresh.empty()) && one.way != Given::Way::Follow) {
        Waiting follow;
        follow.client = one.client;
        follow.way = Given::Way::Follow;
        follow.step = one.step;
        follow.fresh = fresh;
        follow.fetched = true;
        follow.arrival = one.arrival;
        waiting_.push_front(std::move(follow));
    }
    if (one.way != Given::Way::Follow) keep(one);
}

std::vector<FreshGroup> PlaceEditor::bindBirths(const Given& one, const std::vector<std::size_t>& accepted,
                                                const World& world) {
    std::vector<FreshGroup> fresh;
    for (const std::size_t k : accepted) {
        std::vector<std::uint32_t> ids = births_.of(one.batch.bodies[k], world);
        const auto birth = std::find_if(one.batch.births.begin(), one.batch.births.end(),
                                        [&](const Birth& of) { return of.body == k; });
        if (birth == one.batch.births.end() || ids.empty()) continue;
        const bool characters = birth->kind == SubjectKind::Character;
        const std::uint32_t before = names_.idOf(birth->kind, birth->names.front());
        if (!characters) names_.bind(birth->kind, birth->names.front(), ids.front());
        if (birth->kind == SubjectKind::Group) {
            place_.follow(GroupId{before}, GroupId{ids.front()});
            fresh.push_back({birth->names.front(), GroupId{before}});
            ids = births_.newMembers(GroupId{ids.front()}, world);
        }
        const std::size_t first = characters ? 0 : 1;
        for (std::size_t n = first; n < birth->names.size() && n - first < ids.size(); ++n)
            names_.bind(SubjectKind::Character, birth->names[n], ids[n - first]);
    }
    return fresh;
}

// The place follows the commands; how groups start is taken back by itself.
void PlaceEditor::applyToPlace(const Given& one, const std::vector<std::size_t>& accepted,
                               const World& world) {
    if (one.step.directs) return;
    const bool first = one.way == Given::Way::Do;
    for (const std::size_t k : accepted) {
        const CommandBody& body = one.batch.bodies[k];
        if (first || isOneOf<RemoveGroup, ChangeCharacters, SetParameter>(body)) place_.apply(body, world);
    }
    if (first) return;
    for (const Crew& crew : one.step.difference.crews) {
        const GroupId id{names_.idOf(SubjectKind::Group, crew.group)};
        if (crew.start && place_.group(id) == nullptr && inspect::indexOfGroup(world, id))
            place_.add(id, *crew.start);
    }
    for (const CommandBody& start : one.batch.starts) place_.apply(start, world);
}

void PlaceEditor::keep(Given& given) {
    History& history = histories_[given.client];
    if (given.way == Given::Way::Undo) {
        given.step.difference = reversed(std::move(given.step.difference));
        return push(history.undone, std::move(given.step));
    }
    given.step.arrival = given.arrival;
    if (given.way == Given::Way::Redo) return push(history.done, std::move(given.step));
    history.undone.clear();
    if (history.done.empty() || !joins(history.done.back(), given.step))
        return push(history.done, std::move(given.step));
    HistoryStep last = std::move(history.done.back());
    history.done.pop_back();
    last.step = given.step.step;
    last.arrival = given.step.arrival;
    for (const PartKey& key : given.step.slides)
        if (std::find(last.slides.begin(), last.slides.end(), key) == last.slides.end())
            last.slides.push_back(key);
    join(last.difference, std::move(given.step.difference));
    dropEqual(last.difference);
    if (!last.difference.empty()) push(history.done, std::move(last));
}

}  // namespace muster
