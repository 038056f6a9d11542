#include "engine/fields/eikonal/eikonal_solver.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bilinear.h"
#include "engine/fields/eikonal/front.h"
#include "engine/fields/eikonal/source_initialisation.h"
#include "muster/assert.h"

namespace muster {

struct EikonalSolver::Impl {
    EikonalDef def;
    Front front;
    SourceInitialiser initialiser;
    std::vector<FrontCell> targetCells;  // Cells around the targets that are not walls.

    void findTargetCells(const UnitCost& cost, std::span<const Vec2> targets);
    double targetDistance(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets) const;
    void march(double cell, bool bounded);
    Cell reachedBounds(const Grid& grid, Cell& high) const;
    void copyValues(Cell low, Cell high, CostField& field) const;
    void setCentreValues(const UnitCost& cost, Cell low, Cell high, CostField& field) const;
    void finish(const UnitCost& cost, CostField& field);
};

void EikonalSolver::Impl::findTargetCells(const UnitCost& cost, std::span<const Vec2> targets) {
    targetCells.clear();
    for (const Vec2 target : targets) {
        if (!isFinite(target)) continue;
        const BilinearStencil stencil = bilinearStencil(cost.grid, target);
        for (const std::int32_t index : stencil.cell) {
            if (!cost.wall(index)) targetCells.push_back(front.at(cost.grid.at(index)));
        }
    }
}

// Distance of the farthest target from the source, with the margin [m]; infinite without targets.
double EikonalSolver::Impl::targetDistance(const UnitCost& cost, Vec2 source,
                                           std::span<const Vec2> targets) const {
    if (targets.empty()) return kUnreachableCost;
    double farthest = 0.0;
    for (const Vec2 target : targets) {
        if (isFinite(target)) farthest = std::max(farthest, distance(cost.grid.box().clamp(target), source));
    }
    return farthest + 2.0 * cost.grid.cell + def.margin / cost.lowest;
}

// Marches until all target cells are final and the front is the margin beyond them, or until nothing is left.
void EikonalSolver::Impl::march(double cell, bool bounded) {
    std::size_t reached = 0;
    float stop = kUnreachableCost;
    while (front.level() <= stop && front.step()) {
        if (!bounded || stop < kUnreachableCost) continue;
        while (reached < targetCells.size() && front.value(targetCells[reached].node) < kUnreachableCost)
            ++reached;
        if (reached < targetCells.size()) continue;
        // Values from pseudo-sources may be ahead of the front.
        stop = front.level();
        for (const FrontCell at : targetCells) stop = std::max(stop, front.value(at.node));
        stop += static_cast<float>(def.margin / cell);
    }
}

// The bounding rectangle of all reached cells; high lies below low where there are none.
Cell EikonalSolver::Impl::reachedBounds(const Grid& grid, Cell& high) const {
    Cell low{grid.width, grid.height};
    high = {-1, -1};
    for (std::int32_t y = front.firstRow(); y <= front.lastRow(); ++y) {
        const FrontNode* row = front.row(y);
        std::int32_t left = 0;
        while (left < low.x && !(row[left].accepted < kUnreachableCost)) ++left;
        std::int32_t right = grid.width - 1;
        while (right > high.x && !(row[right].accepted < kUnreachableCost)) --right;
        const bool widened = left < low.x || right > high.x;
        low.x = std::min(low.x, left);
        high.x = std::max(high.x, right);
        bool any = widened;
        for (std::int32_t x = low.x; !any && x <= high.x; ++x) any = row[x].accepted < kUnreachableCost;
        if (!any) continue;
        low.y = std::min(low.y, y);
        high.y = y;
    }
    return low;
}

EikonalSolver::EikonalSolver(const EikonalDef& def) : impl_(std::make_unique<Impl>()) {
    MUSTER_ASSERT(def.startRadius >= 0.0 && def.margin >= 0.0);
    impl_->def = def;
}
EikonalSolver::~EikonalSolver() = default;
EikonalSolver::EikonalSolver(EikonalSolver&&) noexcept = default;
EikonalSolver& EikonalSolver::operator=(EikonalSolver&&) noexcept = default;

void EikonalSolver::solve(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets,
                          CostField& field) {
    MUSTER_ASSERT(std::cmp_equal(cost.cells.size(), cost.grid.count()));
    Impl& work = *impl_;
    const Grid& grid = cost.grid;
    field.grid_ = grid;
    field.source_ = grid.box().clamp(isFinite(source) ? source : grid.origin);
    work.front.resize(grid);
    work.front.begin(cost, work.def.secondOrder);
    work.findTargetCells(cost, targets);
    const double reach = work.targetDistance(cost, field.source_, targets);
    work.initialiser.start(cost, field.source_, work.def.startRadius, reach, work.front);
    field.uniformRadius_ = work.initialiser.radius();
    field.sourceCost_ = cost.cells[grid.index(grid.nearestCell(field.source_))];
    work.march(grid.cell, !targets.empty());
    work.finish(cost, field);
}

void EikonalSolver::solve(const UnitCost& cost, std::span<const FieldSeed> seeds, CostField& field) {
    MUSTER_ASSERT(std::cmp_equal(cost.cells.size(), cost.grid.count()));
    Impl& work = *impl_;
    const Grid& grid = cost.grid;
    field.grid_ = grid;
    // No single point is the source, so that no point counts as near it.
    field.source_ = grid.origin - Vec2{grid.box().width(), grid.box().height()};
    field.uniformRadius_ = 0.0;
    work.front.resize(grid);
    work.front.begin(cost, work.def.secondOrder);
    work.targetCells.clear();
    for (const FieldSeed& seed : seeds) {
        const auto value = static_cast<float>(seed.cost / grid.cell);
        if (seed.kind == FieldSeed::Kind::Source)
            work.front.seedSource(seed.cell, value);
        else
            work.front.seed(seed.cell, value, seed.kind == FieldSeed::Kind::Fixed ? kFixedValue : 0);
    }
    work.march(grid.cell, false);
    work.finish(cost, field);
    field.findCuts(cost);
}

// Copies the reached cells to the field.
void EikonalSolver::Impl::finish(const UnitCost& cost, CostField& field) {
    Cell high;
    const Cell low = reachedBounds(cost.grid, high);
    copyValues(low, high, field);
    setCentreValues(cost, low, high, field);
    front.end(low, high);
}

void EikonalSolver::Impl::copyValues(Cell low, Cell high, CostField& field) const {
    field.low_ = low;
    field.cuts_.clear();
    field.cutNodes_.clear();
    field.width_ = std::max(0, high.x - low.x + 1);
    field.height_ = std::max(0, high.y - low.y + 1);
    field.values_.resize(static_cast<std::size_t>(field.width_) * field.height_);
    field.sourceOf_.resize(field.values_.size());
    field.sources_ = front.pseudoSources();
    field.acceptedCount_ = 0;
    const auto edge = static_cast<float>(field.grid_.cell);
    for (std::int32_t y = 0; y < field.height_; ++y) {
        const FrontNode* row = front.row(low.y + y) + low.x;
        float* out = field.values_.data() + static_cast<std::size_t>(y) * field.width_;
        std::uint16_t* sourceOut = field.sourceOf_.data() + static_cast<std::size_t>(y) * field.width_;
        std::int32_t accepted = 0;
        for (std::int32_t x = 0; x < field.width_; ++x) {
            const std::int32_t source = row[x].source;
            out[x] = row[x].accepted * edge;
            sourceOut[x] = static_cast<std::uint16_t>(source > 0 && source <= 0xffff ? source : 0);
            accepted += row[x].accepted < kUnreachableCost ? 1 : 0;
        }
        field.acceptedCount_ += accepted;
    }
}

// Moves the values of wall nodes to the centres of their cells, where queries expect them.
void EikonalSolver::Impl::setCentreValues(const UnitCost& cost, Cell low, Cell high, CostField& field) const {
    const Grid& grid = cost.grid;
    const auto edge = static_cast<float>(grid.cell);
    // Nodes ascend by cell: those of other rows are skipped.
    auto node = std::lower_bound(cost.nodes.begin(), cost.nodes.end(), low.y * grid.width,
                                 [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    for (; node != cost.nodes.end() && node->cell < (high.y + 1) * grid.width; ++node) {
        const Cell c = grid.at(node->cell);
        const Cell in{c.x - low.x, c.y - low.y};
        if (in.x < 0 || in.y < 0 || in.x >= field.width_ || in.y >= field.height_) continue;
        field.values_[static_cast<std::size_t>(in.y) * field.width_ + in.x] = front.centreValue(*node) * edge;
    }
}

}  // namespace muster
