// Marked cells as few rectangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// Columns left <= x < right, rows top <= y < bottom.
struct CellBlock {
    std::int32_t left = 0;
    std::int32_t top = 0;
    std::int32_t right = 0;
    std::int32_t bottom = 0;
    friend auto operator<=>(const CellBlock&, const CellBlock&) = default;
};

/// Covers the marked cells (row by row, non-zero = marked) exactly by rectangles that do not overlap:
/// the best of three ways (runs of rows merged, runs of columns merged, the largest rectangle
/// first). Sorted by row and column.
std::vector<CellBlock> coverByRectangles(std::span<const char> marked, std::int32_t width,
                                         std::int32_t height);

}  // namespace muster
