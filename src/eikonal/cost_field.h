// Cost fields: |grad phi| = C by fast marching (SPEC A2, paper eq. 5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "cost/unit_cost.h"
#include "eikonal/pseudo_source.h"

namespace muster {

/// The cost to reach `source`, stored for the part of the grid that was marched.
class CostField {
public:
    /// Cost from `p`: where the reached ones among the four cells around know the points their straight ways
    /// come from, the cheapest way from these; else bilinear. Infinite where none is reached, or `p` is not
    /// finite.
    double cost(Vec2 p) const;
    /// The unit direction of the cheapest way at `p`, without any part that leads into cells not reached.
    /// Where none of the four cells around is reached, it leads to a reached one near by; zero where there is
    /// none.
    Vec2 direction(Vec2 p) const;
    /// Value of a cell; infinite where not reached.
    float value(Cell cell) const;
    /// Square of the cost at `p`, interpolated between the four centres around it, of which only those
    /// reached count; infinite where none is. On uniform ground squares are what interpolates well: they have
    /// no kink at the source.
    double squaredCost(Vec2 p) const;
    /// Lowers the value of a cell from outside; where its way comes from is not known any more. Nothing where
    /// it is not lower.
    void lowerValue(Cell cell, float value);
    /// Corners of the way from `p` to the source as far as it is known to be made of straight lines, from the
    /// first after `p` on, the source left out. Returns their number, at most `most`; -1 where the way is not
    /// known.
    std::int32_t pathCorners(Vec2 p, std::span<Vec2> corners) const;
    /// Where the cost is zero [m].
    Vec2 source() const { return source_; }
    /// The ground cells whose centres bear the values.
    const Grid& grid() const { return grid_; }
    /// Number of cells with a value.
    std::int32_t acceptedCount() const { return acceptedCount_; }
    /// Makes room for so many cells and for as many points that straight ways come from, so that solves need
    /// none.
    void reserve(std::size_t cells, std::size_t roots) {
        values_.reserve(cells);
        root_.reserve(cells);
        roots_.reserve(roots);
    }

private:
    friend class EikonalSolver;
    /// Numbers of different roots.
    struct Roots {
        std::int32_t number[4];
        int count = 0;
        /// Where the number stands among them; -1 where it does not.
        int find(std::int32_t wanted) const {
            for (int k = 0; k < count; ++k)
                if (number[k] == wanted) return k;
            return -1;
        }
    };
    // The cheapest of the ways from the roots around a point, exact also where two ways meet, and the vector
    // to that root [cells]. Infinite where not all that is known around the point comes straight from roots.
    double straightCostAt(Vec2 p, Vec2& towards) const;
    double squareOfKnown(Cell low, double fx, double fy) const;
    std::int32_t indexOf(Cell cell) const;
    Roots rootsAround(Vec2 p) const;
    std::int32_t seenRoot(std::int32_t first, std::int32_t last, Vec2 at) const;
    std::int32_t rootOf(Cell cell) const;
    Vec2 towardsReached(Vec2 p) const;
    double cornerValue(Cell low, int k) const;
    float cheapestAcross(Cell low, Cell axis, std::int32_t along) const;
    bool risesAhead(Cell low, double sign, Cell axis) const;
    double sideStep(Cell low, Cell axis) const;

    Grid grid_;  // Of the whole ground.
    Vec2 source_;
    Cell low_;                // Lower left cell of the stored window.
    std::int32_t width_ = 0;  // Of the window.
    std::int32_t height_ = 0;
    std::int32_t acceptedCount_ = 0;
    double nearRadius_ = 0.0;  // Straight-line costs hold within it [m].
    CellCost nearCost_;        // Of the source's cell.
    std::vector<float> values_;
    // Straight ways: the number of the root that each value comes from, 0 for none, and the roots.
    std::vector<std::uint16_t> root_;
    std::vector<PseudoSource> roots_;
};

}  // namespace muster
