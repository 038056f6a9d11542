#include "engine/systems/events/event_stage.h"

#include <algorithm>
#include <cmath>

#include "engine/state/group_edits.h"
#include "engine/systems/events/cut_off.h"
#include "engine/systems/events/rest.h"

namespace muster {
namespace {

constexpr double kDrawnTime = 0.25;  // Time after which a drawn route that grows no further is complete [s].
constexpr double kStuckInterval = 0.5;  // Time between two searches for stuck characters [s].

/// Notes the members of a group that are in a checkpoint. True once the checkpoint's share of the group has
/// been in it since the group last left it, or where the middle of the group is in it and the share is at
/// most a half.
bool crowdPasses(const WorldState& state, const Group& group, const FormationCheckpointDef& checkpoint,
                 std::vector<std::uint32_t>& visitors, bool& anyInside) {
    std::int32_t been = 0;
    Vec2 sum;
    anyInside = false;
    for (const std::int32_t i : group.members) {
        const std::uint32_t id = state.characters.id[i];
        const auto at = std::lower_bound(visitors.begin(), visitors.end(), id);
        const bool known = at != visitors.end() && *at == id;
        const bool inside = distance(state.characters.position[i], checkpoint.position) <= checkpoint.radius;
        sum += state.characters.position[i];
        anyInside = anyInside || inside;
        been += known || inside ? 1 : 0;
        if (inside && !known) visitors.insert(at, id);
    }
    const auto count = static_cast<double>(group.members.size());
    // The middle of a crowd that is wider than the checkpoint counts for half of the crowd.
    const bool middle = checkpoint.share <= 0.5 && count > 0.0 &&
                        distance(sum / count, checkpoint.position) <= checkpoint.radius;
    anyInside = anyInside || middle;
    return middle || (been > 0 && been >= std::ceil(checkpoint.share * count - 1e-9));
}

/// True where a group passes a checkpoint in this step.
bool passes(WorldState& state, Group& group, std::size_t index, std::uint8_t& flags) {
    const FormationCheckpointDef& checkpoint = state.checkpoints[index];
    if (checkpoint.once && (flags & 2) != 0) return false;
    bool passed = false, inside = false;
    if (checkpoint.trigger == CheckpointTrigger::Mesh) {
        inside = distance(group.mesh.pose().position, checkpoint.position) <= checkpoint.radius;
        passed = inside;
    } else {
        group.visitors.resize(state.checkpoints.size());
        std::vector<std::uint32_t>& visitors = group.visitors[index];
        passed = crowdPasses(state, group, checkpoint, visitors, inside);
        if (!inside) visitors.clear();
    }
    const bool comes = passed && (flags & 1) == 0;
    flags = static_cast<std::uint8_t>((flags & 2) | ((inside && (flags & 1) != 0) || comes ? 1 : 0));
    return comes;
}

// True where all places stand at their targets. Where members have no route, places stop short of the target.
bool placesStand(const Group& group) {
    if (group.order.withoutWay > 0) return false;
    const PlaceTracker& places = group.places;
    for (std::size_t k = 0; k < places.positions().size(); ++k)
        if (!placeRests(places, k)) return false;
    return true;
}

/// Raises an arrival that is awaited, or begins to await one where a member is far from its place.
void raiseArrival(const WorldState& state, Group& group, std::vector<Event>& events) {
    OrderProgress& order = group.order;
    if (order.arrival == ArrivalWatch::Raised) return;
    // A group that cannot come where its order leads does not arrive.
    if (group.orders.begun && !group.orders.reachable) return;
    const std::uint32_t second = stepsIn(state, kArrivedTime);
    std::uint32_t matched = 0;
    bool allNear = true, allLong = true;
    for (const std::int32_t i : group.members) {
        if (state.characters.place[i] < 0) continue;
        const WalkProgress& walk = state.characters.walk[i];
        ++matched;
        allNear = allNear && walk.within;
        allLong = allLong && walk.within && state.stepCount - walk.since >= second;
    }
    const bool stand = placesStand(group);
    if (order.arrival == ArrivalWatch::Idle && (!allNear || !stand)) order.arrival = ArrivalWatch::Awaited;
    if (order.arrival != ArrivalWatch::Awaited || matched == 0 || !allLong || !stand ||
        state.stepCount - order.step < second)
        return;
    order.arrival = ArrivalWatch::Raised;
    events.push_back({EventKind::Arrived, group.id.value, matched, group.mesh.pose().position});
}

void watchOrder(WorldState& state, Group& group, std::vector<Event>& events) {
    OrderProgress& order = group.order;
    if (isDrawn(group) || isOnItsWay(group)) {
        order.arrival = ArrivalWatch::Awaited;
        order.step = state.stepCount;
        order.judged = false;
        return;
    }
    if (order.ground != state.groundEdits && order.arrival == ArrivalWatch::Raised)
        order.arrival = ArrivalWatch::Idle;
    if (state.stepCount - order.step >= stepsIn(state, kDrawnTime)) raiseWayEvents(state, group, events);
    raiseArrival(state, group, events);
}

}  // namespace

void raiseMotionEvents(const WorldState& state, std::span<const MotionEvent> changes,
                       std::vector<Event>& events) {
    const Characters& characters = state.characters;
    events.reserve(characters.size() + 4 * state.groups.size() + state.items.size());
    for (const MotionEvent& change : changes) {
        // The first kinds of both lists correspond one to one.
        const auto kind = static_cast<EventKind>(change.change);
        const std::int32_t i = change.character;
        events.push_back({kind, characters.id[i], change.value, characters.position[i]});
    }
}

void collectItems(WorldState& state, std::vector<Event>& events) {
    const Characters& characters = state.characters;
    const std::vector<ItemDef>& items = state.items;
    for (std::size_t k = 0; k < items.size(); ++k) {
        if (state.collected[k] != 0) continue;
        for (std::size_t i = 0; i < characters.size(); ++i) {
            if (distance(characters.position[i], items[k].position) > items[k].radius) continue;
            state.collected[k] = 1;
            events.push_back(
                {EventKind::Collect, characters.id[i], static_cast<std::uint32_t>(k), items[k].position});
            break;
        }
    }
}

void meetCheckpoints(WorldState& state, std::vector<Event>& events) {
    const std::vector<FormationCheckpointDef>& checkpoints = state.checkpoints;
    for (std::size_t c = 0; c < checkpoints.size(); ++c) {
        const FormationCheckpointDef& checkpoint = checkpoints[c];
        for (std::size_t g = 0; g < state.groups.size(); ++g) {
            Group& group = state.groups[g];
            if (state.checkpointGroups[c] && state.checkpointGroups[c] != group.id) continue;
            std::uint8_t& flags = state.checkpointState[g * checkpoints.size() + c];
            if (!passes(state, group, c, flags)) continue;
            flags |= 2;
            const auto value = static_cast<std::uint32_t>(c);
            events.push_back({EventKind::Passed, group.id.value, value, checkpoint.position});
            if (state.continuum.isBare(group.id))
                group.def.formation = checkpoint.formation;
            else if (!changeFormation(state, group, checkpoint.formation, group.def.count).ok())
                continue;
            group.orders.own.reset();
            events.push_back({EventKind::FormationChange, group.id.value, value, checkpoint.position});
        }
    }
}

// The lag is measured from the goals of the places, since places wait for slow ground themselves.
void measureLags(WorldState& state) {
    const Characters& characters = state.characters;
    for (Group& group : state.groups) {
        double sum = 0.0;
        std::int32_t matched = 0;
        for (const std::int32_t i : group.members) {
            if (characters.place[i] < 0 || !characters.hasSetOut(i, state.stepCount)) continue;
            sum += distance(characters.position[i], group.places.reachableTargets()[characters.place[i]]);
            ++matched;
        }
        group.meanLag = matched > 0 ? sum / matched : 0.0;
    }
}

void EventStage::watchWalks(WorldState& state) {
    shared_.find(state);
    Characters& c = state.characters;
    const std::uint32_t stayed = stepsIn(state, kStayedTime);
    for (std::size_t i = 0; i < c.size(); ++i) {
        WalkProgress& walk = c.walk[i];
        // A character that has not set out yet counts as one that has just moved.
        const bool stays = !c.hasSetOut(i, state.stepCount);
        if (stays || distance(c.position[i], walk.anchor) >= kStuckDistance) {
            walk.anchor = c.position[i];
            walk.movedAt = state.stepCount;
            walk.stuckRaised = false;
        }
        const bool there = walk.within && state.stepCount - walk.since >= stayed;
        if (stays || there || distance(c.position[i], walk.camp) >= kCampReach) {
            walk.camp = c.position[i];
            walk.campedAt = state.stepCount;
        }
        const std::int32_t place = c.place[i];
        const bool within = place >= 0 &&
                            distance(c.position[i], state.groups[c.group[i]].places.positions()[place]) <=
                                kArrivedReach + shared_.room(i);
        if (within == walk.within) continue;
        walk.within = within;
        walk.since = state.stepCount;
    }
}

void EventStage::watchOrders(WorldState& state, std::vector<Event>& events) {
    for (Group& group : state.groups)
        if (!state.continuum.isBare(group.id)) watchOrder(state, group, events);
}

void EventStage::watchStandstill(WorldState& state, std::vector<Event>& events) {
    standstill_.reserve(state.characters);
    if (state.stepCount % stepsIn(state, kStuckInterval) == 0) standstill_.raise(state, events);
}

}  // namespace muster
