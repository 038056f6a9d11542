// Small scenes that the tests of the environment share.
#pragma once

#include <doctest.h>

#include "base/grid_search.h"
#include "base/maths.h"
#include "base/random.h"
#include "engine/ground/environment/environment.h"

namespace muster::test {

/// A square world round the origin.
inline Environment emptyWorld(double side, double cell) {
    EnvironmentDef def{.box = {{-side / 2, -side / 2}, {side / 2, side / 2}}, .cell = cell};
    Result<Environment> made = Environment::create(def);
    REQUIRE(made.ok());
    return std::move(*made);
}

/// All values of a raster.
inline std::vector<float> valuesOf(const RasterView& view, const Grid& grid) {
    std::vector<float> values;
    for (std::int32_t i = 0; i < grid.count(); ++i) values.push_back(view[i]);
    return values;
}

inline ObstacleDef disc(Vec2 centre, double radius) {
    return {.centre = centre, .radius = radius};
}

inline ObstacleDef block(Polygon polygon) {
    return {.polygon = std::move(polygon)};
}

inline ObstacleDef rectangle(Vec2 low, Vec2 high) {
    return block({low, {high.x, low.y}, high, {low.x, high.y}});
}

/// A star-shaped polygon, as a rule concave.
inline Polygon randomStar(Random& random, Vec2 centre, double least, double most) {
    Polygon polygon;
    const int count = 3 + static_cast<int>(random.below(8));
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * kPi * (i + 0.6 * random.uniform()) / count;
        polygon.push_back(centre + Vec2{cosine(angle), sine(angle)} * random.uniform(least, most));
    }
    return polygon;
}

inline TimedPath randomPath(Random& random) {
    TimedPath path;
    for (int i = 0; i < 3; ++i)
        path.waypoints.push_back(
            {2.0 * i, {random.uniform(-4, 4), random.uniform(-4, 4)}, random.uniform(-3, 3)});
    path.loop = random.below(2) == 0;
    return path;
}

inline ObstacleDef randomObstacle(Random& random, double reach, bool moves) {
    const Vec2 centre{random.uniform(-reach, reach), random.uniform(-reach, reach)};
    ObstacleDef def = random.below(2) == 0 ? disc(centre, random.uniform(0.2, 1.5))
                                           : block(randomStar(random, centre, 0.4, 2.0));
    if (moves) def.path = randomPath(random);
    return def;
}

inline PatchDef randomPatch(Random& random, double reach, bool moves) {
    PatchDef def{.polygon = randomStar(random, {random.uniform(-reach, reach), random.uniform(-reach, reach)},
                                       0.8, 4.0),
                 .motion = static_cast<MotionId>(random.below(7)),
                 .speed = random.below(2) == 0 ? -1.0 : random.uniform(0.1, 1.5)};
    if (moves) def.path = randomPath(random);
    return def;
}

/// Regions by flood fill of fine cells whose centres are free for a disc of `radius`.
struct FineRegions {
    FineRegions(const Environment& environment, double radius, double cell)
        : grid(Grid::covering(environment.def().box, cell)), label(grid.count()) {
        const Box inner = environment.def().box.grown(-radius);
        for (std::int32_t i = 0; i < grid.count(); ++i) {
            const Vec2 p = grid.centre(grid.at(i));
            const bool free = inner.contains(p) && environment.distanceToObstacle(p, radius + 0.1) >= radius;
            label[i] = free ? kUnlabelled : -1;
        }
        std::vector<std::int32_t> stack;
        labelRegions(grid, label, stack);
    }
    std::int32_t at(Vec2 p) const { return label[grid.index(grid.nearestCell(p))]; }

    Grid grid;
    std::vector<std::int32_t> label;
};

}  // namespace muster::test
