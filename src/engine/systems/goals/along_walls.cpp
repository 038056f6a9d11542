#include "engine/systems/goals/along_walls.h"

#include <algorithm>

#include "base/infinite_cost.h"

namespace muster {
namespace {

constexpr double kTouchDistance = 0.02;  // Distance at which a body touches a wall [m].
constexpr double kWallTolerance = 2e-3;  // Distance by which a step may come nearer to a wall [m].
constexpr double kRootHalf = 0.70710678118654752;

/// The walls round a body.
struct WallsRound {
    const Environment& environment;
    Vec2 p;
    double radius;
    Box sides;    // Sides of the world, for centres of bodies.
    double room;  // Distance to walls that a step leaves at least [m].

    WallsRound(const Environment& ground, Vec2 at, double body)
        : environment(ground), p(at), radius(body), sides(ground.def().sides().grown(kWallTolerance - body)) {
        room = std::min(radius, environment.distanceToObstacle(p, radius)) - kWallTolerance;
    }

    bool isFree(Vec2 way) const {
        const Vec2 q = p + way * kTouchDistance;
        const bool inside = sides.contains(q) || !sides.contains(p);
        return inside && !(environment.distanceToObstacle(q, radius) < room);
    }

    /// The slope of the cost [1/m] along a wall, over `reach` [m] or up to what stops the body before.
    double slope(Vec2 way, double reach, FunctionRef<double(Vec2)> cost) const {
        while (reach > kTouchDistance && !environment.clearLine(p, p + way * reach, room)) reach *= 0.5;
        const double here = cost(p);
        return (cost(p + way * reach) - (here < kInfiniteCost ? here : 0.0)) / reach;
    }

    /// Calls `visit` with the unit vector to each wall that the body touches, in no fixed order.
    template <class Visit>
    void forTouched(const Visit& visit) const {
        environment.forPiecesNear(p, radius + kTouchDistance, [&](const ObstaclePiece& piece) {
            const SurfacePoint nearest = closestSurfacePoint(piece, p);
            if (nearest.distance > radius + kTouchDistance || !(nearest.distance > 0.0)) return;
            visit((nearest.point - p) / nearest.distance);
        });
        const Box near = sides.grown(-kTouchDistance);
        if (p.x < near.min.x || p.x > near.max.x) visit(Vec2{1.0, 0.0});
        if (p.y < near.min.y || p.y > near.max.y) visit(Vec2{0.0, 1.0});
    }
};

// True where no wall is so near that a step could end in it.
bool isFarFromWalls(const Environment& environment, Vec2 p, double radius) {
    const Grid& grid = environment.grid();
    const Cell c = grid.nearestCell(p);
    const auto clearance = static_cast<double>(environment.clearance()[grid.index(c)]);
    return clearance > radius + kTouchDistance + kRootHalf * grid.cell && grid.box().contains(p);
}

}  // namespace

Vec2 alongWalls(const Environment& environment, Vec2 p, double radius, Vec2 direction,
                FunctionRef<double(Vec2)> cost) {
    if (direction == Vec2{} || isFarFromWalls(environment, p, radius)) return direction;
    const WallsRound walls(environment, p, radius);
    if (walls.isFree(direction)) return direction;
    // Cells resolve no shorter path along a wall [m].
    const double reach = std::max(environment.grid().cell, radius);
    Vec2 best = direction;
    double least = kInfiniteCost;
    walls.forTouched([&](Vec2 towards) {
        for (const Vec2 way : {perpendicular(towards), -perpendicular(towards)}) {
            if (!walls.isFree(way)) continue;
            const double slope = walls.slope(way, reach, cost);
            const bool first = way.x != best.x ? way.x < best.x : way.y < best.y;
            if (slope > least || (slope == least && !first)) continue;
            least = slope;
            best = way;
        }
    });
    return best;
}

}  // namespace muster
