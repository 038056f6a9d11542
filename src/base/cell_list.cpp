#include "base/cell_list.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// More cells than this are not worth clearing.
constexpr double kCellsPerPoint = 6.0;
constexpr double kCellsMore = 64.0;

Box boundsOf(std::span<const Vec2> points) {
    Box box{points[0], points[0]};
    for (const Vec2 p : points) {
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    return box;
}

}  // namespace

void CellList::sort(std::span<const Vec2> points, double least) {
    grid_ = {};
    if (points.empty()) return;
    const Box box = boundsOf(points).grown(0.5 * least);
    const double most = kCellsPerPoint * static_cast<double>(points.size()) + kCellsMore;
    double edge = std::max(least, std::sqrt(box.width() * box.height() / most));
    while ((box.width() / edge + 1.0) * (box.height() / edge + 1.0) > most) edge *= 1.25;
    grid_ = Grid::covering(box, edge);
    start_.reserve(static_cast<std::size_t>(most) + 1);  // Whatever cells are chosen: no growth later.
    start_.assign(static_cast<std::size_t>(grid_.count()) + 1, 0);
    cellOf_.resize(points.size());
    item_.resize(points.size());
    const Grid grid = grid_;  // A copy cannot change with what is written: it stays in registers.
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::int32_t cell = grid.index(grid.nearestCell(points[k]));
        cellOf_[k] = cell;
        ++start_[cell];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : start_) s = sum += s;
    // Filled from the back, so that points of one cell stay in ascending order.
    sorted_.resize(points.size());
    for (std::size_t k = points.size(); k-- > 0;) {
        const auto at = static_cast<std::size_t>(--start_[cellOf_[k]]);
        item_[at] = static_cast<std::int32_t>(k);
        sorted_[at] = points[k];
    }
}

}  // namespace muster
