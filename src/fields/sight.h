// Straight ways on uniform ground: what is seen from where.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "muster/fields/unit_cost.h"

namespace muster {

/// A point from which ways go straight on: the source, or a place at a wall where they bend.
struct Root {
    float x = 0.0f;     ///< From the centre of cell (0, 0) [cells].
    float y = 0.0f;     ///< From the centre of cell (0, 0) [cells].
    float cost = 0.0f;  ///< Cost to the source.
    float unit = 0.0f;  ///< Cost of a metre round it.
    float normalX = 0.0f;  ///< Unit vector out of the wall that it stands at; null for the source.
    float normalY = 0.0f;  ///< Unit vector out of the wall that it stands at; null for the source.
    std::int32_t parent = 0;  ///< Number of the root that it is seen from; 0 for the source.

    /// How far a point rises over the wall that the root stands at, as a sine; 1 where it stands at none.
    float rise(float px, float py) const {
        if (normalX == 0.0f && normalY == 0.0f) return 1.0f;
        const float dx = px - x;
        const float dy = py - y;
        return (dx * normalX + dy * normalY) / std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Cost at a point that the root sees.
    float costAt(float px, float py) const {
        const float dx = px - x;
        const float dy = py - y;
        return cost + unit * std::sqrt(dx * dx + dy * dy);
    }
};

/// A root that rises over a wall by more than this is not hidden by it, and one below by more than kHidden is [sine].
inline constexpr float kRisen = -1e-3f;
inline constexpr float kHidden = -0.35f;

/// What a straight way meets.
enum class Ray { Clear, Wall, OtherGround };

/// Answers whether straight ways on uniform ground are clear.
class Sight {
public:
    /// Starts on these costs.
    void begin(const UnitCost& cost);
    /// Drops what begin() noted.
    void end();
    /// Number of the wall node of a cell plus one; 0 where it has none.
    std::int32_t wall(std::int32_t cell) const { return wall_[cell]; }
    /// The node with that number.
    const WallNode& node(std::int32_t number) const { return cost_->nodes[number - 1]; }
    /// True where all directions of a cell are open and cost `unit`.
    bool open(std::int32_t cell, float unit) const {
        const CellCost& c = cost_->cells[cell];
        return c.east == unit && c.north == unit && c.west == unit && c.south == unit;
    }
    /// True where all directions of a cell cost `unit`, as far as they are open.
    bool plain(std::int32_t cell, float unit) const {
        if (open(cell, unit)) return true;
        const std::int32_t number = wall_[cell];
        return number != 0 && node(number).unit == unit;
    }
    /// How far the root lies out of the wall beside the cell, whose point is (x, y): the sine of the angle over the
    /// wall; 1 where there is none.
    float rise(std::int32_t cell, float x, float y, const Root& root) const {
        const std::int32_t number = wall_[cell];
        if (number == 0) return 1.0f;
        const WallNode& beside = node(number);
        if (beside.normalX == 0.0f && beside.normalY == 0.0f) return 1.0f;
        const float dx = root.x - x;
        const float dy = root.y - y;
        return (dx * beside.normalX + dy * beside.normalY) / std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Looks from a point [cells] towards a root, cell by cell.
    Ray look(float x, float y, const Root& root) const;

private:
    Ray meets(float px, float py, float unit, bool& besideWall) const;

    const UnitCost* cost_ = nullptr;
    std::vector<std::int32_t> wall_;
};

}  // namespace muster
