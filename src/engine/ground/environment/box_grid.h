// A uniform grid of boxes: the broad phase of point queries (Ericson 2005, Real-Time Collision
// Detection, 7.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Answers by one look-up which boxes may hold a point. Only cells that hold boxes are written, so refilling
/// with few boxes, or changing one of many, is cheap however large the world is.
class BoxGrid {
public:
    /// Lays the cells over `world` and empties them.
    void reset(const Box& world);
    /// Refills with the boxes of these item numbers, given in ascending order.
    void fill(std::span<const Box> boxes, std::span<const std::int32_t> items);
    /// Adds an item that is not there.
    void insert(const Box& box, std::int32_t item);
    /// Removes an item that was added with this box.
    void remove(const Box& box, std::int32_t item);
    /// Adds `by` to all item numbers from `from` on. They must stay in order.
    void renumber(std::int32_t from, std::int32_t by);
    /// Items whose box touches the cell of `p`, ascending. `p` lies in the world.
    std::span<const std::int32_t> at(Vec2 p) const {
        const Range& range = ranges_[grid_.index(grid_.nearestCell(p))];
        return {items_.data() + range.first, static_cast<std::size_t>(range.count)};
    }

private:
    /// The items of a cell: a range of items_ with room for more.
    struct Range {
        std::int32_t first = 0;
        std::int32_t count = 0;
        std::int32_t capacity = 0;
    };
    template <class Visit>
    void forCells(const Box& box, const Visit& visit);
    void grow(std::int32_t cell);

    Grid grid_;
    std::vector<Range> ranges_;        // Range of each cell.
    std::vector<std::int32_t> used_;   // Cells whose capacity is above zero.
    std::vector<std::int32_t> items_;  // Ranges, and gaps where ranges have grown and moved away.
};

}  // namespace muster
