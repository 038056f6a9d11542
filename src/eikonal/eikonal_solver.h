// Cost fields: |grad phi| = C by fast marching (SPEC A2, paper eq. 5).
#pragma once

#include <memory>
#include <span>

#include "eikonal/cost_field.h"

namespace muster {

/// Options of a solve.
struct EikonalDef {
    bool secondOrder = true;  ///< Second-order upwind differences where two accepted neighbours allow it.
    /// Straight-line costs are exact within it where the ground is clear and uniform [m] >= 0.
    double startRadius = 1.0;
    double margin = 1.5;  ///< The front goes on this much cost beyond the farthest target >= 0.
};

/// Owns the working memory; one per thread. Repeated solves do not allocate once warm.
class EikonalSolver {
public:
    explicit EikonalSolver(const EikonalDef& def = {});  ///< With these options for its life.
    ~EikonalSolver();
    EikonalSolver(EikonalSolver&&) noexcept;  ///< Moves.
    EikonalSolver& operator=(EikonalSolver&&) noexcept;

    /// Marches from `source` until every reachable target's surrounding cells are accepted, and `margin`
    /// beyond; over the whole reachable ground where `targets` is empty. A source in a wall cell starts from
    /// the nearest free cells. Unreachable targets end with infinite cost: give only targets of the same
    /// region where that can be known, or the front floods the region.
    void solve(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets, CostField& field);

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace muster
