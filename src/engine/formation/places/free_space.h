// The free space of a character: the points where it can stand (configuration space of a disc, Lozano-Pérez
// 1983).
#pragma once

#include <cmath>
#include <span>

#include "engine/ground/environment/environment.h"
#include "engine/ground/routes/nearest_reachable.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Bounds of the places of one group. Radius and separation are those of its members, which no parameters
/// hold.
struct PlaceDef {
    /// Radius of the characters [m], above 0.
    double radius = Parameters::Character{}.radius;
    /// Distance kept from obstacles beyond the radius [m], 0 or more.
    double clearance = Parameters::Place{}.clearance;
    /// Top speed of places [m/s], above 0; multiplied by the ground's travel speed.
    double maxSpeed = Parameters::Place{}.speed;
    /// Least distance between reachable targets [m]; 0 for a diameter.
    double separation = 0.0;

    /// The least distance between reachable targets in metres.
    double apart() const { return separation > 0.0 ? separation : 2.0 * radius; }
};

/// The free space of one kind of character in one region of an environment.
class FreeSpace {
public:
    /// `region` is a label of RouteGraph::region(), or -1 for all regions; `routes` are those of the radius.
    /// `nearest` must have no other user meanwhile.
    FreeSpace(const PlaceDef& def, const RouteGraph& routes, std::int32_t region, NearestReachable& nearest)
        : def_(def),
          environment_(routes.environment()),
          routes_(routes),
          nearest_(nearest),
          region_(region),
          inner_(environment_.def().box.grown(-clearRadius())),
          grid_(environment_.grid()),
          clearance_(environment_.clearance()),
          clearanceError_(0.5 * std::sqrt(2.0) * grid_.cell + kRoundingError),
          undivided_(region < 0 || (region == 0 && routes.regionCount() == 1)) {}

    const RouteGraph& routes() const { return routes_; }  ///< The given routes.
    std::int32_t region() const { return region_; }       ///< The given region.
    /// Radius and clearance together [m].
    double clearRadius() const { return def_.radius + def_.clearance; }
    /// Index of the cell that holds `p`, or of the nearest to it.
    std::int32_t cellOf(Vec2 p) const { return grid_.index(grid_.nearestCell(p)); }
    /// A lower bound of the distance from any point whose cell this is to obstacles and to the edge of the
    /// box [m]. Negative at the edge, and so for all points outside.
    double clearanceAt(std::int32_t cell) const { return clearance_[cell] - clearanceError_; }
    /// True where no obstacle lies within `distance` [m] of `p`, and the box holds `p` with its clearance.
    bool isClear(Vec2 p, double distance) const {
        if (!inner_.contains(p)) return false;
        const std::int32_t cell = cellOf(p);
        if (clearanceAt(cell) >= distance) return true;
        return clearanceMayReach(p, cell, distance) && isClearExactly(p, distance);
    }
    /// True where a character can stand at `p` with clearance, in the region.
    bool contains(Vec2 p) const {
        // A cell with enough clearance lies in a region, and where there is only one, in that.
        return (undivided_ && clearanceAt(cellOf(p)) >= clearRadius()) || containsExactly(p);
    }
    /// `p` where the free space contains it, else a near point of the free space. Not from several threads.
    Vec2 nearest(Vec2 p) const;
    /// True where all free ground is in the region.
    bool undivided() const { return undivided_; }
    /// True where the ground at `p` is cut off from the region. Not from several threads.
    bool isCutOff(Vec2 p) const;
    /// The nearest ground of the region. Not from several threads.
    Vec2 nearestInRegion(Vec2 p) const { return nearest_.find(routes_, p, region_); }
    /// `p` projected out of obstacles with clearance, whatever the region.
    Vec2 project(Vec2 p) const { return environment_.projectToFreeSpace(p, clearRadius()); }

private:
    // Bound on the rounding error of clearances, which are kept as floats [m].
    static constexpr double kRoundingError = 1e-5;

    // False where the clearance of the cell of `p` tells that an obstacle is nearer than `distance`.
    bool clearanceMayReach(Vec2 p, std::int32_t cell, double distance) const {
        const double most = clearance_[cell] + clearanceError_;
        if (most >= distance || clearance_[cell] >= Environment::kClearanceLimit - kRoundingError)
            return true;
        // It counts the edge of the box, too, which is no obstacle here.
        const Box& box = environment_.def().box;
        return std::fmin(std::fmin(p.x - box.min.x, box.max.x - p.x),
                         std::fmin(p.y - box.min.y, box.max.y - p.y)) <= most;
    }
    bool isClearExactly(Vec2 p, double distance) const;
    bool containsExactly(Vec2 p) const;
    bool inRegion(Vec2 p) const;

    const PlaceDef& def_;
    const Environment& environment_;
    const RouteGraph& routes_;
    NearestReachable& nearest_;
    std::int32_t region_;
    Box inner_;  // The box for characters with clearance [m].
    Grid grid_;
    std::span<const float> clearance_;  // Clearance of cell centres [m].
    double clearanceError_;  // Most by which a point's clearance is below that of its cell's centre [m].
    bool undivided_;         // True where all cells with enough clearance are in the region.
};

/// Radius for tests of lines [m]: slightly below the radius, because places stand and paths run exactly at
/// it.
inline double lineRadius(const PlaceDef& def) {
    return def.radius - std::fmin(1e-3, 0.01 * def.radius);
}

}  // namespace muster
