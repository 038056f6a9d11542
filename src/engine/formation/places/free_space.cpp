#include "engine/formation/places/free_space.h"

namespace muster {
namespace {

// Distances are evaluated this much beyond the limit of interest [m].
constexpr double kDistanceMargin = 1e-3;
// Depth inside an obstacle from which on a point is not projected out of it [m].
constexpr double kDeepInside = 1.0;

}  // namespace

bool FreeSpace::isClearExactly(Vec2 p, double distance) const {
    return environment_.distanceToObstacle(p, distance + kDistanceMargin) >= distance;
}

bool FreeSpace::inRegion(Vec2 p) const {
    return region_ < 0 || routes_.region(p) == region_;
}

// Where the point itself is blocked, the free ground nearest to it counts.
bool FreeSpace::isCutOff(Vec2 p) const {
    if (undivided_) return false;
    const std::int32_t region = routes_.region(p);
    return (region >= 0 ? region : routes_.region(nearest_.find(routes_, p, -1))) != region_;
}

bool FreeSpace::containsExactly(Vec2 p) const {
    // In an undivided world contains() has already tried the raster.
    const bool clear = undivided_ ? inner_.contains(p) && clearanceMayReach(p, cellOf(p), clearRadius()) &&
                                        isClearExactly(p, clearRadius())
                                  : isClear(p, clearRadius());
    return clear && inRegion(p);
}

Vec2 FreeSpace::nearest(Vec2 p) const {
    if (contains(p)) return p;
    // Deep inside obstacles a projection costs more than the remembered ground of the region.
    if (region_ < 0 || clearanceAt(cellOf(p)) > -kDeepInside) {
        const Vec2 projected = environment_.projectToFreeSpace(p, clearRadius());
        if (inRegion(projected)) return projected;
    }
    const Vec2 inside = nearest_.find(routes_, p, region_);
    // The cell's centre may lack clearance. It is returned as it is where gaining clearance would leave the
    // region.
    const Vec2 clear = environment_.projectToFreeSpace(inside, clearRadius());
    return inRegion(clear) ? clear : inside;
}

}  // namespace muster
