// A raster in two layers: what stands still, and the same with moving things (layered costmaps, Lu,
// Hershberger and Smart 2014).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_rect.h"

namespace muster {

/// One value per cell and layer. Values are only ever lowered to minima, so the order of things never
/// matters.
class LayeredRaster {
public:
    /// Sets the size, and the value of every cell.
    void reset(const Grid& grid, float value) {
        grid_ = grid;
        fixed_.assign(grid.count(), value);
        combined_ = fixed_;
        moving_.clear();
    }
    /// Writes `value(cell)` to the fixed layer.
    template <class Value>
    void setFixed(const CellRect& rect, const Value& value) {
        forCells(rect, [&](Cell c, std::int32_t i) { fixed_[i] = value(c); });
    }
    /// Lowers the fixed layer to `value(cell, value so far)`.
    template <class Value>
    void lowerFixed(const CellRect& rect, const Value& value) {
        forCells(rect, [&](Cell c, std::int32_t i) { fixed_[i] = std::min(fixed_[i], value(c, fixed_[i])); });
    }
    /// Copies the fixed layer of `rect` to the combined one.
    void restoreFixed(const CellRect& rect) {
        for (std::int32_t y = rect.low.y; y <= rect.high.y && !rect.empty(); ++y) {
            const auto from = fixed_.begin() + grid_.index({rect.low.x, y});
            std::copy(from, from + (rect.high.x - rect.low.x + 1),
                      combined_.begin() + grid_.index({rect.low.x, y}));
        }
    }
    /// Takes all moving things off the combined layer; returns where they were, valid until the next call.
    std::span<const CellRect> removeMoving() {
        for (const CellRect& rect : moving_) restoreFixed(rect);
        removed_.swap(moving_);
        moving_.clear();
        return removed_;
    }
    /// Where moving things lie.
    std::span<const CellRect> movingAreas() const { return moving_; }
    /// Lowers the combined layer to `value(cell, value so far)`, until the next removeMoving().
    template <class Value>
    void lowerCombined(const CellRect& rect, const Value& value) {
        if (rect.empty()) return;
        moving_.push_back(rect);
        forCells(rect, [&](Cell c, std::int32_t i) {
            combined_[i] = std::min(combined_[i], value(c, combined_[i]));
        });
    }
    std::span<const float> fixed() const { return fixed_; }        ///< Without moving things.
    std::span<const float> combined() const { return combined_; }  ///< With them.

private:
    template <class Visit>
    void forCells(const CellRect& rect, const Visit& visit) {
        for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
            for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
                visit(Cell{x, y}, grid_.index({x, y}));
            }
        }
    }

    Grid grid_;
    std::vector<float> fixed_;
    std::vector<float> combined_;
    std::vector<CellRect> moving_;   // Where the layers differ.
    std::vector<CellRect> removed_;  // What the last removeMoving() returned.
};

}  // namespace muster
