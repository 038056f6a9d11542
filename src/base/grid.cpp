#include "base/grid.h"

#include <algorithm>

namespace muster {

Grid Grid::covering(const Box& box, double cell) {
    Grid grid;
    grid.origin = box.min;
    grid.cell = cell;
    // The tolerance keeps rounding from adding a cell to a box of a whole number of cells.
    grid.width = std::max(1, floorOf(box.width() / cell - 1e-9) + 1);
    grid.height = std::max(1, floorOf(box.height() / cell - 1e-9) + 1);
    return grid;
}

}  // namespace muster
