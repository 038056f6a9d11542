#include "engine/systems/events/cut_off.h"

#include <algorithm>

namespace muster {
namespace {

/// The members of a group that have no route to their places.
struct CutOff {
    std::int32_t places = 0;      ///< Places whose targets lie where the group cannot go.
    std::int32_t characters = 0;  ///< Characters that stand where the group's places are not.
    Vec2 middle;  ///< Mean of these targets, or of the characters where all targets can be reached [m].

    std::int32_t count() const { return std::max(places, characters); }
};

/// The region of a point, or of the free ground nearest to it.
std::int32_t regionNear(const RouteGraph& routes, Vec2 p) {
    const std::int32_t label = routes.region(p);
    return label >= 0 ? label : routes.region(routes.nearestReachable(p, -1));
}

CutOff findCutOff(const WorldState& state, const Group& group) {
    CutOff found;
    const RouteGraph& routes = state.routesOf(group);
    if (group.region < 0 || routes.regionCount() <= 1) return found;
    Vec2 targets, characters;
    for (const Vec2 p : group.places.targets()) {
        if (regionNear(routes, p) == group.region) continue;
        ++found.places;
        targets += p;
    }
    for (const std::int32_t i : group.members) {
        if (!isCutOff(routes, group.region, state.characters.position[i])) continue;
        ++found.characters;
        characters += state.characters.position[i];
    }
    if (found.places > 0)
        found.middle = targets / found.places;
    else if (found.characters > 0)
        found.middle = characters / found.characters;
    return found;
}

/// The event of a new order; Count for none.
EventKind kindOfOrder(const CutOff& cut, const Group& group) {
    if (cut.places == 0) return cut.characters > 0 ? EventKind::Blocked : EventKind::Count;
    return cut.places == group.def.count ? EventKind::NoPath : EventKind::Partial;
}

/// The event of a changed ground; Count for none.
EventKind kindOfGround(std::int32_t before, std::int32_t now) {
    if (now > before) return EventKind::Blocked;
    if (now == before) return EventKind::Count;
    return now == 0 ? EventKind::Free : EventKind::Partial;
}

}  // namespace

bool isCutOff(const RouteGraph& routes, std::int32_t region, Vec2 point) {
    const std::int32_t label = routes.region(point);
    return region >= 0 && label >= 0 && label != region;
}

void raiseWayEvents(WorldState& state, Group& group, std::vector<Event>& events) {
    OrderProgress& order = group.order;
    const bool sameGround = order.ground == state.groundEdits;
    if (order.judged && sameGround) return;
    const CutOff cut = findCutOff(state, group);
    const std::int32_t before = order.withoutWay, now = cut.count();
    EventKind kind = EventKind::Count;
    if (order.fresh || (sameGround && now != before))
        kind = kindOfOrder(cut, group);
    else
        kind = kindOfGround(before, now);
    order.judged = true;
    order.fresh = false;
    order.ground = state.groundEdits;
    order.withoutWay = now;
    if (kind == EventKind::Count) return;
    const std::int32_t value = kind == EventKind::Free ? before : now;
    events.push_back({kind, group.id.value, static_cast<std::uint32_t>(value),
                      now > 0 ? cut.middle : group.mesh.pose().position});
}

}  // namespace muster
