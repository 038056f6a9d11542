// The point of a cell whose value a cost field holds, found from the clearance around it
// (docs/method/unit-cost.md); and walls thinner than a cell.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/grid.h"
#include "base/raster_view.h"

namespace muster {

/// Inputs of the ground cost, one value per cell.
struct GroundRasters {
    const Grid& grid;
    std::span<const float> clearance;  ///< Distance from the cell's centre to the nearest obstacle [m].
    RasterView travelSpeed;            ///< Speed relative to running, > 0.
};

/// The point of a cell whose value a cost field holds: the centre, or the wall node.
struct GroundNode {
    bool free = false;     ///< True if a character can be there.
    float x = 0.0f;        ///< Distance from the cell's centre along x [cells].
    float y = 0.0f;        ///< Distance from the cell's centre along y [cells].
    float normalX = 0.0f;  ///< Unit vector away from the wall; null where the node is the centre.
    float normalY = 0.0f;  ///< Unit vector away from the wall; null where the node is the centre.
};

/// Finds the nodes of cells from the clearance around them.
class GroundNodeFinder {
public:
    /// A finder for characters of `radius` [m]; the rasters must outlive it.
    GroundNodeFinder(const GroundRasters& ground, double radius) : ground_(ground), radius_(radius) {}
    /// The node of a cell; not free off the grid.
    GroundNode find(Cell cell) const;
    /// True where the cell and its four neighbours are free and have no wall nodes.
    bool farFromWalls(Cell cell) const {
        constexpr double kCells = 1.75;
        const Grid& grid = ground_.grid;
        return cell.x > 0 && cell.y > 0 && cell.x + 1 < grid.width && cell.y + 1 < grid.height &&
               ground_.clearance[grid.index(cell)] > radius_ + kCells * grid.cell;
    }

private:
    // Estimates of the clearance's slope along one axis [cells per cell].
    struct Slope {
        double wall = 0.0;    // Slope on one side, before a straight wall: the clearance is linear.
        double corner = 0.0;  // Slope on one side, round a corner: the clearance squared is quadratic.
        // Central slope, exact in both cases where both neighbours lie outside obstacles.
        double central = 0.0;
        bool bothOutside = false;  // True if both neighbours lie outside obstacles.
        std::int32_t outer = 0;    // The side, 1 or -1, on which the clearance is higher.
    };

    // The clearance of a cell; beyond the grid's edge the clearance of the nearest cell.
    double at(std::int32_t x, std::int32_t y) const {
        return ground_.clearance[ground_.grid.index(
            {std::clamp(x, 0, ground_.grid.width - 1), std::clamp(y, 0, ground_.grid.height - 1)})];
    }
    bool clearanceGradient(Cell cell, bool free, Vec2& gradient) const;
    Slope slopeOf(double here, Cell after, Cell before) const;
    Vec2 refineNormal(Cell cell, Vec2 coarse) const;

    const GroundRasters& ground_;
    double radius_;
};

/// True where the line from one point at a wall to another crosses a thin wall: the points lie on its two
/// sides, so that the line (dx, dy) enters the wall of one point and leaves the wall of the other. Normals
/// are unit vectors away from the walls, null for points that are not at a wall.
template <class From, class To>
bool crossesThinWall(const From& from, const To& to, float dx, float dy) {
    // The normals are more than 120 degrees apart, and the line meets both walls at more than 30 degrees.
    constexpr float kHalf = 0.5f;
    if (from.normalX * to.normalX + from.normalY * to.normalY >= -kHalf) return false;
    const float most = -kHalf * std::sqrt(dx * dx + dy * dy);
    return dx * from.normalX + dy * from.normalY < most && -(dx * to.normalX + dy * to.normalY) < most;
}

}  // namespace muster
