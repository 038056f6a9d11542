// A cost field: the cost of the cheapest path from any point to one source (paper eq. 5; SPEC A2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/unit_cost.h"
#include "engine/fields/eikonal/pseudo_source.h"

namespace muster {

/// The cost and direction of a field at a point.
struct FieldWay {
    double cost = 0.0;      ///< Cost of the cheapest path from the point.
    Vec2 direction;         ///< Unit vector along it; null where there is none.
    bool straight = false;  ///< True if the path is known to be a straight line up to a source.
};

/// The result of EikonalSolver::solve(), stored for the bounding rectangle of the cells that were reached.
class CostField {
public:
    /// Cost at `p`. Exact where all reached cells of the four around `p` have pseudo-sources; bilinear
    /// elsewhere. Infinite where none of the four is reached, or `p` is not finite.
    double cost(Vec2 p) const;
    /// Unit vector along the cheapest path at `p`, without any component towards cells that are not reached.
    /// Where none of the four cells around `p` is reached, it points to a reached cell near by; null where
    /// there is none.
    Vec2 direction(Vec2 p) const;
    /// Cost and direction at `p` at once.
    FieldWay way(Vec2 p) const;
    /// Value of a cell; infinite where not reached.
    float value(Cell cell) const;
    /// Square of the cost at `p`, interpolated bilinearly between the squares of reached cells around it;
    /// infinite where none is reached. On uniform ground squares interpolate well, since they have no kink at
    /// the source.
    double squaredCost(Vec2 p) const;
    /// Lowers the value of a cell; does nothing where `value` is not lower. The cell has no pseudo-source
    /// afterwards.
    void lowerValue(Cell cell, float value);
    /// Writes the corners of the path from `p` towards the source, as far as it is known to consist of
    /// straight lines: from the first after `p` on, without the source. Returns their number, at most that of
    /// `corners`; -1 where the path is not known.
    std::int32_t pathCorners(Vec2 p, std::span<Vec2> corners) const;
    /// The point of cost zero [m].
    Vec2 source() const { return source_; }
    /// The grid of the unit cost; values belong to the centres of its cells.
    const Grid& grid() const { return grid_; }
    /// Number of cells with a finite value.
    std::int32_t acceptedCount() const { return acceptedCount_; }
    /// Allocates for `cells` cells and `pseudoSources` pseudo-sources, so that solves need not.
    void reserve(std::size_t cells, std::size_t pseudoSources) {
        values_.reserve(cells);
        sourceOf_.reserve(cells);
        sources_.reserve(pseudoSources);
    }

private:
    friend class EikonalSolver;
    /// Indices of up to four different pseudo-sources.
    struct SourceSet {
        std::int32_t index[4];
        int count = 0;
        /// Position of an index in the set; -1 where it is not in it.
        int find(std::int32_t wanted) const {
            for (int k = 0; k < count; ++k)
                if (index[k] == wanted) return k;
            return -1;
        }
    };
    double exactCost(Vec2 p, Vec2& towards) const {
        std::int32_t ignored = 0;
        return exactCost(p, towards, ignored);
    }
    double exactCost(Vec2 p, Vec2& towards, std::int32_t& over) const;
    double squaredCostOfReached(Cell low, double fx, double fy) const;
    std::int32_t indexOf(Cell cell) const;
    SourceSet pseudoSourcesAround(Vec2 p) const;
    std::int32_t visibleSource(std::int32_t first, std::int32_t last, Vec2 at) const;
    std::int32_t pseudoSourceOf(Cell cell) const;
    double cornerValue(Cell low, int k, unsigned side) const;
    Vec2 descent(Vec2 p) const;
    Vec2 towardsReached(Vec2 p) const;
    float cheapestAcross(Cell low, Cell axis, std::int32_t along) const;
    bool risesBeyond(Cell low, double sign, Cell axis) const;
    double cheaperSide(Cell low, Cell axis) const;
    void findCuts(const UnitCost& cost);
    Vec2 nodeOf(Cell c) const;
    unsigned sameSide(Cell low, Vec2 p) const;
    // Value of corner k of a square of centres; infinite where it is none of those in `side`.
    float valueOf(Cell low, int k, unsigned side) const {
        return (side >> k & 1u) != 0 ? value({low.x + (k & 1), low.y + (k >> 1)}) : kUnreachableCost;
    }

    static constexpr unsigned kAllCorners = 15;
    /// The point where a body stands in a cell beside a wall.
    struct CutNode {
        std::int32_t cell = 0;     // Index of the cell in the grid.
        float x = 0.0f, y = 0.0f;  // Distance from its centre [cells].
    };

    Grid grid_;
    Vec2 source_;
    // The stored rectangle: lower left cell, columns and rows.
    Cell low_;
    std::int32_t width_ = 0;
    std::int32_t height_ = 0;
    std::int32_t acceptedCount_ = 0;
    double uniformRadius_ = 0.0;  // Radius within which all ground costs the same as the source's cell [m].
    CellCost sourceCost_;         // Unit cost of the source's cell.
    std::vector<float> values_;   // Values per stored cell.
    std::vector<std::uint16_t> sourceOf_;  // Per stored cell: index of its pseudo-source, 0 for none.
    std::vector<PseudoSource> sources_;    // Pseudo-sources by index; index 0 is none.
    // Per stored cell: whether a wall parts it from the next one. Empty where none does, and in fields that
    // have one source.
    std::vector<std::uint8_t> cuts_;
    std::vector<CutNode> cutNodes_;  // Nodes in ascending order of cells; empty with cuts_.
};

/// Traces the path from `from` to the field's source in steps of `step` [m], > 0, and writes its points, both
/// ends included. `path` is empty where the field does not reach `from`. Always ends; returns true where the
/// source was reached.
bool tracePath(const CostField& field, Vec2 from, double step, std::vector<Vec2>& path);

/// Length of a polyline [m].
double pathLength(const std::vector<Vec2>& path);

}  // namespace muster
