// Solver of the eikonal equation |grad phi| = C by fast marching (paper eq. 5; SPEC A2; Sethian 1996), with
// pseudo-sources where the ground is uniform.
#pragma once

#include <memory>
#include <span>

#include "engine/fields/eikonal/cost_field.h"

namespace muster {

/// Parameters of the solver.
struct EikonalDef {
    bool secondOrder = true;  ///< Second-order upwind differences where two accepted neighbours allow them.
    /// Cells within this distance of a source on non-uniform ground get the cost along the straight line,
    /// where that is good enough [m], >= 0.
    double startRadius = 1.0;
    double margin = 1.5;  ///< The front goes on by this much cost beyond the farthest target, >= 0.
};

/// A cell from which a field begins.
struct FieldSeed {
    /// Behaviour of the field at the cell.
    enum class Kind : std::uint8_t {
        Fixed,   ///< The cell keeps its cost.
        Source,  ///< Every point that sees the cell goes straight to it.
        Front,   ///< The front goes on from it along the gradient of its neighbours' costs.
    };
    Cell cell;                 ///< Index of the cell; no seed in a wall.
    double cost = 0.0;         ///< Cost of the path from the cell on, >= 0.
    Kind kind = Kind::Source;  ///< Kind of the seed.
};

/// Computes cost fields. Owns the working memory: use one per thread. Repeated solves do not allocate once
/// warm.
class EikonalSolver {
public:
    explicit EikonalSolver(const EikonalDef& def = {});  ///< A solver with these parameters for its life.
    ~EikonalSolver();
    EikonalSolver(EikonalSolver&&) noexcept;
    EikonalSolver& operator=(EikonalSolver&&) noexcept;

    /// Marches from `source` until the cells around all reachable targets are accepted, and `margin` beyond;
    /// over all reachable ground where `targets` is empty. A source in a wall starts from the nearest free
    /// cells. Unreachable targets end with infinite cost, but make the front flood their region: where
    /// regions are known, give only targets of the source's region.
    void solve(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets, CostField& field);
    /// Marches from all seeds over all reachable ground.
    void solve(const UnitCost& cost, std::span<const FieldSeed> seeds, CostField& field);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
