// Reading a field where all that is known around a point comes straight from roots.
#include "base/bilinear.h"
#include "eikonal/cost_field.h"
#include "eikonal/front.h"

namespace muster {
namespace {

// Right beside a root the one before it is seen as well [cells, squared].
constexpr double kBeside = 1.0;

// True where the way from root `far` to a point is bent at `near`, a root reached from it: beyond, on the
// wall's side.
bool inShadow(const PseudoSource& far, const PseudoSource& near, Vec2 at) {
    const Vec2 way{near.x - far.x, near.y - far.y};
    const Vec2 on{at.x - near.x, at.y - near.y};
    const double side = cross(way, Vec2{near.normalX, near.normalY});
    return dot(way, on) > 0.0 && side * cross(way, on) < 0.0;
}

}  // namespace

std::int32_t CostField::rootOf(Cell cell) const {
    const std::int32_t at = indexOf(cell);
    return at >= 0 ? root_[at] : 0;
}

// The roots that the reached ones among the four cells around a point come from; empty where one comes from
// none.
CostField::Roots CostField::rootsAround(Vec2 p) const {
    const BilinearPoint at = bilinearPoint(grid_, p);
    Roots roots;
    for (int k = 0; k < 4; ++k) {
        const Cell c{at.low.x + (k & 1), at.low.y + (k >> 1)};
        if (!(value(c) < kInfiniteCost)) continue;
        const std::int32_t number = rootOf(c);
        if (number == 0) return {};
        if (roots.find(number) < 0) roots.number[roots.count++] = number;
    }
    return roots;
}

// Of the roots from `first` on the way to root `last`, the first whose way to a point is not bent at the
// next.
std::int32_t CostField::seenRoot(std::int32_t first, std::int32_t last, Vec2 at) const {
    std::int32_t seen = last;
    for (std::int32_t near = last; near != first; near = roots_[near].parent) {
        const std::int32_t far = roots_[near].parent;
        if (!inShadow(roots_[far], roots_[near], at)) seen = far;
    }
    return seen;
}

double CostField::straightCostAt(Vec2 p, Vec2& towards) const {
    const Roots around = rootsAround(p);
    const Vec2 at{(p.x - grid_.origin.x) / grid_.cell - 0.5, (p.y - grid_.origin.y) / grid_.cell - 0.5};
    // For each the first root on its way that is another one of them; those count with it.
    std::int32_t first[4];
    bool before[4] = {};
    for (int k = 0; k < around.count; ++k) {
        first[k] = around.number[k];
        for (std::int32_t on = roots_[around.number[k]].parent; on > 0; on = roots_[on].parent) {
            const int same = around.find(on);
            if (same < 0) continue;
            first[k] = on;
            before[same] = true;
        }
    }
    double best = kInfiniteCost;
    for (int k = 0; k < around.count; ++k) {
        if (before[k]) continue;
        const std::int32_t last = around.number[k];
        const PseudoSource& own = roots_[last];
        const bool beside = lengthSquared(at - Vec2{own.x, own.y}) < kBeside;
        if (first[k] == last && own.parent > 0 && beside) first[k] = own.parent;
        const PseudoSource& root = roots_[seenRoot(first[k], last, at)];
        const Vec2 off{root.x - at.x, root.y - at.y};
        const double cost = (root.cost + root.unit * length(off)) * grid_.cell;
        if (!(cost < best)) continue;
        best = cost;
        towards = off;
    }
    return best;
}

}  // namespace muster
