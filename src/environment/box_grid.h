// A uniform grid of boxes: the broad phase of point queries (Ericson 2005, Real-Time Collision
// Detection, 7.1).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Answers by one look-up which boxes may hold a point. Only cells that hold boxes are written, so refilling
/// with few boxes is cheap however large the world is.
class BoxGrid {
public:
    /// Lays the cells over `world` and empties them.
    void reset(const Box& world);
    /// Refills with the boxes of these item numbers, given in ascending order.
    void fill(std::span<const Box> boxes, std::span<const std::int32_t> items);
    /// Items whose box touches the cell of `p`, ascending. `p` lies in the world.
    std::span<const std::int32_t> at(Vec2 p) const {
        const std::int32_t cell = grid_.index(grid_.nearestCell(p));
        return {items_.data() + first_[cell], static_cast<std::size_t>(count_[cell])};
    }

private:
    struct Entry {
        std::int32_t cell;
        std::int32_t item;
    };

    Grid grid_;
    std::vector<std::int32_t> first_;  // Per cell, index of its first entry in items_.
    std::vector<std::int32_t> count_;  // Per cell, number of items.
    std::vector<std::int32_t> items_;  // Cell by cell.
    std::vector<Entry> entries_;       // One per pair of cell and item.
};

}  // namespace muster
