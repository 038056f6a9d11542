#include "eikonal/eikonal_solver.h"

#include <algorithm>
#include <cmath>

#include "base/bilinear.h"
#include "eikonal/front.h"
#include "eikonal/start_disc.h"
#include "muster/assert.h"

namespace muster {

struct EikonalSolver::Impl {
    EikonalDef def;
    Front front;
    StartDisc disc;
    std::vector<FrontCell> watched;  // Cells around the targets that can be reached.

    void watch(const UnitCost& cost, std::span<const Vec2> targets);
    void march(double cell, bool bounded);
    double reach(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets) const;
    Cell readRows(const Grid& grid, Cell& high) const;
};

namespace {

bool reachable(const UnitCost& cost, std::int32_t index) {
    return !cost.wall(index);
}

}  // namespace

void EikonalSolver::Impl::watch(const UnitCost& cost, std::span<const Vec2> targets) {
    watched.clear();
    for (const Vec2 target : targets) {
        if (!isFinite(target)) continue;
        const BilinearStencil stencil = bilinearStencil(cost.grid, target);
        for (const std::int32_t index : stencil.cell) {
            if (reachable(cost, index)) watched.push_back(front.at(cost.grid.at(index)));
        }
    }
}

// Marches until all watched cells are final and the front is def.margin beyond them, or nothing is left.
void EikonalSolver::Impl::march(double cell, bool bounded) {
    std::size_t reached = 0;
    float stop = kInfiniteCost;
    while (front.level() <= stop && front.step()) {
        if (!bounded || stop < kInfiniteCost) continue;
        while (reached < watched.size() && front.value(watched[reached].node) < kInfiniteCost) ++reached;
        if (reached < watched.size()) continue;
        // Straight ways may have run ahead of the front.
        stop = front.level();
        for (const FrontCell at : watched) stop = std::max(stop, front.value(at.node));
        stop += static_cast<float>(def.margin / cell);
    }
}

// How far from the source the targets lie, with the margin [m].
double EikonalSolver::Impl::reach(const UnitCost& cost, Vec2 source, std::span<const Vec2> targets) const {
    if (targets.empty()) return kInfiniteCost;
    double farthest = 0.0;
    for (const Vec2 target : targets) {
        if (isFinite(target)) farthest = std::max(farthest, distance(cost.grid.box().clamp(target), source));
    }
    return farthest + 2.0 * cost.grid.cell + def.margin / cost.lowest;
}

// The smallest window that holds all reached cells; high lies below low where there are none.
Cell EikonalSolver::Impl::readRows(const Grid& grid, Cell& high) const {
    Cell low{grid.width, grid.height};
    high = {-1, -1};
    for (std::int32_t y = front.firstRow(); y <= front.lastRow(); ++y) {
        const FrontNode* row = front.row(y);
        std::int32_t left = 0;
        while (left < low.x && !(row[left].accepted < kInfiniteCost)) ++left;
        std::int32_t right = grid.width - 1;
        while (right > high.x && !(row[right].accepted < kInfiniteCost)) --right;
        const bool inside = left < low.x || right > high.x;
        low.x = std::min(low.x, left);
        high.x = std::max(high.x, right);
        bool any = inside;
        for (std::int32_t x = low.x; !any && x <= high.x; ++x) any = row[x].accepted < kInfiniteCost;
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
    MUSTER_ASSERT(cost.cells.size() == static_cast<std::size_t>(cost.grid.count()));
    Impl& work = *impl_;
    const Grid& grid = cost.grid;
    field.grid_ = grid;
    field.source_ = grid.box().clamp(isFinite(source) ? source : grid.origin);
    work.front.fit(grid);
    work.front.begin(cost, work.def.secondOrder);
    work.watch(cost, targets);
    work.disc.start(cost, field.source_, work.def.startRadius, work.reach(cost, field.source_, targets),
                    work.front);
    field.nearRadius_ = work.disc.radius();
    field.nearCost_ = cost.cells[grid.index(grid.nearestCell(field.source_))];
    work.march(grid.cell, !targets.empty());

    Cell high;
    const Cell low = work.readRows(grid, high);
    field.low_ = low;
    field.width_ = std::max(0, high.x - low.x + 1);
    field.height_ = std::max(0, high.y - low.y + 1);
    field.values_.resize(static_cast<std::size_t>(field.width_) * field.height_);
    field.root_.resize(field.values_.size());
    field.roots_ = work.front.roots();
    field.acceptedCount_ = 0;
    const auto edge = static_cast<float>(grid.cell);
    for (std::int32_t y = 0; y < field.height_; ++y) {
        const FrontNode* row = work.front.row(low.y + y) + low.x;
        float* out = field.values_.data() + static_cast<std::size_t>(y) * field.width_;
        std::uint16_t* rootOut = field.root_.data() + static_cast<std::size_t>(y) * field.width_;
        std::int32_t reached = 0;
        for (std::int32_t x = 0; x < field.width_; ++x) {
            const std::int32_t root = row[x].root;
            out[x] = row[x].accepted * edge;
            rootOut[x] = static_cast<std::uint16_t>(root > 0 && root <= 0xffff ? root : 0);
            reached += row[x].accepted < kInfiniteCost ? 1 : 0;
        }
        field.acceptedCount_ += reached;
    }
    // Nodes ascend by cell: those of other rows need no look.
    auto node = std::lower_bound(cost.nodes.begin(), cost.nodes.end(), low.y * grid.width,
                                 [](const WallNode& n, std::int32_t cell) { return n.cell < cell; });
    for (; node != cost.nodes.end() && node->cell < (high.y + 1) * grid.width; ++node) {
        const WallNode& beside = *node;
        const Cell c = grid.at(beside.cell);
        const Cell in{c.x - low.x, c.y - low.y};
        if (in.x < 0 || in.y < 0 || in.x >= field.width_ || in.y >= field.height_) continue;
        field.values_[static_cast<std::size_t>(in.y) * field.width_ + in.x] = work.front.centreValue(beside) *
                                                                              edge;
    }
    work.front.end(low, high);
}

}  // namespace muster
