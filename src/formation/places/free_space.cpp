#include "formation/places/free_space.h"

namespace muster {
namespace {

// Distances are evaluated this much beyond the limit of interest [m].
constexpr double kDistanceMargin = 1e-3;

}  // namespace

bool FreeSpace::isClearExactly(Vec2 p, double distance) const {
    return environment_.distanceToObstacle(p, distance + kDistanceMargin) >= distance;
}

// The cell of a point beside a wall may count as blocked though the point is free: then a neighbouring cell
// must be in the region, and the line to its centre clear.
bool FreeSpace::inRegion(Vec2 p) const {
    if (region_ < 0) return true;
    const std::int32_t label = environment_.region(p, def_.radius);
    if (label >= 0) return label == region_;
    const Grid& grid = environment_.grid();
    const Cell cell = grid.nearestCell(p);
    for (std::int32_t y = cell.y - 1; y <= cell.y + 1; ++y) {
        for (std::int32_t x = cell.x - 1; x <= cell.x + 1; ++x) {
            if (!grid.contains({x, y})) continue;
            const Vec2 centre = grid.centre({x, y});
            if (environment_.region(centre, def_.radius) == region_ &&
                environment_.clearLine(p, centre, lineRadius(def_)))
                return true;
        }
    }
    return false;
}

bool FreeSpace::containsExactly(Vec2 p) const {
    // In an undivided world contains() has already tried the raster.
    const bool clear = undivided_ ? inner_.contains(p) && isClearExactly(p, clearRadius())
                                  : isClear(p, clearRadius());
    return clear && inRegion(p);
}

Vec2 FreeSpace::nearest(Vec2 p) const {
    if (contains(p)) return p;
    const Vec2 projected = environment_.projectToFreeSpace(p, clearRadius());
    if (inRegion(projected)) return projected;
    const Vec2 inside = environment_.nearestInRegion(p, def_.radius, region_);
    // The cell's centre may lack clearance. It is returned as it is where gaining clearance would leave the
    // region.
    const Vec2 clear = environment_.projectToFreeSpace(inside, clearRadius());
    return inRegion(clear) ? clear : inside;
}

}  // namespace muster
