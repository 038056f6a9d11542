#include "engine/ground/environment/box_grid.h"

#include <algorithm>

namespace muster {
namespace {

constexpr double kCellEdge = 2.0;  // Least edge of a cell [m].
// Greatest number of cells across; larger worlds get larger cells.
constexpr double kMostCellsAcross = 512.0;
constexpr std::int32_t kLeastCapacity = 4;  // Least capacity of a cell to which an item is added.

}  // namespace

void BoxGrid::reset(const Box& world) {
    const double across = std::max(world.width(), world.height());
    grid_ = Grid::covering(world, std::max(kCellEdge, across / kMostCellsAcross));
    ranges_.assign(grid_.count(), {});
    used_.clear();
    items_.clear();
}

template <class Visit>
void BoxGrid::forCells(const Box& box, const Visit& visit) {
    const Box world = grid_.box();
    if (box.max.x < world.min.x || box.max.y < world.min.y || box.min.x > world.max.x ||
        box.min.y > world.max.y)
        return;
    const Cell low = grid_.nearestCell(box.min), high = grid_.nearestCell(box.max);
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x) visit(grid_.index({x, y}));
}

void BoxGrid::fill(std::span<const Box> boxes, std::span<const std::int32_t> items) {
    for (const std::int32_t cell : used_) ranges_[cell] = {};
    used_.clear();
    for (const std::int32_t item : items)
        forCells(boxes[item], [&](std::int32_t cell) {
            if (ranges_[cell].capacity++ == 0) used_.push_back(cell);
        });
    std::int32_t next = 0;
    for (const std::int32_t cell : used_) {
        ranges_[cell].first = next;
        next += ranges_[cell].capacity;
    }
    items_.resize(next);
    for (const std::int32_t item : items)
        forCells(boxes[item], [&](std::int32_t cell) {
            Range& range = ranges_[cell];
            items_[range.first + range.count++] = item;
        });
}

// Moves the range of a cell to the end, with twice the room.
void BoxGrid::grow(std::int32_t cell) {
    Range& range = ranges_[cell];
    if (range.capacity == 0) used_.push_back(cell);
    const auto end = static_cast<std::int32_t>(items_.size());
    range.capacity = std::max(kLeastCapacity, 2 * range.capacity);
    items_.resize(end + range.capacity, 0);
    std::copy_n(items_.begin() + range.first, range.count, items_.begin() + end);
    range.first = end;
}

void BoxGrid::insert(const Box& box, std::int32_t item) {
    forCells(box, [&](std::int32_t cell) {
        Range& range = ranges_[cell];
        if (range.count == range.capacity) grow(cell);
        const auto begin = items_.begin() + range.first, end = begin + range.count;
        const auto at = std::lower_bound(begin, end, item);
        std::copy_backward(at, end, end + 1);
        *at = item;
        ++range.count;
    });
}

void BoxGrid::remove(const Box& box, std::int32_t item) {
    forCells(box, [&](std::int32_t cell) {
        Range& range = ranges_[cell];
        const auto begin = items_.begin() + range.first, end = begin + range.count;
        const auto at = std::lower_bound(begin, end, item);
        if (at == end || *at != item) return;
        std::copy(at + 1, end, at);
        --range.count;
    });
}

void BoxGrid::renumber(std::int32_t from, std::int32_t by) {
    for (std::int32_t& item : items_) item += item >= from ? by : 0;
}

}  // namespace muster
