#include "engine/ground/routes/moving_regions.h"

#include "engine/ground/routes/route_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

/// Two walls that cross, with a door of 2 m in each arm, and gates that slide before the doors.
void addGates(Environment& environment, Random& random) {
    for (const Rotation turn : {Rotation{1, 0}, Rotation{0, 1}, Rotation{-1, 0}, Rotation{0, -1}}) {
        const auto turned = [&](Vec2 low, Vec2 high) {
            ObstacleDef def = rectangle(low, high);
            for (Vec2& p : def.polygon) p = turn.apply(p);
            return def;
        };
        REQUIRE(environment.addObstacle(turned({0, -0.2}, {11, 0.2})).ok());
        REQUIRE(environment.addObstacle(turned({13, -0.2}, {25, 0.2})).ok());
        ObstacleDef gate = turned({10.5, 0.4}, {13.5, 0.8});
        const Vec2 away = turn.apply({3.5, 0.0});
        const double when = random.uniform(0.0, 4.0);
        gate.path.waypoints = {{when, {0, 0}, 0.0}, {when + 0.5, away, 0.0}};
        REQUIRE(environment.addObstacle(gate).ok());
    }
}

/// The obstacles of another environment as they stand now, none of which moves.
Environment frozen(const Environment& environment, double side, double cell) {
    Environment copy = emptyWorld(side, cell);
    for (const ObstaclePiece& piece : environment.pieces()) {
        const ObstacleDef def = piece.corners.empty() ? disc(piece.centre, piece.radius)
                                                      : block(piece.corners);
        REQUIRE(copy.addObstacle(def).ok());
    }
    copy.setTime(0.0);
    return copy;
}

}  // namespace

TEST_CASE("regions with moving obstacles are those of the same ground where nothing moves, at any time") {
    int apart = 0, joined = 0;
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        Random random(seed);
        Environment environment = obstacleScene(random, 50.0, 0.25, 40, 2.0);
        addGates(environment, random);
        for (int k = 0; k < 8; ++k) (void)environment.addObstacle(randomObstacle(random, 24.0, true));
        RouteGraph graph;
        MovingRegions moving;
        for (const double time : {0.0, 1.3, 4.0}) {
            environment.setTime(time);
            graph.update(environment, kRadius);
            moving.update(graph);
            const FineRegions wide(environment, kRadius - 0.03, 0.05);
            const FineRegions narrow(environment, kRadius + 0.04, 0.05);
            const Environment still = frozen(environment, 50.0, 0.25);
            RouteGraph fresh;
            fresh.update(still, kRadius);
            std::vector<Vec2> points;
            while (points.size() < 40) {
                const Vec2 p{random.uniform(-25, 25), random.uniform(-25, 25)};
                if (narrow.at(p) >= 0) points.push_back(p);
            }
            for (const Vec2 a : points)
                for (const Vec2 b : points) {
                    const bool same = moving.region(a) >= 0 && moving.region(a) == moving.region(b);
                    CHECK(same == fresh.reachable(a, b));
                    if (same) CHECK(wide.at(a) == wide.at(b));
                    if (!same) CHECK(narrow.at(a) != narrow.at(b));
                    if (same) CHECK(graph.reachable(a, b));
                    apart += !same && graph.reachable(a, b) ? 1 : 0;
                    joined += same ? 1 : 0;
                }
        }
    }
    CHECK(apart > 100);
    CHECK(joined > 100);
}

TEST_CASE("without moving obstacles regions are those of the graph") {
    Random random(3);
    const Environment environment = obstacleScene(random, 40.0, 0.25, 120, 2.5);
    RouteGraph graph;
    graph.update(environment, kRadius);
    MovingRegions moving;
    moving.update(graph);
    for (int k = 0; k < 300; ++k) {
        const Vec2 p{random.uniform(-21, 21), random.uniform(-21, 21)};
        CHECK(moving.region(p) == graph.region(p));
    }
}
