// What the source sees, filled in without a queue.
#include <algorithm>
#include <cmath>

#include "eikonal/front.h"

namespace muster {

bool Front::flood(Cell home, std::int32_t root, float limit) {
    const FrontCell start = at(home);
    if (!sight_.plain(start.cell, roots_[root].unit)) return false;
    floodLow_ = home;
    floodHigh_ = home;
    floodLimit_ = limit;
    float x = 0.0f;
    float y = 0.0f;
    place(start, x, y);
    nodes_[start.node].root = root;
    nodes_[start.node].tentative = nodes_[start.node].accepted = roots_[root].costAt(x, y);
    for (const std::int32_t side : {1, -1}) {
        floodAxis(home, side, 0, root);
        floodAxis(home, 0, side, root);
    }
    for (const std::int32_t right : {1, -1}) {
        for (const std::int32_t up : {1, -1}) floodQuadrant(home, right, up, root);
    }
    noteWritten(floodLow_, floodHigh_);
    noteReached(node(floodLow_.x, floodLow_.y));
    noteReached(node(floodHigh_.x, floodHigh_.y));
    queueRim(root);
    return true;
}

// The root's own row and column, outwards: ways along it stay between the rows (columns) beside it.
void Front::floodAxis(Cell home, std::int32_t right, std::int32_t up, std::int32_t root) {
    const float unit = roots_[root].unit;
    const std::int32_t across = right != 0 ? grid_.width : 1;
    for (Cell c{home.x + right, home.y + up}; grid_.contains(c); c = {c.x + right, c.y + up}) {
        const FrontCell cell = at(c);
        const FrontCell before = at({c.x - right, c.y - up});
        if (nodes_[before.node].root != root) return;
        const bool rim = right != 0 ? c.y == 0 || c.y == grid_.height - 1
                                    : c.x == 0 || c.x == grid_.width - 1;
        const bool certain = !rim && sight_.open(before.cell - across, unit) &&
                             sight_.open(before.cell + across, unit);
        if (!floodCell(cell, certain, root)) return;
        floodLow_ = {std::min(floodLow_.x, c.x), std::min(floodLow_.y, c.y)};
        floodHigh_ = {std::max(floodHigh_.x, c.x), std::max(floodHigh_.y, c.y)};
    }
}

// The cells beyond the axes on two sides, row by row.
void Front::floodQuadrant(Cell home, std::int32_t right, std::int32_t up, std::int32_t root) {
    const std::int32_t width = right > 0 ? grid_.width - 1 - home.x : home.x;
    const std::int32_t height = up > 0 ? grid_.height - 1 - home.y : home.y;
    // Beyond the last column that the row before reached by one there is nothing to see, but by the axis.
    std::int32_t reached = width;
    for (std::int32_t j = 1; j <= height; ++j) {
        const std::int32_t row = home.y + up * j;
        const std::int32_t last = floodRow({home.x, row}, {right, up}, {width, reached}, root);
        if (last < 0 && reached < 0) return;
        reached = last;
        floodLow_ = {std::min(floodLow_.x, home.x + right * std::max(0, last)), std::min(floodLow_.y, row)};
        floodHigh_ = {std::max(floodHigh_.x, home.x + right * std::max(0, last)),
                      std::max(floodHigh_.y, row)};
    }
}

// A row of a quadrant from the axis on: cells are seen for certain where both cells are between which the way
// leaves towards the root; looked at where one is. Returns the last column seen, counted from the axis; -1
// for none.
std::int32_t Front::floodRow(Cell axis, Cell side, FloodSpan span, std::int32_t root) {
    const PseudoSource source = roots_[root];
    const std::int32_t right = side.x;
    const std::ptrdiff_t back = -side.y * stride_;
    const float dy = std::fabs(static_cast<float>(axis.y) - source.y);
    FrontCell cell = at(axis);
    FrontNode* to = &nodes_[cell.node];
    // Of the cell before in this row, and of the one between that and the root's row.
    bool beside = to->root == root;
    bool oblique = to[back].root == root;
    std::int32_t last = beside ? 0 : -1;
    for (std::int32_t i = 1; i <= span.width; ++i) {
        cell = {cell.cell + right, cell.node + right};
        to += right;
        const float dx = std::fabs(static_cast<float>(axis.x + right * i) - source.x);
        const bool across = to[back].root == root;
        const bool straight = dx >= dy ? beside : across;
        if (straight && oblique && sight_.wall(cell.cell) == 0 && sight_.open(cell.cell, source.unit)) {
            // Nearly all cells: the value is that of costAt() at the centre.
            const float value = source.cost + source.unit * std::sqrt(dx * dx + dy * dy);
            beside = !(value > floodLimit_);
            if (beside) *to = {value, value, root, to->hidden};
        } else if (straight || oblique) {
            beside = floodCell(cell, straight && oblique, root);
        } else if (i > span.reached) {
            break;
        } else {
            beside = false;
        }
        if (beside) last = i;
        oblique = across;
    }
    return last;
}

// Gives a cell its straight-line value where it is of the root's ground and sees it; `certain` where it does
// unless a wall of its own stands between. Returns whether it does.
bool Front::floodCell(FrontCell cell, bool certain, std::int32_t root) {
    const PseudoSource& source = roots_[root];
    const bool open = sight_.open(cell.cell, source.unit);
    if (!open && !sight_.plain(cell.cell, source.unit)) return false;
    float x = 0.0f;
    float y = 0.0f;
    place(cell, x, y);
    const float value = source.costAt(x, y);
    if (value > floodLimit_) return false;
    const float rise = open ? 1.0f : sight_.rise(cell.cell, x, y, source);
    if (rise < kHidden || (!(certain && rise >= kRisen) && look(cell, x, y, root) != Ray::Clear))
        return false;
    FrontNode& at = nodes_[cell.node];
    at = {value, value, root, at.hidden};
    return true;
}

// The march goes on from the flooded cells that have others beside them, or may be bent at.
void Front::queueRim(std::int32_t root) {
    for (std::int32_t y = floodLow_.y; y <= floodHigh_.y; ++y) {
        FrontCell cell = at({floodLow_.x, y});
        FrontNode* here = &nodes_[cell.node];
        const FrontNode* const end = here + (floodHigh_.x - floodLow_.x + 1);
        for (; here != end; ++here, ++cell.cell, ++cell.node) {
            if (here->root != root) continue;
            const bool inner = here[-1].root == root && here[1].root == root && here[-stride_].root == root &&
                               here[stride_].root == root;
            if (inner && sight_.wall(cell.cell) == 0) continue;
            here->accepted = kInfiniteCost;
            queue_.push(queue_.number(here->tentative), cell);
        }
    }
}

}  // namespace muster
