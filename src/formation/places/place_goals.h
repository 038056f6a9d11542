// Where characters can stand: targets made reachable.
#pragma once

#include <cmath>

#include "formation/places/place_tracker.h"

namespace muster {

/// Answers about room for one kind of character in one region of an environment.
class PlaceGround {
public:
    PlaceGround(const PlaceDef& def, const Environment& environment, std::int32_t region)
        : def_(def),
          environment_(environment),
          region_(region),
          inner_(environment.def().box.grown(-clearRadius())),
          grid_(environment.grid()),
          known_(environment.clearance()),
          unknown_(0.5 * std::sqrt(2.0) * grid_.cell + kRounding),
          undivided_(region < 0 || (region == 0 && environment.regionCount(def.radius) == 1)) {}

    /// Radius and clearance together [m].
    double clearRadius() const { return def_.radius + def_.clearance; }
    /// The cell that holds `p`, or the nearest to it.
    std::size_t cellOf(Vec2 p) const { return static_cast<std::size_t>(grid_.index(grid_.nearestCell(p))); }
    /// Nothing, the edge of the box included, lies nearer than this [m] to any point whose cell this is.
    /// Negative at the edge, and so for all points outside.
    double roomAt(std::size_t cell) const { return known_[cell] - unknown_; }
    /// True where nothing lies within `distance` [m] of `p` and the box holds `p` with its clearance.
    bool roomy(Vec2 p, double distance) const {
        return inner_.contains(p) && (roomAt(cellOf(p)) >= distance || roomyExactly(p, distance));
    }
    /// The point itself where a disc with clearance is free there and in the region; else the nearest such.
    Vec2 reachable(Vec2 p) const;
    /// The point itself with clearance, out of what is in the way by the nearest side, whatever the region.
    Vec2 pushed(Vec2 p) const { return environment_.projectToFreeSpace(p, clearRadius()); }
    /// True where a character can stand at `p` with clearance, in the region.
    bool standable(Vec2 p) const {
        // A cell with room for the character is in a region: in the only one, if there is only one.
        return (undivided_ && roomAt(cellOf(p)) >= clearRadius()) || standableByRegion(p);
    }

private:
    // Of clearances that are kept as floats [m].
    static constexpr double kRounding = 1e-5;

    bool roomyExactly(Vec2 p, double distance) const;
    bool standableByRegion(Vec2 p) const;
    // The cell of a point beside a wall may count as blocked though the point is free: then a
    // neighbouring cell must be in the region and in sight.
    bool inRegion(Vec2 p) const;

    const PlaceDef& def_;
    const Environment& environment_;
    std::int32_t region_;
    Box inner_;
    Grid grid_;
    std::span<const float> known_;  // Clearance of cells [m].
    // What the clearance anywhere in a cell may fall short of that of the cell [m].
    double unknown_;
    bool undivided_;  // All cells with room are in the region asked for.
};

/// Lines are tested with slightly less than the radius: places stand and ways run exactly at it.
inline double lineRadius(const PlaceDef& def) {
    return def.radius - std::fmin(1e-3, 0.01 * def.radius);
}

/// Finds free room near by for goals marked 0 in `fit`, a diameter from all others, and marks those that
/// found some with 1. They are tried in ascending order, until so many spots were looked at as a step allows.
void seatUnfit(const PlaceGround& ground, double apart, std::vector<Vec2>& goals,
               std::vector<std::uint8_t>& fit, SpacingMemory& memory);

}  // namespace muster
