#include "engine/systems/commands/order_queues.h"

#include <algorithm>
#include <string>
#include <utility>

#include "base/bounds.h"
#include "engine/formation/mesh/rigid_fit.h"
#include "engine/state/shared_places.h"
#include "engine/state/validation.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/walk_progress.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
namespace {

// The point where a character comes to a stand by its own brakes [m].
Vec2 stopOf(const WorldState& state, std::int32_t i) {
    const Characters& c = state.characters;
    const Parameters::Character& def = state.parameters.character;
    const double brakes = accelerationOf(def, c.body[i]), speed = length(c.velocity[i]);
    const Vec2 stop = c.position[i] + c.velocity[i] * (speed / (2.0 * brakes));
    const bool clear = state.environment.clearLine(c.position[i], stop, radiusOf(def, c.body[i]));
    return clear ? stop : c.position[i];
}

// Places stay at their positions, except those whose holders would have to walk to them: these move to the
// points where the holders stop. Places without a holder move to where members without a place stop.
void placesComeToPeople(WorldState& state, Group& group) {
    std::vector<Vec2> places = group.places.positions();
    if (places.empty() || hasWeights(state, group)) return;
    std::vector<std::uint8_t> held(places.size(), 0);
    const auto placeOf = [&](std::int32_t i) {
        const std::int32_t place = state.characters.place[i];
        return std::cmp_less(place, places.size()) ? place : -1;
    };
    for (const std::int32_t i : group.members) {
        const std::int32_t place = placeOf(i);
        if (place < 0) continue;
        held[place] = 1;
        const Vec2 stop = stopOf(state, i);
        if (distance(stop, places[place]) > kArrivedReach) places[place] = stop;
    }
    auto free = std::find(held.begin(), held.end(), 0);
    for (const std::int32_t i : group.members) {
        if (placeOf(i) >= 0 || free == held.end()) continue;
        places[free - held.begin()] = stopOf(state, i);
        free = std::find(free + 1, held.end(), 0);
    }
    group.places.lead(places, state.parameters.stepTime);
    group.flow = {};
    group.flow.ends = std::move(places);
    group.flow.standAtEnds();
    group.flow.version = group.formationVersion;
    group.flow.ground = state.groundEdits;
}

// Every member stands where it is, and the mesh where its places are.
void standStill(WorldState& state, Group& group) {
    if (Gathering* const gathering = state.continuum.find(group.id)) {
        gathering->active = false;
        return;
    }
    placesComeToPeople(state, group);
    standWhereItIs(group);
    if (group.flow.leads()) group.orders.march.last = group.mesh.pose();
}

/// Stops a group whose members go freely, each to its place at the end.
void stopFree(WorldState& state, Group& group) {
    if (group.orders.goesFree()) standStill(state, group);
}

/// Ends the order that is carried out, which is about to leave the queue; `stays`: a free group stops.
void endFirst(WorldState& state, Group& group, bool stays) {
    if (stays) stopFree(state, group);
    group.orders.end();
}

Status cancel(WorldState& state, Group& group, std::uint32_t id) {
    OrderQueue& queue = group.orders;
    if (id == 0) {
        if (!queue.orders.empty()) endFirst(state, group, true);
        if (Gathering* const gathering = state.continuum.find(group.id)) gathering->active = false;
        queue.orders.clear();
        return {};
    }
    const auto at = std::find_if(queue.orders.begin(), queue.orders.end(),
                                 [&](const QueuedOrder& order) { return order.id == id; });
    if (at == queue.orders.end())
        return {StatusCode::NotFound,
                "group " + std::to_string(group.id.value) + " has no order of the id " + std::to_string(id)};
    if (at == queue.orders.begin()) endFirst(state, group, queue.orders.size() == 1);
    queue.orders.erase(at);
    return {};
}

void hold(WorldState& state, Group& group) {
    stopFree(state, group);
    group.orders.held = true;
}

// Lets a queue go on. A group whose members go freely gets its target again.
void resume(Group& group) {
    OrderQueue& queue = group.orders;
    queue.held = false;
    if (queue.goesFree()) queue.march.phase = MarchPhase::Idle;
}

void stop(WorldState& state, Group& group) {
    group.controls.clear();
    standStill(state, group);
    dropOrders(group);
}

}  // namespace

void standWhereItIs(Group& group) {
    const std::vector<Vec2>& places = group.places.positions();
    std::vector<Vec2> rest;
    group.mesh.restPlaces(rest);
    if (places.empty() || places.size() != rest.size()) return;
    group.mesh.setPose(bestRigidFit(rest, places));
}

void shareOrders(WorldState& state, std::span<Group* const> parts, Vec2 middle) {
    const OrderQueue whole = parts[0]->orders;
    for (std::size_t p = 0; p < parts.size(); ++p) {
        OrderQueue& queue = parts[p]->orders;
        queue = whole;
        std::vector<Vec2> places;
        parts[p]->mesh.placePositions(places);
        const Vec2 shift = places.empty() ? Vec2{} : meanOf(places) - middle;
        queue.march.phase = MarchPhase::Idle;
        queue.march.searched = 0;
        queue.own.reset();
        for (QueuedOrder& queued : queue.orders) {
            if (p > 0) queued.id = state.nextOrder++;
            if (queued.order.kind != OrderKind::Move || queued.order.manner == Manner::Continuum) continue;
            queued.order.target += shift;
            for (Vec2& point : queued.order.route) point += shift;
        }
        const bool gathers = queue.begun && queue.orders.front().order.manner == Manner::Continuum;
        if (!gathers) queue.target += shift;
    }
}

void dropOrders(Group& group) {
    OrderQueue& queue = group.orders;
    queue.end();
    queue.orders.clear();
    queue.held = queue.patrols = false;
}

Status apply(CommandContext& context, const GiveOrder& command) {
    WorldState& state = context.state;
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    const Order& order = command.order;
    if (order.group && state.findGroup(order.group) == nullptr) return noGroup(order.group);
    if (order.group == command.group) return invalidArgument("a group cannot follow or guard itself");
    if (order.character != 0 && state.characters.indexOf(order.character) < 0)
        return noCharacter(order.character);
    std::vector<QueuedOrder>& orders = group->orders.orders;
    if (command.mode != QueueMode::Replace && orders.size() >= kMaxOrders)
        return {StatusCode::LimitExceeded, "a queue holds at most " + std::to_string(kMaxOrders) + " orders"};
    const QueuedOrder queued{state.nextOrder++, order};
    if (command.mode == QueueMode::Replace) {
        group->orders.end();
        group->orders.held = group->orders.patrols = false;
        orders.clear();
    }
    const std::size_t index = command.mode == QueueMode::Insert
                                  ? std::min<std::size_t>(command.index, orders.size())
                                  : orders.size();
    if (index == 0) group->orders.end();
    orders.insert(orders.begin() + static_cast<std::ptrdiff_t>(index), queued);
    context.events.push_back({EventKind::OrderGiven, group->id.value, queued.id, order.target});
    return {};
}

Status apply(CommandContext& context, const EditQueue& command) {
    WorldState& state = context.state;
    Group* const group = state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    switch (command.edit) {
        case QueueEdit::Cancel:
            return cancel(state, *group, command.order);
        case QueueEdit::Hold:
            hold(state, *group);
            break;
        case QueueEdit::Resume:
            resume(*group);
            break;
        case QueueEdit::Patrol:
            group->orders.patrols = true;
            break;
        case QueueEdit::EndPatrol:
            group->orders.patrols = false;
            break;
        case QueueEdit::Stop:
            stop(state, *group);
            break;
    }
    return {};
}

Status apply(CommandContext& context, const ReverseQueue& command) {
    Group* const group = context.state.findGroup(command.group);
    if (group == nullptr) return noGroup(command.group);
    std::vector<QueuedOrder>& orders = group->orders.orders;
    if (orders.size() < 2) return {};
    group->orders.end();
    std::reverse(orders.begin(), orders.end());
    return {};
}

}  // namespace muster
