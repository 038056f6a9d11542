// Shapes made of straight ranks: square, line, column and wedge.
#include <algorithm>
#include <cmath>

#include "engine/formation/shapes/formation_shape.h"

namespace muster {
namespace {

// Adds a rank of `size` places at `x` [m], centred on the axis.
void addRank(std::vector<Vec2>& places, std::int32_t size, double x, double spacing) {
    for (std::int32_t k = 0; k < size; ++k) places.push_back({x, (k - 0.5 * (size - 1)) * spacing});
}

FormationShape ranks(std::int32_t count, std::int32_t files, double spacing) {
    FormationShape shape;
    for (std::int32_t done = 0, rank = 0; done < count; done += files, ++rank)
        addRank(shape.places, std::min(files, count - done), -rank * spacing, spacing);
    return shape;
}

}  // namespace

FormationShape squareShape(std::int32_t count, double spacing, std::int32_t files) {
    return ranks(count, files > 0 ? std::min(files, count) : squareFiles(count), spacing);
}

FormationShape lineShape(std::int32_t count, double spacing) {
    return ranks(count, count < 4 ? count : (count + 1) / 2, spacing);
}

FormationShape columnShape(std::int32_t count, double spacing) {
    return ranks(count, count < 4 ? 1 : 2, spacing);
}

// Rank k holds k + 1 places, as on a triangular lattice. The last rank is centred; its places are at least
// 0.86 spacings from all others.
FormationShape wedgeShape(std::int32_t count, double spacing) {
    FormationShape shape;
    const double step = std::sqrt(0.75) * spacing;
    std::int32_t left = count;
    for (std::int32_t rank = 0; left > 0; ++rank) {
        addRank(shape.places, std::min(left, rank + 1), -rank * step, spacing);
        left -= rank + 1;
    }
    shape.outline.outline = grownHull(shape.places, 0.5 * spacing);
    return shape;
}

}  // namespace muster
