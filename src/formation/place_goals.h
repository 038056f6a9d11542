// Where characters can stand: targets made reachable.
#pragma once

#include <cmath>

#include "muster/formation/place_tracker.h"

namespace muster {

/// Answers about room for one kind of character in one region of an environment.
class PlaceGround {
public:
    PlaceGround(const PlaceDef& def, const Environment& environment, std::int32_t region)
        : def_(def), environment_(environment), region_(region), inner_(environment.def().box.grown(-clearRadius())),
          cellReach_(0.5 * std::sqrt(2.0) * environment.grid().cell) {}

    /// Radius and clearance together [m].
    double clearRadius() const { return def_.radius + def_.clearance; }
    /// True where nothing lies within `distance` [m] of `p` and the box holds `p` with its clearance:
    /// answered by the raster where that suffices.
    bool roomy(Vec2 p, double distance) const;
    /// The point itself where a disc with clearance is free there and in the region; else the nearest such.
    Vec2 reachable(Vec2 p) const;
    /// The point itself with clearance, out of what is in the way by the nearest side, whatever the region.
    Vec2 pushed(Vec2 p) const { return environment_.pushOut(p, clearRadius()); }
    /// True where a character can stand at `p` with clearance, in the region.
    bool standable(Vec2 p) const { return roomy(p, clearRadius()) && inRegion(p); }

private:
    // The cell of a point beside a wall may count as blocked though the point is free: then a
    // neighbouring cell must be in the region and in sight.
    bool inRegion(Vec2 p) const;

    const PlaceDef& def_;
    const Environment& environment_;
    std::int32_t region_;
    Box inner_;
    double cellReach_;
};

/// Lines are tested with slightly less than the radius: places stand and ways run exactly at it.
inline double lineRadius(const PlaceDef& def) { return def.radius - std::fmin(1e-3, 0.01 * def.radius); }

/// Finds free room near by for goals marked 0 in `fit`, a diameter from all others, and marks those that
/// found some with 1. They are tried in ascending order, until so many spots were looked at as a step allows.
void seatUnfit(const PlaceGround& ground, double apart, std::vector<Vec2>& goals, std::vector<std::uint8_t>& fit,
               SpacingMemory& memory);

}  // namespace muster
