// Partition of a binary image into few rectangles.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// Columns left <= x < right, rows top <= y < bottom.
struct CellBlock {
    std::int32_t left = 0;    ///< First column.
    std::int32_t top = 0;     ///< First row.
    std::int32_t right = 0;   ///< Column after the last.
    std::int32_t bottom = 0;  ///< Row after the last.
    friend auto operator<=>(const CellBlock&, const CellBlock&) = default;
};

/// Partitions the marked cells (row by row, non-zero = marked) into rectangles. Two partitions are made and
/// the smaller is returned: row runs merged with equal runs of the next row, and the same with columns.
/// Sorted by row and column. Takes time in proportion to the cells.
std::vector<CellBlock> partitionIntoRectangles(std::span<const char> marked, std::int32_t width,
                                               std::int32_t height);

}  // namespace muster
