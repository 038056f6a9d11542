#include "scale/spots.h"

#include <cmath>
#include <cstdlib>

#include "base/maths.h"
#include "engine/ground/routes/route_graph.h"

namespace muster::scale {
namespace {

constexpr double kClearance = 0.3;  // Least distance from a spot to obstacles [m].

// Calls visit(x, y) for the lattice points, 2 apart, on the rim of a square of that half width.
template <class Visit>
void forRing(std::int32_t ring, Visit visit) {
    for (std::int32_t y = -ring; y <= ring; y += 2)
        for (std::int32_t x = -ring; x <= ring; x += std::abs(y) == ring ? 2 : 2 * ring) visit(x, y);
}

}  // namespace

Result<Environment> groundOf(const WorldDef& def) {
    Result<Environment> environment = Environment::create({.box = def.box, .cell = def.cell});
    if (!environment.ok()) return environment;
    std::vector<ObstacleDef> obstacles = def.obstacles;
    if (def.map)
        for (const ObstacleDef& obstacle : mapObstacles(def.map->grid, def.map->def))
            obstacles.push_back(obstacle);
    for (const ObstacleDef& obstacle : obstacles)
        if (const auto added = environment->addObstacle(obstacle); !added.ok()) return added.status();
    environment->setTime(0.0);
    return environment;
}

Result<std::vector<Vec2>> freeSpots(const Environment& ground, Vec2 centre, double angle,
                                    std::int32_t count) {
    const Rotation turn{cosine(angle), sine(angle)};
    RouteGraph routes;
    routes.update(ground, kClearance);
    const std::int32_t home = routes.region(routes.nearestReachable(centre, -1));
    const Box inner = ground.def().box.grown(-kClearance);
    std::vector<Vec2> spots;
    const auto farthest = static_cast<std::int32_t>(2.0 * (inner.width() + inner.height()));
    // The unit of `ring` is half a metre: a square with an even number of spots has them at odd multiples.
    const auto across = static_cast<std::int32_t>(std::ceil(std::sqrt(static_cast<double>(count))));
    for (std::int32_t ring = across % 2 == 0 ? 1 : 0; ring <= farthest; ring += 2) {
        forRing(ring, [&](std::int32_t x, std::int32_t y) {
            const Vec2 spot = centre + turn.apply({0.5 * x, 0.5 * y});
            if (static_cast<std::int32_t>(spots.size()) == count || !inner.contains(spot)) return;
            if (ground.distanceToObstacle(spot) >= kClearance && routes.region(spot) == home)
                spots.push_back(spot);
        });
        if (static_cast<std::int32_t>(spots.size()) == count) return spots;
    }
    return Status(StatusCode::LimitExceeded, "found room for " + std::to_string(spots.size()) +
                                                 " characters, expected " + std::to_string(count));
}

}  // namespace muster::scale
