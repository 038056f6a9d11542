#include "base/grid.h"

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

}  // namespace muster
