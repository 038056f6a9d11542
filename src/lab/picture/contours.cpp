#include <cmath>

#include "lab/picture/picture.h"

namespace muster {

std::vector<std::pair<Vec2, Vec2>> contourSegments(std::int32_t width, std::int32_t height,
                                                   std::span<const double> samples, double level) {
    std::vector<std::pair<Vec2, Vec2>> segments;
    const auto value = [&](std::int32_t x, std::int32_t y) {
        return samples[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
                       static_cast<std::size_t>(x)];
    };
    for (std::int32_t y = 0; y + 1 < height; ++y) {
        for (std::int32_t x = 0; x + 1 < width; ++x) {
            const Vec2 corner[4] = {
                {x + 0.0, y + 0.0}, {x + 1.0, y + 0.0}, {x + 1.0, y + 1.0}, {x + 0.0, y + 1.0}};
            const double v[4] = {value(x, y), value(x + 1, y), value(x + 1, y + 1), value(x, y + 1)};
            if (!(std::isfinite(v[0]) && std::isfinite(v[1]) && std::isfinite(v[2]) && std::isfinite(v[3])))
                continue;
            std::vector<Vec2> hits;  // Crossings of the square's edges in order: two, or four at a saddle.
            for (int k = 0; k < 4; ++k) {
                const double a = v[k] - level, b = v[(k + 1) % 4] - level;
                if ((a < 0.0) != (b < 0.0)) hits.push_back(lerp(corner[k], corner[(k + 1) % 4], a / (a - b)));
            }
            for (std::size_t k = 0; k + 1 < hits.size(); k += 2) segments.emplace_back(hits[k], hits[k + 1]);
        }
    }
    return segments;
}

}  // namespace muster
