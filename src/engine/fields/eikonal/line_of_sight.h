// Lines of sight on uniform ground, on the cells of a unit cost.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/maths.h"
#include "engine/fields/cost/unit_cost.h"
#include "engine/fields/eikonal/pseudo_source.h"

namespace muster {

/// Elevation of a pseudo-source above the tangent of a wall from which on the wall never occludes it [sine].
inline constexpr float kVisibleElevation = -1e-3f;
/// Elevation of a pseudo-source below which a wall always occludes it [sine].
inline constexpr float kOccludedElevation = -0.35f;

/// The obstruction that a straight line meets.
enum class Visibility {
    Clear,        ///< Free and uniform ground only.
    Wall,         ///< A wall.
    OtherGround,  ///< Ground of another unit cost.
};

/// Answers queries about lines of sight over one unit cost.
class LineOfSight {
public:
    /// Starts queries on this unit cost, which has to stay until end().
    void begin(const UnitCost& cost);
    /// Ends the queries.
    void end();
    /// One plus the index of the wall node of a cell; 0 where it has none.
    std::int32_t wall(std::int32_t cell) const { return wall_[cell]; }
    /// True for a narrow cell (WallNode::narrow()); false off the grid.
    bool narrow(std::int32_t cell) const {
        return hasNarrow_ && static_cast<std::size_t>(cell) < wall_.size() && wall_[cell] != 0 &&
               node(wall_[cell]).narrow();
    }
    /// The wall node of a number from wall().
    const WallNode& node(std::int32_t number) const { return cost_->nodes[number - 1]; }
    /// True where a cell can be left in all directions at the cost `unit`.
    bool open(std::int32_t cell, float unit) const {
        // Costs are positive, so that equal costs have equal bits: two comparisons of integers replace four
        // of floats.
        struct Pairs {
            std::uint64_t first, second;
        };
        const auto one = bitCast<std::uint32_t>(unit);
        const std::uint64_t two = static_cast<std::uint64_t>(one) << 32 | one;
        const auto c = bitCast<Pairs>(cost_->cells[cell]);
        return c.first == two && c.second == two;
    }
    /// True where all directions in which a cell can be left have the unit cost `unit`.
    bool uniform(std::int32_t cell, float unit) const {
        if (open(cell, unit)) return true;
        const std::int32_t number = wall_[cell];
        return number != 0 && node(number).unit == unit;
    }
    /// Elevation of a pseudo-source above the tangent of the wall at a cell, seen from the cell's point (x,
    /// y): the sine of the angle; 1 where there is no wall.
    float elevation(std::int32_t cell, float x, float y, const PseudoSource& source) const {
        const std::int32_t number = wall_[cell];
        if (number == 0) return 1.0f;
        const WallNode& wallNode = node(number);
        if (wallNode.normalX == 0.0f && wallNode.normalY == 0.0f) return 1.0f;
        const float dx = source.x - x;
        const float dy = source.y - y;
        return (dx * wallNode.normalX + dy * wallNode.normalY) /
               std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Traces the line from the point (x, y) [cells] to a pseudo-source. `stop` is the cell of the last
    /// sample: the one at which the line is not clear.
    Visibility trace(float x, float y, const PseudoSource& source, std::int32_t& stop) const;

private:
    Visibility sample(float px, float py, float unit, bool& nearWall, std::int32_t& cell) const;

    const UnitCost* cost_ = nullptr;
    bool hasNarrow_ = false;
    std::vector<std::int32_t> wall_;  // Values of wall() per cell.
};

}  // namespace muster
