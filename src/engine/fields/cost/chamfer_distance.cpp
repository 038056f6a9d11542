#include "engine/fields/cost/chamfer_distance.h"

#include <algorithm>
#include <cstddef>

namespace muster {

void chamferDistance(std::int32_t width, std::int32_t height, std::vector<float>& values) {
    constexpr float kDiagonal = 1.41421356f;
    const auto lower = [&](std::size_t at, std::int32_t x, std::int32_t y, std::int32_t dx, std::int32_t dy) {
        const std::int32_t nx = x + dx;
        const std::int32_t ny = y + dy;
        if (nx < 0 || ny < 0 || nx >= width || ny >= height) return;
        const float step = dx != 0 && dy != 0 ? kDiagonal : 1.0f;
        values[at] = std::min(values[at], values[static_cast<std::size_t>(ny) * width + nx] + step);
    };
    for (std::int32_t y = 0; y < height; ++y)
        for (std::int32_t x = 0; x < width; ++x) {
            const std::size_t at = static_cast<std::size_t>(y) * width + x;
            lower(at, x, y, -1, 0);
            lower(at, x, y, -1, -1);
            lower(at, x, y, 0, -1);
            lower(at, x, y, 1, -1);
        }
    for (std::int32_t y = height; y-- > 0;)
        for (std::int32_t x = width; x-- > 0;) {
            const std::size_t at = static_cast<std::size_t>(y) * width + x;
            lower(at, x, y, 1, 0);
            lower(at, x, y, 1, 1);
            lower(at, x, y, 0, 1);
            lower(at, x, y, -1, 1);
        }
}

}  // namespace muster
