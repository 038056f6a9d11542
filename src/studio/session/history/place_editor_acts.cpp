// Acts of directors: what directs groups, and how it is taken back.
#include <algorithm>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/crowd_change.h"
#include "studio/session/history/place_edit.h"
#include "studio/session/history/place_editor.h"
#include "studio/session/inbox/command_text.h"

namespace muster {
namespace {

/// A slider whose messages are no farther apart than this is one step [steps].
constexpr std::uint32_t kGesture = 30;

/// Ids of the characters that came with the step for this change of the crowd. Takes their events out.
std::vector<std::uint32_t> takeJoined(const MemberChange& crowdChange, std::vector<Event>& added) {
    std::vector<std::uint32_t> ids;
    for (const CommandBody& body : crowdChange.redo) {
        const auto* add = std::get_if<AddCharacters>(&body);
        std::size_t left = add == nullptr ? 0 : add->positions.size();
        for (Event& event : added) {
            if (left == 0) break;
            if (event.kind != EventKind::Joined || event.value != add->group.value) continue;
            ids.push_back(event.subject);
            event.value = 0;  // It is of one change of the crowd only.
            --left;
        }
    }
    return ids;
}

}  // namespace

void PlaceEditor::acted(std::uint32_t client, const std::vector<CommandBody>& bodies,
                        std::uint32_t firstSequence, const World& world) {
    Given act;
    act.client = client;
    for (std::size_t k = 0; k < bodies.size(); ++k)
        if (canTakeBack(bodies[k]))
            addCrowdChange(act, bodies[k], firstSequence + static_cast<std::uint32_t>(k), world);
    if (act.step.changes.empty() && act.step.crowdChanges.empty()) return;
    if (acts_.empty()) highest_ = highestIds(world);
    act.step.label = actLabel(bodies, world);
    act.step.directs = true;
    act.step.step = world.stepCount();
    act.arrival = ++lastArrival_;
    acts_.push_back(std::move(act));
    ++revision_;
}

void PlaceEditor::addCrowdChange(Given& act, const CommandBody& body, std::uint32_t sequence,
                                 const World& world) {
    if (const GroupId group = queueChangedBy(body)) addQueueChange(act, group, body, sequence, world);
    if (isOneOf<GiveOrder, EditQueue>(body)) return;
    const bool divides = isOneOf<SplitGroup, MergeGroups>(body);
    const bool members = isOneOf<AddCharacters, RemoveCharacters, TransferCharacters>(body);
    if (!divides && !members) {
        act.step.changes.push_back(actChange(act, body, world));
        act.sequences.push_back(sequence);
        return;
    }
    act.step.crowdChanges.push_back(divides ? CrowdChange(divisionOf(body, world))
                                            : memberChange(body, world));
    act.crowdChanges.bodies.push_back(body);
    act.changeSequences.push_back(sequence);
}

// The queue is known before the step is made, as it does what the command asks for.
void PlaceEditor::addQueueChange(Given& act, GroupId group, const CommandBody& body, std::uint32_t sequence,
                                 const World& world) {
    const auto g = inspect::indexOfGroup(world, group);
    if (!g) return;
    QueueState& planned = planned_.try_emplace(group, queueOf(world.group(*g))).first->second;
    std::vector<CrowdChange>& crowdChanges = act.step.crowdChanges;
    const auto same = std::find_if(crowdChanges.begin(), crowdChanges.end(),
                                   [&](const CrowdChange& crowdChange) {
                                       const auto* queue = std::get_if<QueueChange>(&crowdChange);
                                       return queue != nullptr && queue->group == group;
                                   });
    const auto at = static_cast<std::size_t>(same - crowdChanges.begin());
    if (same == crowdChanges.end()) {
        const auto own = inverseOf(SetFormation{group, {}}, world, place_);
        crowdChanges.push_back(
            QueueChange{group, planned, {}, std::get<SetFormation>(*own).formation, false});
    }
    const std::uint32_t id = ++lastUnnamed_;
    if (std::holds_alternative<GiveOrder>(body))
        act.crowdChanges.orders.push_back({act.crowdChanges.bodies.size(), id});
    if (!std::holds_alternative<SetPose>(body)) {
        act.crowdChanges.bodies.push_back(body);
        act.changeSequences.push_back(sequence);
    }
    apply(planned, body, id);
    std::get<QueueChange>(crowdChanges[at]).after = planned;
}

// What takes a change back is what the world has, or what an earlier act of the same step has asked for.
PlaceChange PlaceEditor::actChange(const Given& act, const CommandBody& body, const World& world) const {
    PlaceChange change{thingOf(body).value_or(Thing{}), body, body};
    if (const auto undo = inverseOf(body, world, place_)) change.undo = *undo;
    const auto look = [&](const Given& one) {
        for (const PlaceChange& earlier : one.step.changes)
            if (doesTheSame(change, earlier)) change.undo = earlier.redo;
    };
    for (const Given& one : acts_) look(one);
    look(act);
    return change;
}

bool PlaceEditor::isRefused(const Given& one, std::uint32_t sequence, const World& world) const {
    return std::any_of(world.rejections().begin(), world.rejections().end(), [&](const Rejection& rejection) {
        return rejection.command.client == one.client && rejection.command.sequence == sequence;
    });
}

// Orders have the ids that their events tell, which come in the order of the commands.
void PlaceEditor::nameOrders(std::vector<Given>& given, const World& world) {
    std::vector<Event> events(world.events().begin(), world.events().end());
    std::erase_if(events, [](const Event& event) { return event.kind != EventKind::OrderGiven; });
    for (Given& one : given) {
        for (const CrowdCommands::Order& order : one.crowdChanges.orders) {
            if (order.body >= one.changeSequences.size()) continue;
            const auto& give = std::get<GiveOrder>(one.crowdChanges.bodies[order.body]);
            const auto event = std::find_if(events.begin(), events.end(), [&](const Event& of) {
                return of.subject == give.group.value && of.position == give.order.target;
            });
            if (event == events.end() || isRefused(one, one.changeSequences[order.body], world)) continue;
            const auto name = [&](PlaceStep& step) {
                for (CrowdChange& crowdChange : step.crowdChanges)
                    renameOrder(crowdChange, order.id, event->value);
            };
            eachStep(name);
            for (Given& other : given) name(other.step);
            events.erase(event);
        }
    }
}

// Changes of the crowd of which the world has refused every command are left out.
void PlaceEditor::finishCrowdChanges(Given& one, std::vector<Event>& added, const World& world) {
    const bool refused = std::all_of(one.changeSequences.begin(), one.changeSequences.end(),
                                     [&](std::uint32_t sequence) { return isRefused(one, sequence, world); });
    if (refused && (!one.changeSequences.empty() || one.step.changes.empty())) one.step.crowdChanges.clear();
    for (CrowdChange& crowdChange : one.step.crowdChanges) {
        if (auto* member = std::get_if<MemberChange>(&crowdChange)) {
            if (member->redo.empty() || !std::holds_alternative<AddCharacters>(member->redo.front()))
                continue;
            member->undo = {RemoveCharacters{takeJoined(*member, added)}};
        }
        auto* division = std::get_if<DivisionChange>(&crowdChange);
        if (division == nullptr || !division->splits()) continue;
        const std::vector<GroupId> parts = takeNewParts(*division, added);
        const bool again = !division->parts.empty();
        for (std::size_t k = 0; k < parts.size(); ++k) {
            if (!again) {
                division->parts.push_back({parts[k], {}, {}, {}});
                continue;
            }
            const GroupId old = division->parts[k].id;
            renameEverywhere({ThingKind::Group, old.value}, parts[k].value);
            renameGroup(crowdChange, old, parts[k]);
        }
        if (again) follow(one, *division, world);
    }
}

void PlaceEditor::follow(const Given& one, const DivisionChange& crowdChange, const World& world) {
    Waiting waiting;
    partsComeBack(crowdChange, world, waiting.commands);
    if (waiting.commands.bodies.empty()) return;
    waiting.client = one.client;
    waiting.way = Given::Way::Follow;
    waiting.fetched = true;
    waiting.step.directs = true;
    waiting.arrival = one.arrival;
    waiting_.push_front(std::move(waiting));
}

bool PlaceEditor::joinsAct(const PlaceStep& last, const PlaceStep& next) const {
    if (!last.directs || !next.directs || last.label != next.label || !last.crowdChanges.empty() ||
        !next.crowdChanges.empty() || next.step - last.step > kGesture)
        return false;
    const auto slides = [](const PlaceChange& change) { return isContinuous(change.redo); };
    if (!std::all_of(next.changes.begin(), next.changes.end(), slides)) return false;
    // Several parameters that a page sets at once are one choice.
    const bool atOnce = next.step == last.step && std::holds_alternative<SetParameter>(next.changes[0].redo);
    return atOnce || overtakes(next.changes, last.changes);
}

}  // namespace muster
