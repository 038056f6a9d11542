// A raster kept in two storeys: what stands still, and with moving things laid over it.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_rect.h"

namespace muster {

/// Values per cell. Both storeys only ever take minima, so the order of things never matters.
class RasterLayer {
public:
    /// Sets size and value everywhere.
    void reset(const Grid& grid, float value) {
        grid_ = grid;
        still_.assign(static_cast<std::size_t>(grid.count()), value);
        live_ = still_;
        covered_.clear();
    }
    /// Writes `value(cell)` to the still storey.
    template <class Value>
    void setStill(const CellRect& rect, const Value& value) {
        forCells(rect, [&](Cell c, std::size_t i) { still_[i] = value(c); });
    }
    /// Lowers the still storey to `value(cell, value so far)`.
    template <class Value>
    void lowerStill(const CellRect& rect, const Value& value) {
        forCells(rect, [&](Cell c, std::size_t i) { still_[i] = std::min(still_[i], value(c, still_[i])); });
    }
    /// Makes the live storey equal to the still one in `rect`.
    void copyStill(const CellRect& rect) {
        for (std::int32_t y = rect.low.y; y <= rect.high.y && !rect.empty(); ++y) {
            const auto from = still_.begin() + grid_.index({rect.low.x, y});
            std::copy(from, from + (rect.high.x - rect.low.x + 1),
                      live_.begin() + grid_.index({rect.low.x, y}));
        }
    }
    /// Takes all moving things off the live storey; returns where they were, until the next call.
    std::span<const CellRect> uncover() {
        for (const CellRect& rect : covered_) copyStill(rect);
        uncovered_.swap(covered_);
        covered_.clear();
        return uncovered_;
    }
    /// Where moving things lie.
    std::span<const CellRect> covered() const { return covered_; }
    /// Lowers the live storey to `value(cell, value so far)`, until the next uncover().
    template <class Value>
    void lowerLive(const CellRect& rect, const Value& value) {
        if (rect.empty()) return;
        covered_.push_back(rect);
        forCells(rect, [&](Cell c, std::size_t i) { live_[i] = std::min(live_[i], value(c, live_[i])); });
    }
    std::span<const float> still() const { return still_; }  ///< Without moving things.
    std::span<const float> live() const { return live_; }    ///< With them.

private:
    template <class Visit>
    void forCells(const CellRect& rect, const Visit& visit) {
        for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
            for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
                visit(Cell{x, y}, static_cast<std::size_t>(grid_.index({x, y})));
            }
        }
    }

    Grid grid_;
    std::vector<float> still_;
    std::vector<float> live_;
    std::vector<CellRect> covered_;  // Where the live storey differs.
    std::vector<CellRect> uncovered_;
};

}  // namespace muster
