#include "engine/systems/events/moving_gates.h"

#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kLookEvery = 0.5;   // Time between looks [s].
constexpr double kWaitingFor = 1.0;  // Who has not moved for this long waits [s].
constexpr double kBlockedFor = 2.0;  // A way that is cut off for this long gives an event,
constexpr double kFreeFor = 1.0;     // and one that is there again for this long [s].

// Those of a group between whom and their places moving obstacles stand.
struct Behind {
    std::int32_t count = 0;
    Vec2 middle;
};

// Travelling places wait before gates too, so that it counts where they are bound for.
bool onTheWay(const WorldState& state, const Group& group, std::int32_t i) {
    const std::int32_t place = state.characters.place[i];
    return place >= 0 &&
           distance(state.characters.position[i], group.places.reachableTargets()[place]) > kArrivedReach;
}

bool somebodyWaits(const WorldState& state, const Group& group) {
    const std::uint32_t waiting = stepsIn(state, kWaitingFor);
    for (const std::int32_t i : group.members)
        if (onTheWay(state, group, i) && state.stepCount - state.characters.walk[i].movedAt >= waiting)
            return true;
    return false;
}

// Who has no way even without moving obstacles has its own event, and who is beneath one is not cut off.
Behind findBehind(const WorldState& state, const Group& group, const MovingRegions& regions) {
    Behind found;
    for (const std::int32_t i : group.members) {
        if (!onTheWay(state, group, i)) continue;
        const Vec2 from = state.characters.position[i];
        const Vec2 to = group.places.reachableTargets()[state.characters.place[i]];
        const std::int32_t a = regions.region(from), b = regions.region(to);
        if (a < 0 || b < 0 || a == b || !state.routesOf(group).reachable(from, to)) continue;
        ++found.count;
        found.middle += from;
    }
    if (found.count > 0) found.middle = found.middle / found.count;
    return found;
}

}  // namespace

void MovingGates::judge(WorldState& state, Group& group, std::vector<Event>& events) {
    OrderProgress& order = group.order;
    const bool reported = order.behindMoving > 0;
    Behind behind;
    if (reported || somebodyWaits(state, group)) {
        if (!updated_) regions_.update(state.routes);
        updated_ = true;
        behind = findBehind(state, group, regions_);
    }
    if ((behind.count > 0) == reported) {
        order.movingSince = state.stepCount;
        return;
    }
    if (state.stepCount - order.movingSince < stepsIn(state, reported ? kFreeFor : kBlockedFor)) return;
    const std::int32_t value = reported ? order.behindMoving : behind.count;
    events.push_back({reported ? EventKind::Free : EventKind::Blocked, group.id.value,
                      static_cast<std::uint32_t>(value),
                      reported ? group.mesh.pose().position : behind.middle});
    order.behindMoving = behind.count;
    order.movingSince = state.stepCount;
}

void MovingGates::raise(WorldState& state, std::vector<Event>& events) {
    if (state.stepCount % stepsIn(state, kLookEvery) != 0) return;
    updated_ = false;
    const bool moving = !state.environment.movingObstacleAreas().empty();
    for (Group& group : state.groups)
        if (moving || group.order.behindMoving > 0) judge(state, group, events);
}

}  // namespace muster
