#include "engine/systems/events/moving_gates.h"

#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kGateInterval = 0.5;  // Time between two looks at moving obstacles [s].
constexpr double kWaitingTime = 1.0;   // Time without moving after which a character waits [s].
constexpr double kBlockedTime = 2.0;   // Time that members are cut off before Blocked is raised [s].
constexpr double kFreeTime = 1.0;      // Time that a route is there again before Free is raised [s].

// The members of a group that moving obstacles separate from their places.
struct Behind {
    std::int32_t count = 0;
    Vec2 middle;
};

// True for a character far from the target of its place; travelling places themselves wait before gates.
bool onTheWay(const WorldState& state, const Group& group, std::int32_t i) {
    const std::int32_t place = state.characters.place[i];
    return place >= 0 &&
           distance(state.characters.position[i], group.places.reachableTargets()[place]) > kArrivedReach;
}

bool somebodyWaits(const WorldState& state, const Group& group) {
    const std::uint32_t waiting = stepsIn(state, kWaitingTime);
    for (const std::int32_t i : group.members)
        if (onTheWay(state, group, i) && state.stepCount - state.characters.walk[i].movedAt >= waiting)
            return true;
    return false;
}

// A member without a route even if nothing moved has its own event; one beneath an obstacle is not cut off.
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
    if (state.stepCount - order.movingSince < stepsIn(state, reported ? kFreeTime : kBlockedTime)) return;
    const std::int32_t value = reported ? order.behindMoving : behind.count;
    events.push_back({reported ? EventKind::Free : EventKind::Blocked, group.id.value,
                      static_cast<std::uint32_t>(value),
                      reported ? group.mesh.pose().position : behind.middle});
    order.behindMoving = behind.count;
    order.movingSince = state.stepCount;
}

void MovingGates::raise(WorldState& state, std::vector<Event>& events) {
    if (state.stepCount % stepsIn(state, kGateInterval) != 0) return;
    updated_ = false;
    const bool moving = !state.environment.movingObstacleAreas().empty();
    for (Group& group : state.groups)
        if (moving || group.order.behindMoving > 0) judge(state, group, events);
}

}  // namespace muster
