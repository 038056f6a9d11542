// Views of rasters that may be constant.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

namespace muster {

/// One value per cell, or one for all cells without a raster in memory: a pointer, and a mask of indices, so
/// that reading has no branch.
class RasterView {
public:
    /// Views a raster.
    RasterView(std::span<const float> values) : values_(values.data()), mask_(-1) {}              // NOLINT
    RasterView(const std::vector<float>& values) : RasterView(std::span<const float>(values)) {}  // NOLINT
    /// Views one value for all cells, which must outlive the view.
    explicit RasterView(const float* constant) : values_(constant), mask_(0) {}

    /// The value of a cell.
    float operator[](std::int32_t cell) const { return values_[cell & mask_]; }
    /// True for one value for all cells.
    bool isConstant() const { return mask_ == 0; }

private:
    const float* values_;
    std::int32_t mask_;
};

}  // namespace muster
