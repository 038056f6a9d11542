// Straight ways on uniform ground: what is seen from where.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <vector>

#include "base/bits.h"
#include "cost/unit_cost.h"
#include "eikonal/pseudo_source.h"

namespace muster {

/// A root that rises over a wall by more than this is not hidden by it, and one below by more than kHidden is
/// [sine].
inline constexpr float kRisen = -1e-3f;
inline constexpr float kHidden = -0.35f;

/// What a straight way meets.
enum class Ray { Clear, Wall, OtherGround };

/// Answers whether straight ways on uniform ground are clear.
class LineOfSight {
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
        // Costs are above 0, so that equal ones have equal bits: two comparisons of integers do for four of
        // numbers.
        struct Pairs {
            std::uint64_t first, second;
        };
        const auto one = bitCast<std::uint32_t>(unit);
        const std::uint64_t two = static_cast<std::uint64_t>(one) << 32 | one;
        const auto c = bitCast<Pairs>(cost_->cells[cell]);
        return c.first == two && c.second == two;
    }
    /// True where all directions of a cell cost `unit`, as far as they are open.
    bool plain(std::int32_t cell, float unit) const {
        if (open(cell, unit)) return true;
        const std::int32_t number = wall_[cell];
        return number != 0 && node(number).unit == unit;
    }
    /// How far the root lies out of the wall beside the cell, whose point is (x, y): the sine of the angle
    /// over the wall; 1 where there is none.
    float rise(std::int32_t cell, float x, float y, const PseudoSource& root) const {
        const std::int32_t number = wall_[cell];
        if (number == 0) return 1.0f;
        const WallNode& beside = node(number);
        if (beside.normalX == 0.0f && beside.normalY == 0.0f) return 1.0f;
        const float dx = root.x - x;
        const float dy = root.y - y;
        return (dx * beside.normalX + dy * beside.normalY) / std::max(1e-6f, std::sqrt(dx * dx + dy * dy));
    }
    /// Looks from a point [cells] towards a root, cell by cell; `stop` is the cell where the way is not
    /// clear.
    Ray look(float x, float y, const PseudoSource& root, std::int32_t& stop) const;

private:
    Ray meets(float px, float py, float unit, bool& besideWall, std::int32_t& cell) const;

    const UnitCost* cost_ = nullptr;
    std::vector<std::int32_t> wall_;
};

}  // namespace muster
