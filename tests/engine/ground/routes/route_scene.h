// Scenes of obstacles and a second way to find the shortest path, for the tests of routes.
#pragma once

#include <limits>

#include "engine/ground/environment/environment_scene.h"
#include "engine/ground/routes/route_search.h"

namespace muster::test {

/// Of a character whose route is searched [m].
inline constexpr double kRadius = 0.25;

/// A square world with boxes, stars and discs in it.
inline Environment obstacleScene(Random& random, double side, double cell, int obstacles, double size) {
    Environment environment = emptyWorld(side, cell);
    const double reach = 0.5 * side;
    for (int k = 0; k < obstacles; ++k) {
        const Vec2 at{random.uniform(-reach, reach), random.uniform(-reach, reach)};
        switch (random.below(3)) {
            case 0:
                (void)environment.addObstacle(disc(at, random.uniform(0.1, 0.6) * size));
                break;
            case 1: {
                const Vec2 half{random.uniform(0.05, size), random.uniform(0.05, size)};
                (void)environment.addObstacle(rectangle(at - half, at + half));
                break;
            }
            default:
                (void)environment.addObstacle(block(randomStar(random, at, 0.3 * size, size)));
        }
    }
    environment.setTime(0.0);
    return environment;
}

/// The length of the shortest path among those whose corners lie on arcs about the corners of obstacles: a
/// visibility graph. Infinite where there is none.
class VisibilityGraph {
public:
    VisibilityGraph(const Environment& environment, double radius, int perCorner = 12)
        : environment_(environment), radius_(radius) {
        for (const ObstaclePiece& piece : environment.pieces()) {
            const double reach = (radius + 2e-3) / std::cos(kPi / perCorner);
            const auto addAround = [&](Vec2 centre, double r) {
                for (int k = 0; k < perCorner; ++k) {
                    const double angle = 2.0 * kPi * k / perCorner;
                    const Vec2 p = centre + Vec2{cosine(angle), sine(angle)} * r;
                    if (environment.clearStaticLine(p, p, radius)) points_.push_back(p);
                }
            };
            if (piece.corners.empty())
                addAround(piece.centre, piece.radius / std::cos(kPi / perCorner) + reach);
            for (const Vec2 corner : piece.corners) addAround(corner, reach);
        }
        const std::size_t n = points_.size();
        edges_.resize(n);
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = i + 1; j < n; ++j)
                if (environment.clearStaticLine(points_[i], points_[j], radius)) {
                    edges_[i].push_back(static_cast<int>(j));
                    edges_[j].push_back(static_cast<int>(i));
                }
    }

    double shortest(Vec2 from, Vec2 to) const {
        constexpr double kNever = std::numeric_limits<double>::infinity();
        if (environment_.clearStaticLine(from, to, radius_)) return distance(from, to);
        const std::size_t n = points_.size();
        std::vector<double> cost(n, kNever);
        std::vector<char> done(n, 0);
        for (std::size_t i = 0; i < n; ++i)
            if (environment_.clearStaticLine(from, points_[i], radius_)) cost[i] = distance(from, points_[i]);
        double best = kNever;
        for (;;) {
            std::size_t at = n;
            for (std::size_t i = 0; i < n; ++i)
                if (done[i] == 0 && cost[i] < (at < n ? cost[at] : kNever)) at = i;
            if (at == n || cost[at] >= best) return best;
            done[at] = 1;
            if (environment_.clearStaticLine(points_[at], to, radius_))
                best = std::min(best, cost[at] + distance(points_[at], to));
            for (const int j : edges_[at])
                cost[j] = std::min(cost[j], cost[at] + distance(points_[at], points_[j]));
        }
    }

private:
    const Environment& environment_;
    double radius_;
    std::vector<Vec2> points_;
    std::vector<std::vector<int>> edges_;
};

}  // namespace muster::test
