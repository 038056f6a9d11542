// What the source sees, filled in without a queue.
#include <algorithm>
#include <cmath>

#include "fields/front.h"

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
        const bool rim = right != 0 ? c.y == 0 || c.y == grid_.height - 1 : c.x == 0 || c.x == grid_.width - 1;
        floodCell(cell, !rim && sight_.open(before.cell - across, unit) && sight_.open(before.cell + across, unit), root);
        if (nodes_[cell.node].root != root) return;
        floodLow_ = {std::min(floodLow_.x, c.x), std::min(floodLow_.y, c.y)};
        floodHigh_ = {std::max(floodHigh_.x, c.x), std::max(floodHigh_.y, c.y)};
    }
}

// The cells beyond the axes on two sides, row by row: seen for certain where both cells are between which the way
// leaves towards the root; looked at where one is.
void Front::floodQuadrant(Cell home, std::int32_t right, std::int32_t up, std::int32_t root) {
    const Root& source = roots_[root];
    const std::int32_t width = right > 0 ? grid_.width - 1 - home.x : home.x;
    const std::int32_t height = up > 0 ? grid_.height - 1 - home.y : home.y;
    const std::int32_t rowStep = up * stride_;
    // Beyond the last column that the row before reached by one there is nothing to see, but by the axis.
    std::int32_t reached = width;
    for (std::int32_t j = 1; j <= height; ++j) {
        const std::int32_t row = home.y + up * j;
        const float dy = std::fabs(static_cast<float>(row) - source.y);
        std::int32_t last = nodes_[node(home.x, row)].root == root ? 0 : -1;
        for (std::int32_t i = 1; i <= width; ++i) {
            const std::int32_t column = home.x + right * i;
            const std::int32_t to = node(column, row);
            const float dx = std::fabs(static_cast<float>(column) - source.x);
            const bool straight = nodes_[to - (dx >= dy ? right : rowStep)].root == root;
            const bool oblique = nodes_[to - right - rowStep].root == root;
            if (straight || oblique) {
                floodCell({row * grid_.width + column, to}, straight && oblique, root);
                if (nodes_[to].root == root) last = i;
            } else if (i > reached) {
                break;
            }
        }
        if (last < 0 && reached < 0) return;
        reached = last;
        floodLow_ = {std::min(floodLow_.x, home.x + right * std::max(0, last)), std::min(floodLow_.y, row)};
        floodHigh_ = {std::max(floodHigh_.x, home.x + right * std::max(0, last)), std::max(floodHigh_.y, row)};
    }
}

// Gives a cell its straight-line value where it is of the root's ground and sees it; `certain` where it does unless a
// wall of its own stands between.
inline void Front::floodCell(FrontCell cell, bool certain, std::int32_t root) {
    const Root& source = roots_[root];
    const bool open = sight_.open(cell.cell, source.unit);
    if (!open && !sight_.plain(cell.cell, source.unit)) return;
    float x = 0.0f;
    float y = 0.0f;
    place(cell, x, y);
    const float value = source.costAt(x, y);
    if (value > floodLimit_) return;
    const float rise = open ? 1.0f : sight_.rise(cell.cell, x, y, source);
    if (rise < kHidden || (!(certain && rise >= kRisen) && look(cell, x, y, root) != Ray::Clear)) return;
    nodes_[cell.node].root = root;
    nodes_[cell.node].tentative = value;
    nodes_[cell.node].accepted = value;
}

// The march goes on from the flooded cells that have others beside them, or may be bent at.
void Front::queueRim(std::int32_t root) {
    for (std::int32_t y = floodLow_.y; y <= floodHigh_.y; ++y) {
        for (std::int32_t x = floodLow_.x; x <= floodHigh_.x; ++x) {
            const FrontCell cell = at({x, y});
            if (nodes_[cell.node].root != root) continue;
            const bool inner = nodes_[cell.node - 1].root == root && nodes_[cell.node + 1].root == root &&
                               nodes_[cell.node - stride_].root == root && nodes_[cell.node + stride_].root == root;
            if (inner && sight_.wall(cell.cell) == 0) continue;
            nodes_[cell.node].accepted = kInfiniteCost;
            queue_.push(queue_.number(nodes_[cell.node].tentative), cell);
        }
    }
}

}  // namespace muster
