#include "engine/systems/events/standing.h"

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "engine/systems/events/cut_off.h"
#include "engine/systems/events/rest.h"
#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

// Places that nothing bars may stand so far from where the mesh has them, as marches end in even rows [m].
constexpr double kShifted = 1.0;

/// Judges the members of one group.
class Judge {
public:
    Judge(const WorldState& state, const Group& group)
        : state_(state),
          group_(group),
          routes_(state.routesOf(group)),
          second_(stepsIn(state, kArrivedTime)),
          held_(group.orders.held && !group.orders.orders.empty()),
          goes_(isDrawn(group) || isOnItsWay(group) ||
                (!group.orders.orders.empty() && !group.orders.begun)) {
        const std::vector<std::uint8_t>& fit = group.places.fit();
        for (std::int32_t k = 0; k < std::ssize(fit); ++k)
            if (fit[k] == 0) unfit_.push_back(k);
        group.mesh.placePositions(wanted_);
        const std::vector<Vec2>& room = group.room.given;
        if (room.size() != wanted_.size()) return;
        for (std::size_t k = 0; k < room.size(); ++k) wanted_[k] += group.mesh.pose().rotation.apply(room[k]);
    }

    StandingReport ofMatched(std::int32_t i, std::int32_t place) const {
        const WalkProgress& walk = state_.characters.walk[i];
        const PlaceTracker& places = group_.places;
        const Vec2 wanted = wantedAt(place);
        if (held_ || (!walk.within && waits(i))) return {Standing::Held, wanted};
        if (goes_) return {Standing::OnTheWay, wanted};
        if (isCutOff(i)) return {Standing::NoWay, wanted};
        const bool stands = walk.within && state_.stepCount - walk.since >= second_ &&
                            placeRests(places, place);
        if (!stands && !walk.stuckRaised) return {Standing::OnTheWay, wanted};
        return {barAt(wanted, distance(wanted, places.reachableTargets()[place]))
                    .value_or(stands ? Standing::InPlace : Standing::Stuck),
                wanted};
    }

    /// Those without a place have none because so many places are unfit: each gets the cause of one.
    StandingReport ofUnmatched(std::int32_t i) {
        const Vec2 here = state_.characters.position[i];
        if (held_ || waits(i)) return {Standing::Held, here};
        if (goes_) return {Standing::OnTheWay, here};
        if (isCutOff(i)) return {Standing::NoWay, here};
        if (next_ == unfit_.size()) return {Standing::Crowded, here};
        const Vec2 wanted = wantedAt(unfit_[next_++]);
        return {bar(wanted), wanted};
    }

    /// A member of a group that goes to a point or to areas without places.
    StandingReport ofGathered(const Gathering& gathering, std::int32_t i) const {
        const Characters& c = state_.characters;
        const StandingSpot* const spot = gathering.spotOf(c.id[i]);
        const Vec2 wanted = spot != nullptr ? spot->spot : c.position[i];
        const bool there = spot != nullptr ? distance(c.position[i], wanted) <= kArrivedReach
                                           : gathering.hasArrived(c.id[i]);
        if (there) return {Standing::InPlace, wanted};
        if (group_.orders.held || waits(i)) return {Standing::Held, wanted};
        return {Standing::OnTheWay, wanted};
    }

private:
    bool waits(std::int32_t i) const { return !state_.characters.hasSetOut(i, state_.stepCount); }

    /// True where the character stands on ground from which no way leads to its group.
    bool isCutOff(std::int32_t i) const {
        return muster::isCutOff(routes_, group_.region, state_.characters.position[i]);
    }

    Vec2 wantedAt(std::int32_t place) const {
        return std::cmp_less(place, wanted_.size()) ? wanted_[place]
                                                    : group_.places.reachableTargets()[place];
    }

    /// What keeps people as far as `away` [m] from where they are wanted; none where they are near enough.
    std::optional<Standing> barAt(Vec2 wanted, double away) const {
        if (away <= kArrivedReach) return std::nullopt;
        const Standing found = bar(wanted);
        if (found == Standing::Crowded && away <= kShifted) return std::nullopt;
        return found;
    }

    Standing bar(Vec2 wanted) const { return barOf(state_, group_, group_.region, wanted); }

    const WorldState& state_;
    const Group& group_;
    const RouteGraph& routes_;
    const std::uint32_t second_;
    const bool held_;  // It was ordered to hold before its order was done.
    const bool goes_;
    std::vector<std::int32_t> unfit_;
    std::vector<Vec2> wanted_;  // By place: where the formation wants it [m].
    std::size_t next_ = 0;
};

}  // namespace

Standing barOf(const WorldState& state, const Group& group, std::int32_t region, Vec2 point) {
    const Environment& environment = state.environment;
    const RouteGraph& routes = state.routesOf(group);
    if (!environment.def().sides().contains(point)) return Standing::Outside;
    const double away = environment.distanceToObstacle(point, routes.radius());
    if (away <= 0.0) return Standing::Obstacle;
    const std::int32_t label = routes.region(point);
    if (label < 0) return away < routes.radius() ? Standing::Narrow : Standing::Outside;
    return region >= 0 && label != region ? Standing::NoWay : Standing::Crowded;
}

void judgeStandings(const WorldState& state, const Group& group, std::span<StandingReport> reports) {
    Judge judge(state, group);
    const Gathering* const gathering = state.continuum.find(group.id);
    const bool gathers = gathering != nullptr && (gathering->isBare() || gathering->active);
    for (const std::int32_t i : group.members) {
        const std::int32_t place = state.characters.place[i];
        if (gathers)
            reports[i] = judge.ofGathered(*gathering, i);
        else if (place >= 0 && std::cmp_less(place, group.places.positions().size()))
            reports[i] = judge.ofMatched(i, place);
        else
            reports[i] = judge.ofUnmatched(i);
    }
}

}  // namespace muster
