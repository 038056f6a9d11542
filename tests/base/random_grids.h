// Grids and points that are drawn.
#pragma once

#include "base/grid.h"
#include "base/random.h"

namespace muster::test {

inline Grid coveringGrid(Random& random) {
    const Vec2 corner{random.uniform(-500, 500), random.uniform(-500, 500)};
    const Vec2 size{random.uniform(0.01, 60), random.uniform(0.01, 60)};
    return Grid::covering({corner, corner + size}, random.uniform(0.05, 4.0));
}

inline Vec2 pointIn(const Box& box, Random& random) {
    return {random.uniform(box.min.x, box.max.x), random.uniform(box.min.y, box.max.y)};
}

}  // namespace muster::test
