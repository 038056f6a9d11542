#include "base/cell_list.h"

#include <algorithm>
#include <cmath>

#include "base/bounds.h"

namespace muster {
namespace {

// Upper bound of the number of cells; clearing more takes longer than the search saves.
constexpr double kCellsPerPoint = 6.0;
constexpr double kCellsMore = 64.0;

}  // namespace

void CellList::sort(std::span<const Vec2> points, double minEdge) {
    grid_ = {};
    if (points.empty()) return;
    const Box box = boundsOf(points).grown(0.5 * minEdge);
    const double most = kCellsPerPoint * static_cast<double>(points.size()) + kCellsMore;
    double edge = std::max(minEdge, std::sqrt(box.width() * box.height() / most));
    while ((box.width() / edge + 1.0) * (box.height() / edge + 1.0) > most) edge *= 1.25;
    grid_ = Grid::covering(box, edge);
    start_.reserve(static_cast<std::size_t>(most) + 1);  // Enough for any number of cells.
    start_.assign(grid_.count() + 1, 0);
    cellOf_.resize(points.size());
    item_.resize(points.size());
    const Grid grid = grid_;  // No write can alias a local copy, which stays in registers.
    for (std::size_t k = 0; k < points.size(); ++k) {
        const std::int32_t cell = grid.index(grid.nearestCell(points[k]));
        cellOf_[k] = cell;
        ++start_[cell];
    }
    std::int32_t sum = 0;
    for (std::int32_t& s : start_) s = sum += s;
    // Points are placed from the last one on, so that the points of one cell end in ascending order.
    sorted_.resize(points.size());
    for (std::size_t k = points.size(); k-- > 0;) {
        const std::int32_t at = --start_[cellOf_[k]];
        item_[at] = static_cast<std::int32_t>(k);
        sorted_[at] = points[k];
    }
}

}  // namespace muster
