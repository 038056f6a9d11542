#include "engine/state/standing_room.h"

#include <cmath>
#include <limits>

#include "engine/formation/places/ring_search.h"

namespace muster {
namespace {

constexpr double kWidest = 64.0;       // Of the separation of rings, in diameters.
constexpr double kStandingGap = 1.01;  // Between two who join, in diameters.

}  // namespace

StandingRoom::CellKey StandingRoom::cellOf(Vec2 p) const {
    const double edge = 2.0 * kStandingGap * radius_;
    return {static_cast<std::int32_t>(std::floor(p.x / edge)),
            static_cast<std::int32_t>(std::floor(p.y / edge))};
}

bool StandingRoom::isOccupied(Vec2 p) const {
    const double least = 2.0 * kStandingGap * radius_;
    const CellKey cell = cellOf(p);
    for (std::int32_t x = cell.first - 1; x <= cell.first + 1; ++x)
        for (std::int32_t y = cell.second - 1; y <= cell.second + 1; ++y)
            if (const auto found = standing_.find({x, y}); found != standing_.end())
                for (const Vec2 other : found->second)
                    if (lengthSquared(other - p) < least * least) return true;
    return false;
}

Vec2 StandingRoom::take(Vec2 wanted) {
    const Vec2 nearest = environment_.projectToFreeSpace(wanted, radius_);
    Vec2 spot = nearest;
    bool found = !isOccupied(nearest);
    const auto accept = [&](Vec2 p) {
        spot = environment_.projectToFreeSpace(p, radius_);
        return !isOccupied(spot);
    };
    std::int32_t ignored = 0;
    for (double width = 1.0; !found && width <= kWidest; width *= 2.0)
        found = searchRings(nearest, 2.0 * kStandingGap * radius_ * width,
                            std::numeric_limits<double>::infinity(), ignored, accept);
    if (!found) spot = nearest;
    occupy(spot);
    return spot;
}

}  // namespace muster
