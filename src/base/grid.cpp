#include "muster/base/grid.h"

#include <algorithm>

namespace muster {
Grid Grid::covering(const Box& box, double cell) {
    Grid grid;
    grid.origin = box.min;
    grid.cell = cell;
    // A hair is taken off, so that a box of a whole number of cells gets just these.
    grid.width = std::max(1, floorOf(box.width() / cell - 1e-9) + 1);
    grid.height = std::max(1, floorOf(box.height() / cell - 1e-9) + 1);
    return grid;
}

BilinearStencil Grid::bilinear(Vec2 p) const {
    const double u = std::clamp((p.x - origin.x) / cell - 0.5, 0.0, static_cast<double>(width - 1));
    const double v = std::clamp((p.y - origin.y) / cell - 0.5, 0.0, static_cast<double>(height - 1));
    const std::int32_t x0 = std::min(static_cast<std::int32_t>(u), std::max(0, width - 2));
    const std::int32_t y0 = std::min(static_cast<std::int32_t>(v), std::max(0, height - 2));
    const std::int32_t x1 = std::min(x0 + 1, width - 1);
    const std::int32_t y1 = std::min(y0 + 1, height - 1);
    const double fx = u - x0;
    const double fy = v - y0;
    return {{index({x0, y0}), index({x1, y0}), index({x0, y1}), index({x1, y1})},
            {(1 - fx) * (1 - fy), fx * (1 - fy), (1 - fx) * fy, fx * fy}};
}

}  // namespace muster
