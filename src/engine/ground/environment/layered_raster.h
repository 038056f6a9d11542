// A raster in two layers: static things, and the same with moving things (layered costmaps, Lu, Hershberger
// and Smart 2014).
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_rect.h"
#include "base/raster_view.h"

namespace muster {

/// One value per cell and layer. Values are only ever lowered to minima, so the order of things never
/// matters. A layer takes memory only once it differs from the layer under it: the fixed one from a constant,
/// the combined one from the fixed one.
class LayeredRaster {
public:
    /// Sets the size, and the value of every cell; frees the memory of both layers.
    void reset(const Grid& grid, float value) {
        grid_ = grid;
        value_ = value;
        fixed_ = {};
        moving_.clear();
        dropCombined();
    }
    /// Gives the fixed layer memory, so that fixed() and combined() are whole.
    void allocate() {
        if (fixed_.empty()) fixed_.assign(grid_.count(), value_);
    }
    /// Writes `value(cell)` to the fixed layer.
    template <class Value>
    void setFixed(const CellRect& rect, const Value& value) {
        allocate();
        forCells(rect, [&](Cell c, std::int32_t i) { fixed_[i] = value(c); });
    }
    /// Writes one value to the fixed layer.
    void fillFixed(const CellRect& rect, float value) {
        allocate();
        for (std::int32_t y = rect.low.y; y <= rect.high.y && !rect.empty(); ++y)
            std::fill_n(fixed_.begin() + grid_.index({rect.low.x, y}), rect.high.x - rect.low.x + 1, value);
    }
    /// Lowers the fixed layer to `value(cell, value so far)`.
    template <class Value>
    void lowerFixed(const CellRect& rect, const Value& value) {
        allocate();
        forCells(rect, [&](Cell c, std::int32_t i) { fixed_[i] = std::min(fixed_[i], value(c, fixed_[i])); });
    }
    /// Copies the fixed layer of `rect` to the combined one.
    void restoreFixed(const CellRect& rect) {
        if (combined_.empty()) return;
        for (std::int32_t y = rect.low.y; y <= rect.high.y && !rect.empty(); ++y) {
            const auto from = fixed_.begin() + grid_.index({rect.low.x, y});
            std::copy(from, from + (rect.high.x - rect.low.x + 1),
                      combined_.begin() + grid_.index({rect.low.x, y}));
        }
    }
    /// Takes all moving things off the combined layer; returns their areas, valid until the next call.
    std::span<const CellRect> removeMoving() {
        for (const CellRect& rect : moving_) restoreFixed(rect);
        removed_.swap(moving_);
        moving_.clear();
        return removed_;
    }
    /// Frees the memory of the combined layer, off which all moving things must be.
    void dropCombined() { combined_ = {}; }
    /// Areas of moving things.
    std::span<const CellRect> movingAreas() const { return moving_; }
    /// Lowers the combined layer to `value(cell, value so far)`, until the next removeMoving().
    template <class Value>
    void lowerCombined(const CellRect& rect, const Value& value) {
        if (rect.empty()) return;
        allocate();
        if (combined_.empty()) combined_ = fixed_;
        moving_.push_back(rect);
        forCells(rect, [&](Cell c, std::int32_t i) {
            combined_[i] = std::min(combined_[i], value(c, combined_[i]));
        });
    }
    /// Values without moving things; empty before allocate().
    std::span<const float> fixed() const { return fixed_; }
    /// Values with moving things; empty before allocate().
    std::span<const float> combined() const { return combined_.empty() ? fixed_ : combined_; }
    /// The view of fixed(), also before allocate().
    RasterView fixedView() const { return fixed_.empty() ? RasterView(&value_) : RasterView(fixed_); }
    /// The view of combined(), also before allocate().
    RasterView combinedView() const { return fixed_.empty() ? RasterView(&value_) : RasterView(combined()); }

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
    float value_ = 0.0f;
    std::vector<float> fixed_;
    std::vector<float> combined_;    // Values with moving things; empty while they equal fixed_.
    std::vector<CellRect> moving_;   // Areas in which the layers differ.
    std::vector<CellRect> removed_;  // Areas returned by the last removeMoving().
};

}  // namespace muster
