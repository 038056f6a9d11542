// Thin walls between the four cells round a point.
#include <algorithm>

#include "engine/fields/eikonal/cost_field.h"

namespace muster {
namespace {

// Bits of cuts_: a wall towards the next column, towards the next row.
constexpr std::uint8_t kCutEast = 1, kCutNorth = 2;
// The pairs of neighbours among the corners of a square.
constexpr int kSquareEdges[4][2] = {{0, 1}, {2, 3}, {0, 2}, {1, 3}};

}  // namespace

// Notes the walls that part two neighbouring cells which are both reached.
void CostField::findCuts(const UnitCost& cost) {
    cuts_.clear();
    cutNodes_.clear();
    const auto note = [&](std::int32_t at, std::uint8_t bit) {
        if (cuts_.empty()) cuts_.assign(values_.size(), 0);
        cuts_[at] |= bit;
    };
    const auto reached = [&](std::int32_t at) { return values_[at] < kUnreachableCost; };
    for (std::int32_t y = 0; y < height_; ++y)
        for (std::int32_t x = 0; x < width_; ++x) {
            const std::int32_t at = y * width_ + x;
            if (!reached(at)) continue;
            const std::int32_t cell = grid_.index({low_.x + x, low_.y + y});
            const CellCost& own = cost.cells[cell];
            if (x + 1 < width_ && reached(at + 1) && !(own.east < kUnreachableCost) &&
                !(cost.cells[cell + 1].west < kUnreachableCost))
                note(at, kCutEast);
            if (y + 1 < height_ && reached(at + width_) && !(own.north < kUnreachableCost) &&
                !(cost.cells[cell + grid_.width].south < kUnreachableCost))
                note(at, kCutNorth);
        }
    if (cuts_.empty()) return;
    for (const WallNode& node : cost.nodes)
        if (node.x != 0.0f || node.y != 0.0f) cutNodes_.push_back({node.cell, node.x, node.y});
}

// The point where a body stands in a cell [m].
Vec2 CostField::nodeOf(Cell c) const {
    const std::int32_t cell = grid_.index(c);
    const auto node = std::lower_bound(cutNodes_.begin(), cutNodes_.end(), cell,
                                       [](const CutNode& n, std::int32_t index) { return n.cell < index; });
    const Vec2 centre = grid_.centre(c);
    if (node == cutNodes_.end() || node->cell != cell) return centre;
    return centre + Vec2{node->x, node->y} * grid_.cell;
}

// The corners of the square of centres above and right of `low` that lie on the same side of all walls as
// `p`, a bit for each. Bodies keep far enough from walls that the nearest cell is on their side.
unsigned CostField::sameSide(Cell low, Vec2 p) const {
    if (cuts_.empty()) return kAllCorners;
    bool cut[4] = {};
    for (int e = 0; e < 4; ++e) {
        const int k = kSquareEdges[e][0];
        const std::int32_t at = indexOf({low.x + (k & 1), low.y + (k >> 1)});
        cut[e] = at >= 0 && (cuts_[at] & (e < 2 ? kCutEast : kCutNorth)) != 0;
    }
    if (!cut[0] && !cut[1] && !cut[2] && !cut[3]) return kAllCorners;
    bool reached[4];
    int home = -1;
    double nearest = 0.0;
    for (int k = 0; k < 4; ++k) {
        const Cell c{low.x + (k & 1), low.y + (k >> 1)};
        reached[k] = value(c) < kUnreachableCost;
        if (!reached[k]) continue;
        const double away = lengthSquared(nodeOf(c) - p);
        if (home >= 0 && !(away < nearest)) continue;
        home = k;
        nearest = away;
    }
    unsigned side = 1u << home;
    for (int round = 0; round < 3; ++round)
        for (int e = 0; e < 4; ++e) {
            const int a = kSquareEdges[e][0], b = kSquareEdges[e][1];
            if (cut[e] || !reached[a] || !reached[b]) continue;
            if (((side >> a | side >> b) & 1u) != 0) side |= 1u << a | 1u << b;
        }
    return side;
}

}  // namespace muster
