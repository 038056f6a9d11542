// Square bins over the world, each with the boxes that touch it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"

namespace muster {

/// Answers "which boxes may hold this point" by one look-up. Only bins that hold something are
/// ever touched, so refilling with few boxes is cheap however large the world is.
class BoxBins {
public:
    /// Sets the bins over `world`; empties them.
    void reset(const Box& world);
    /// Refills with the boxes of these item numbers, given in ascending order.
    void fill(std::span<const Box> boxes, std::span<const std::int32_t> items);
    /// Items whose box touches the bin of `p`, ascending. `p` lies in the world.
    std::span<const std::int32_t> at(Vec2 p) const { return inBin(grid_.index(grid_.nearestCell(p))); }
    /// Items of a bin, ascending.
    std::span<const std::int32_t> inBin(std::int32_t bin) const {
        return {items_.data() + first_[bin], static_cast<std::size_t>(count_[bin])};
    }
    /// The bins as a grid.
    const Grid& grid() const { return grid_; }

private:
    struct Entry {
        std::int32_t bin;
        std::int32_t item;
    };

    Grid grid_;
    std::vector<std::int32_t> first_;  // Per bin, into items_.
    std::vector<std::int32_t> count_;  // Per bin.
    std::vector<std::int32_t> items_;
    std::vector<Entry> entries_;
};

}  // namespace muster
