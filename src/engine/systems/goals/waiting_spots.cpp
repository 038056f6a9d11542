#include "engine/systems/goals/waiting_spots.h"

#include <algorithm>
#include <cmath>

#include "engine/geometry/polygon.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/systems/events/standstill.h"

namespace muster {
namespace {

constexpr double kLeastSpotDistance = 1.2;  // Least distance of spots [diameters].
constexpr double kMostSpotDistance = 3.0;   // Greatest distance of spots [diameters].
constexpr double kSpotsFill = 0.75;         // Share of the area that the squares of all who wait fill.
// Step of the grid that finds room for most spots, in their least distance.
constexpr double kFineStep = 0.25;
constexpr double kSpotReach = 1.0;  // Distance to the area at which a person gets a spot [m].
// Time without progress after which a person stands before a full area [s].
constexpr double kFullAreaTime = 1.5;

// The least distance of spots [m] for people whose largest radius is `radius` [m].
double leastApart(double radius) {
    return kLeastSpotDistance * 2.0 * radius * (1.0 - 1e-9);
}

/// The nodes of a grid in the middle of a box, and which of them are too near others.
class NodeGrid {
public:
    NodeGrid(const Box& box, double step, std::vector<std::uint8_t>& near)
        : step_(step),
          columns_(static_cast<std::int32_t>(box.width() / step) + 1),
          rows_(static_cast<std::int32_t>(box.height() / step) + 1),
          near_(near) {
        const Vec2 used{(columns_ - 1) * step, (rows_ - 1) * step};
        origin_ = box.min + 0.5 * (box.max - box.min - used);
        near_.assign(static_cast<std::size_t>(columns_) * rows_, 0);
    }
    std::int32_t columns() const { return columns_; }
    std::int32_t rows() const { return rows_; }
    Vec2 node(std::int32_t x, std::int32_t y) const { return origin_ + Vec2{x * step_, y * step_}; }
    bool isFree(std::int32_t x, std::int32_t y) const { return near_[index(x, y)] == 0; }
    /// Takes nodes nearer than `apart` [m] to a point.
    void keepOff(Vec2 p, double apart) {
        const Vec2 at = (p - origin_) / step_;
        const double reach = apart / step_;
        const std::int32_t left = within(at.x - reach, columns_), right = within(at.x + reach + 1, columns_);
        const std::int32_t first = within(at.y - reach, rows_), last = within(at.y + reach + 1, rows_);
        for (std::int32_t y = first; y <= last; ++y)
            for (std::int32_t x = left; x <= right; ++x)
                if (distance(node(x, y), p) < apart) near_[index(x, y)] = 1;
    }

private:
    static std::int32_t within(double at, std::int32_t count) {
        return static_cast<std::int32_t>(std::clamp(at, 0.0, count - 1.0));
    }
    std::size_t index(std::int32_t x, std::int32_t y) const {
        return static_cast<std::size_t>(y) * columns_ + x;
    }

    double step_;
    std::int32_t columns_, rows_;
    Vec2 origin_;
    std::vector<std::uint8_t>& near_;
};

}  // namespace

WaitingSpots::Crowd WaitingSpots::crowdOf(const WorldState& state, AreaId area) {
    const Parameters::Character& usual = state.parameters.character;
    Crowd crowd{0, 0, usual.radius};
    for (const Group& group : state.groups) {
        const Gathering* const gathering = state.continuum.find(group.id);
        if (gathering == nullptr || gathering->kind != OrderKind::Wait || !gathering->active ||
            gathering->area != area)
            continue;
        crowd.people += group.members.size();
        for (const std::int32_t i : group.members) {
            crowd.radius = std::max(crowd.radius, radiusOf(usual, state.characters.body[i]));
            crowd.without += gathering->spotOf(state.characters.id[i]) == nullptr ? 1 : 0;
        }
    }
    return crowd;
}

// Lays spots on the nodes of a grid over the area, from its lower left corner on: each where there is room
// beside the spots that exist.
void WaitingSpots::lay(const WorldState& state, const Polygon& polygon, double radius, double step) {
    NodeGrid grid(boundsOf(polygon), step, nearOthers_);
    const double apart = leastApart(radius);
    free_.clear();
    for (const Vec2 spot : taken_) grid.keepOff(spot, apart);
    const Box inner = state.environment.def().box.grown(-radius);
    for (std::int32_t y = 0; y < grid.rows(); ++y)
        for (std::int32_t x = 0; x < grid.columns(); ++x) {
            const Vec2 p = grid.node(x, y);
            if (!grid.isFree(x, y) || !containsPoint(polygon, p) || !inner.contains(p) ||
                state.environment.distanceToObstacle(p, radius) < radius)
                continue;
            free_.push_back(p);
            grid.keepOff(p, apart);
        }
}

// Lays spots on a square grid, as far apart as the number of people allows. Where that leaves too few for the
// people who still come, as beside others who stand wider, it lays as many as there is room for.
void WaitingSpots::listFree(const WorldState& state, const Area& area, const Crowd& crowd) {
    const Polygon& polygon = area.def.polygon;
    const double diameter = 2.0 * crowd.radius, least = kLeastSpotDistance * diameter;
    const double people = std::max<double>(1.0, static_cast<double>(crowd.people));
    const double wide = std::sqrt(kSpotsFill * std::fabs(signedArea(polygon)) / people);
    const Box near = boundsOf(polygon).grown(least);
    taken_.clear();
    for (const Gathering& other : state.continuum.gatherings)
        for (const StandingSpot& spot : other.spots)
            if (near.contains(spot.spot)) taken_.push_back(spot.spot);
    lay(state, polygon, crowd.radius, std::clamp(wide, least, kMostSpotDistance * diameter));
    if (free_.size() < crowd.without) lay(state, polygon, crowd.radius, kFineStep * least);
}

// Gives free spots to members who have come; false where one of them found none.
bool WaitingSpots::takeSpots(const WorldState& state, const Group& group, Gathering& gathering,
                             const Area& area, const StaticGround& ground) {
    const Characters& c = state.characters;
    const Polygon& polygon = area.def.polygon;
    Crowd crowd;
    bool listed = false, all = true;
    for (const std::int32_t i : group.members) {
        if (gathering.spotOf(c.id[i]) != nullptr) continue;
        const Vec2 p = c.position[i];
        const Vec2 near = closestOnBoundary(polygon, p).point;
        const bool in = containsPoint(polygon, p) ||
                        (distance(near, p) < kSpotReach && ground.collisionFree(p, near));
        if (!in) continue;
        if (!listed) listFree(state, area, crowd = crowdOf(state, area.id));
        listed = true;
        // The first to come goes farthest in, so that it stands in nobody's path.
        const auto better = [&](Vec2 a, Vec2 b) { return lengthSquared(a - p) > lengthSquared(b - p); };
        auto best = free_.end();
        for (auto at = free_.begin(); at != free_.end(); ++at)
            if ((best == free_.end() || better(*at, *best)) && ground.collisionFree(p, *at)) best = at;
        if (best == free_.end()) {
            all = false;
            continue;
        }
        const Vec2 taken = *best;
        gathering.stand(c.id[i], taken);
        std::erase_if(free_, [&](Vec2 q) { return distance(q, taken) < leastApart(crowd.radius); });
    }
    return all;
}

void WaitingSpots::run(const WorldState& state, const Group& group, Gathering& gathering, const Area& area,
                       const StaticGround& ground) {
    const Characters& c = state.characters;
    std::erase_if(gathering.spots, [&](const StandingSpot& spot) {
        const std::int32_t i = c.indexOf(spot.character);
        return i < 0 || &state.groups[c.group[i]] != &group;
    });
    if (gathering.spots.size() == group.members.size()) return;
    if (takeSpots(state, group, gathering, area, ground)) {
        gathering.arrived.clear();
        return;
    }
    const std::uint32_t patience = stepsIn(state, kFullAreaTime);
    for (const std::int32_t i : group.members) {
        if (gathering.spotOf(c.id[i]) != nullptr || gathering.hasArrived(c.id[i])) continue;
        const double away = signedDistance(area.def.polygon, c.position[i]);
        if (away > kSpotReach && state.stepCount - c.walk[i].movedAt < patience) continue;
        gathering.arrived.insert(
            std::lower_bound(gathering.arrived.begin(), gathering.arrived.end(), c.id[i]), c.id[i]);
    }
}

}  // namespace muster
