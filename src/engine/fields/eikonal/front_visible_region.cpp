// The region visible from the source, filled from cell to cell without the queue.
#include <algorithm>
#include <cmath>

#include "engine/fields/eikonal/front.h"

namespace muster {

bool Front::fillVisible(Cell home, std::int32_t source, float limit) {
    const FrontCell start = at(home);
    if (!lineOfSight_.uniform(start.cell, sources_[source].unit)) return false;
    visibleLow_ = home;
    visibleHigh_ = home;
    visibleLimit_ = limit;
    float x = 0.0f;
    float y = 0.0f;
    position(start, x, y);
    nodes_[start.node].source = source;
    nodes_[start.node].tentative = nodes_[start.node].accepted = sources_[source].costAt(x, y);
    for (const std::int32_t side : {1, -1}) {
        fillAxis(home, side, 0, source);
        fillAxis(home, 0, side, source);
    }
    for (const std::int32_t right : {1, -1}) {
        for (const std::int32_t up : {1, -1}) fillQuadrant(home, right, up, source);
    }
    noteWritten(visibleLow_, visibleHigh_);
    noteReached(node(visibleLow_.x, visibleLow_.y));
    noteReached(node(visibleHigh_.x, visibleHigh_.y));
    queueBorder(source);
    return true;
}

// Fills the source's own row or column outwards. A cell is certain to be visible where both cells between
// which its line of sight leaves it are open.
void Front::fillAxis(Cell home, std::int32_t right, std::int32_t up, std::int32_t source) {
    const float unit = sources_[source].unit;
    const std::int32_t across = right != 0 ? grid_.width : 1;
    for (Cell c{home.x + right, home.y + up}; grid_.contains(c); c = {c.x + right, c.y + up}) {
        const FrontCell cell = at(c);
        const FrontCell before = at({c.x - right, c.y - up});
        if (nodes_[before.node].source != source) return;
        const bool atEdge = right != 0 ? c.y == 0 || c.y == grid_.height - 1
                                       : c.x == 0 || c.x == grid_.width - 1;
        const bool certain = !atEdge && lineOfSight_.open(before.cell - across, unit) &&
                             lineOfSight_.open(before.cell + across, unit);
        if (!fillCell(cell, certain, source)) return;
        visibleLow_ = {std::min(visibleLow_.x, c.x), std::min(visibleLow_.y, c.y)};
        visibleHigh_ = {std::max(visibleHigh_.x, c.x), std::max(visibleHigh_.y, c.y)};
    }
}

// Fills one quadrant of the cells beyond the axes, row by row.
void Front::fillQuadrant(Cell home, std::int32_t right, std::int32_t up, std::int32_t source) {
    const std::int32_t width = right > 0 ? grid_.width - 1 - home.x : home.x;
    const std::int32_t height = up > 0 ? grid_.height - 1 - home.y : home.y;
    // Last visible column of the row before; at first no row limits the next one.
    std::int32_t visible = width;
    for (std::int32_t j = 1; j <= height; ++j) {
        const std::int32_t row = home.y + up * j;
        const std::int32_t last = fillRow({home.x, row}, {right, up}, {width, visible}, source);
        if (last < 0 && visible < 0) return;
        visible = last;
        visibleLow_ = {std::min(visibleLow_.x, home.x + right * std::max(0, last)),
                       std::min(visibleLow_.y, row)};
        visibleHigh_ = {std::max(visibleHigh_.x, home.x + right * std::max(0, last)),
                        std::max(visibleHigh_.y, row)};
    }
}

// Fills one row of a quadrant from the axis on. A cell is visible where both cells between which its line of
// sight leaves it are; where one of them is, the line is traced. Returns the last visible column, counted
// from the axis; -1 for none.
std::int32_t Front::fillRow(Cell axis, Cell side, RowSpan span, std::int32_t source) {
    const PseudoSource origin = sources_[source];
    const std::int32_t right = side.x;
    const std::ptrdiff_t back = -side.y * stride_;
    const float dy = std::fabs(static_cast<float>(axis.y) - origin.y);
    FrontCell cell = at(axis);
    FrontNode* to = &nodes_[cell.node];
    // Whether the cell before in this row is visible, and the one between that and the source's row.
    bool before = to->source == source;
    bool oblique = to[back].source == source;
    std::int32_t last = before ? 0 : -1;
    for (std::int32_t i = 1; i <= span.width; ++i) {
        cell = {cell.cell + right, cell.node + right};
        to += right;
        const float dx = std::fabs(static_cast<float>(axis.x + right * i) - origin.x);
        const bool across = to[back].source == source;
        const bool straight = dx >= dy ? before : across;
        if (straight && oblique && lineOfSight_.wall(cell.cell) == 0 &&
            lineOfSight_.open(cell.cell, origin.unit)) {
            // Nearly all cells come here. The value is that of costAt() at the centre.
            const float value = origin.cost + origin.unit * std::sqrt(dx * dx + dy * dy);
            before = !(value > visibleLimit_);
            if (before) *to = {value, value, source, to->occluded};
        } else if (straight || oblique) {
            before = fillCell(cell, straight && oblique, source);
        } else if (i > span.visible) {
            break;
        } else {
            before = false;
        }
        if (before) last = i;
        oblique = across;
    }
    return last;
}

// Sets the value of a cell where it lies on the source's ground and is visible. `certain` where its own wall
// alone can occlude the source. Returns whether the cell is visible.
bool Front::fillCell(FrontCell cell, bool certain, std::int32_t source) {
    const PseudoSource& origin = sources_[source];
    const bool open = lineOfSight_.open(cell.cell, origin.unit);
    if (!open && lineOfSight_.narrow(cell.cell)) return false;
    if (!open && !lineOfSight_.uniform(cell.cell, origin.unit)) return false;
    float x = 0.0f;
    float y = 0.0f;
    position(cell, x, y);
    const float value = origin.costAt(x, y);
    if (value > visibleLimit_) return false;
    const float elevation = open ? 1.0f : lineOfSight_.elevation(cell.cell, x, y, origin);
    if (elevation < kOccludedElevation) return false;
    const bool visible = certain && elevation >= kVisibleElevation;
    if (!visible && traceAndNote(cell, x, y, source) != Visibility::Clear) return false;
    FrontNode& at = nodes_[cell.node];
    at = {value, value, source, at.occluded};
    return true;
}

// Queues the visible cells from which the march goes on: cells with a neighbour that is not visible, and
// cells at walls, where shortest paths may bend.
void Front::queueBorder(std::int32_t source) {
    for (std::int32_t y = visibleLow_.y; y <= visibleHigh_.y; ++y) {
        FrontCell cell = at({visibleLow_.x, y});
        FrontNode* here = &nodes_[cell.node];
        const FrontNode* const end = here + (visibleHigh_.x - visibleLow_.x + 1);
        for (; here != end; ++here, ++cell.cell, ++cell.node) {
            if (here->source != source) continue;
            const bool inner = here[-1].source == source && here[1].source == source &&
                               here[-stride_].source == source && here[stride_].source == source;
            if (inner && lineOfSight_.wall(cell.cell) == 0) continue;
            here->accepted = kUnreachableCost;
            queue_.push(queue_.number(here->tentative), cell);
        }
    }
}

}  // namespace muster
