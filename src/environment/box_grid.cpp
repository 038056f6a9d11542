#include "environment/box_grid.h"

#include <algorithm>

namespace muster {
namespace {

constexpr double kCellEdge = 2.0;           // [m]
constexpr double kMostCellsAcross = 512.0;  // Larger worlds get larger cells.

}  // namespace

void BoxGrid::reset(const Box& world) {
    const double across = std::max(world.width(), world.height());
    grid_ = Grid::covering(world, std::max(kCellEdge, across / kMostCellsAcross));
    first_.assign(grid_.count(), 0);
    count_.assign(grid_.count(), 0);
    items_.clear();
    entries_.clear();
}

void BoxGrid::fill(std::span<const Box> boxes, std::span<const std::int32_t> items) {
    for (const Entry& entry : entries_) count_[entry.cell] = 0;
    entries_.clear();
    const Box world = grid_.box();
    for (std::int32_t item : items) {
        const Box& box = boxes[item];
        if (box.max.x < world.min.x || box.max.y < world.min.y || box.min.x > world.max.x ||
            box.min.y > world.max.y) {
            continue;
        }
        const Cell low = grid_.nearestCell(box.min), high = grid_.nearestCell(box.max);
        for (std::int32_t y = low.y; y <= high.y; ++y) {
            for (std::int32_t x = low.x; x <= high.x; ++x) entries_.push_back({grid_.index({x, y}), item});
        }
    }
    for (const Entry& entry : entries_) ++count_[entry.cell];
    items_.resize(entries_.size());
    std::int32_t next = 0;
    for (const Entry& entry : entries_) {
        if (count_[entry.cell] == 0) continue;
        // The first entry of a cell reserves its range; the count is raised again while filling.
        first_[entry.cell] = next;
        next += count_[entry.cell];
        count_[entry.cell] = 0;
    }
    for (const Entry& entry : entries_) items_[first_[entry.cell] + count_[entry.cell]++] = entry.item;
}

}  // namespace muster
