#include "base/summed_area_table.h"

namespace muster {

void SummedAreaTable::build(const Grid& grid, const CellSet& cells) {
    bounds_ = {{grid.width, grid.height}, {-1, -1}};
    for (const std::int32_t cell : cells.members()) {
        const Cell c = grid.at(cell);
        bounds_.low = {std::min(bounds_.low.x, c.x), std::min(bounds_.low.y, c.y)};
        bounds_.high = {std::max(bounds_.high.x, c.x), std::max(bounds_.high.y, c.y)};
    }
    stride_ = std::max(0, bounds_.high.x - bounds_.low.x + 1) + 1;
    const std::int32_t rows = std::max(0, bounds_.high.y - bounds_.low.y + 1) + 1;
    sums_.assign(static_cast<std::size_t>(stride_) * rows, 0);
    for (std::int32_t y = 1; y < rows; ++y) {
        std::int32_t row = 0;
        const std::uint8_t* member = cells.flags().data() +
                                     grid.index({bounds_.low.x, bounds_.low.y + y - 1});
        std::int32_t* out = sums_.data() + static_cast<std::size_t>(y) * stride_;
        for (std::int32_t x = 1; x < stride_; ++x) {
            row += member[x - 1];
            out[x] = out[x - stride_] + row;
        }
    }
}

}  // namespace muster
