// Exact costs from pseudo-sources.
#include <utility>

#include "base/bilinear.h"
#include "engine/fields/eikonal/cost_field.h"

namespace muster {
namespace {

// Squared distance to a pseudo-source below which its parent is visible too [cells^2].
constexpr double kAtSourceSquared = 1.0;

// True where the path from the pseudo-source `parent` to a point bends at `corner`: the point lies beyond the
// corner on the side of its wall.
bool bendsAt(const PseudoSource& parent, const PseudoSource& corner, Vec2 at) {
    const Vec2 line{corner.x - parent.x, corner.y - parent.y};
    const Vec2 beyond{at.x - corner.x, at.y - corner.y};
    const double side = cross(line, Vec2{corner.normalX, corner.normalY});
    return dot(line, beyond) > 0.0 && side * cross(line, beyond) < 0.0;
}

}  // namespace

std::int32_t CostField::pseudoSourceOf(Cell cell) const {
    const std::int32_t at = indexOf(cell);
    return at >= 0 ? sourceOf_[at] : 0;
}

// The pseudo-sources of the reached cells among the four around a point; empty where one of them has none.
CostField::SourceSet CostField::pseudoSourcesAround(Vec2 p) const {
    const BilinearPoint at = bilinearPoint(grid_, p);
    const unsigned side = sameSide(at.low, p);
    SourceSet sources;
    for (int k = 0; k < 4; ++k) {
        const Cell c{at.low.x + (k & 1), at.low.y + (k >> 1)};
        if (!(valueOf(at.low, k, side) < kUnreachableCost)) continue;
        const std::int32_t index = pseudoSourceOf(c);
        if (index == 0) return {};
        if (sources.find(index) < 0) sources.index[sources.count++] = index;
    }
    return sources;
}

// The first pseudo-source on the path from `first` to `last` from which the path to a point does not bend at
// the next one.
std::int32_t CostField::visibleSource(std::int32_t first, std::int32_t last, Vec2 at) const {
    std::int32_t visible = last;
    for (std::int32_t corner = last; corner != first; corner = sources_[corner].parent) {
        const std::int32_t parent = sources_[corner].parent;
        if (!bendsAt(sources_[parent], sources_[corner], at)) visible = parent;
    }
    return visible;
}

// Cost of the cheapest path over the pseudo-sources around a point, exact also where two such paths meet, and
// the vector to the pseudo-source that it runs over, and the index of that [cells]. Infinite where a reached
// cell around the point has no pseudo-source.
double CostField::exactCost(Vec2 p, Vec2& towards, std::int32_t& over) const {
    const SourceSet around = pseudoSourcesAround(p);
    const Vec2 at{(p.x - grid_.origin.x) / grid_.cell - 0.5, (p.y - grid_.origin.y) / grid_.cell - 0.5};
    // For each pseudo-source of the set the last ancestor that is in the set too. Ancestors are considered
    // with their descendants.
    std::int32_t first[4];
    bool isAncestor[4] = {};
    for (int k = 0; k < around.count; ++k) {
        first[k] = around.index[k];
        for (std::int32_t s = sources_[around.index[k]].parent; s > 0; s = sources_[s].parent) {
            const int same = around.find(s);
            if (same < 0) continue;
            first[k] = s;
            isAncestor[same] = true;
        }
    }
    double best = kUnreachableCost;
    for (int k = 0; k < around.count; ++k) {
        if (isAncestor[k]) continue;
        const std::int32_t last = around.index[k];
        const PseudoSource& own = sources_[last];
        const bool atSource = lengthSquared(at - Vec2{own.x, own.y}) < kAtSourceSquared;
        if (first[k] == last && own.parent > 0 && atSource) first[k] = own.parent;
        const std::int32_t visible = visibleSource(first[k], last, at);
        const PseudoSource& source = sources_[visible];
        const Vec2 off{source.x - at.x, source.y - at.y};
        const double cost = (source.cost + source.unit * length(off)) * grid_.cell;
        if (!(cost < best)) continue;
        best = cost;
        towards = off;
        over = visible;
    }
    return best;
}

std::int32_t CostField::pathCorners(Vec2 p, std::span<Vec2> corners) const {
    std::int32_t index = pseudoSourceOf(grid_.nearestCell(p));
    if (index <= 0) return -1;
    std::int32_t count = 0;
    while (index > 0 && sources_[index].parent > 0 && std::cmp_less(count, corners.size())) {
        const PseudoSource& source = sources_[index];
        corners[count++] = grid_.origin + Vec2{source.x + 0.5, source.y + 0.5} * grid_.cell;
        index = source.parent;
    }
    return count;
}

}  // namespace muster
