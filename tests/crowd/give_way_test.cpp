#include "crowd/give_way.h"

#include <doctest.h>

#include <algorithm>

#include "crowd/characters.h"

using namespace muster;

namespace {

/// A street with a car of 4 m by 2 m that drives along y = 0 from the left at 2.2 m/s; its centre is at x = 0
/// after 20 s.
Environment street() {
    EnvironmentDef def;
    def.box = {{-50, -10}, {50, 10}};
    Environment environment = Environment::create(def).value();
    ObstacleDef car;
    car.polygon = {{-2, -1}, {2, -1}, {2, 1}, {-2, 1}};
    car.path.waypoints = {{0.0, {-44, 0}, 0.0}, {40.0, {44, 0}, 0.0}};
    REQUIRE(environment.addObstacle(car).ok());
    return environment;
}

/// One who stands at the kerb, just beside the ground that the car will sweep, and heads round the car's
/// front for a goal.
struct Pedestrian {
    Environment environment = street();
    Characters now;
    NeighbourList neighbours;
    std::vector<double> topSpeed{2.0};
    GiveWay giveWay;

    Pedestrian() {
        now.id = {1};
        now.group = {0};
        now.velocity = {{0, 0}};
        now.direction = {{1, 0}};
        now.cost = {8};
    }
    Vec2 prefers(double time, Vec2 position, Vec2 goal, Vec2 wish) {
        environment.setTime(time);
        now.position = {position};
        const std::vector<Vec2> goals{goal};
        std::vector<Vec2> preferred{wish};
        neighbours.build(now.position, 0.6);
        giveWay.run({}, now, environment, neighbours, topSpeed, goals, preferred);
        return preferred[0];
    }
};

// Beside the lane, whose edge is 1 m, a radius of 0.25 m and a margin of 0.3 m from the middle.
constexpr double kKerb = -1.56;

}  // namespace

TEST_CASE("who waits for a car does not walk along with it past its goal") {
    Pedestrian pedestrian;
    // The car's front is 2 m behind: there is no time to cross. The goal is across the street, 1 m back.
    const Vec2 wish{1.9, 0.6};
    const Vec2 waits = pedestrian.prefers(20.0, {4, kKerb}, {3, 4}, wish);
    CHECK(waits.x <= 1e-9);
    CHECK(waits.y <= 0.05);
    // Played on at that velocity, it is level with its goal when the car has passed, not 9 m down the street.
    double x = 1.0, farthest = x;
    for (int s = 0; s < 300; ++s) {
        x += pedestrian.prefers(20.0 + s / 60.0, {x, kKerb}, {3, 4}, wish).x / 60.0;
        const bool carIsNear = -44.0 + 2.2 * (20.0 + s / 60.0) - 2.0 < x;
        if (carIsNear) farthest = std::max(farthest, x);
    }
    CHECK(farthest > 2.5);
    CHECK(farthest < 3.05);
}

TEST_CASE("who walks beside a car along the street goes on, and so does who has time to cross") {
    Pedestrian pedestrian;
    const Vec2 wish{1.9, 0.6};
    // Its goal is far down the street: it keeps its pace along the kerb.
    CHECK(pedestrian.prefers(20.0, {4, kKerb}, {30, 4}, wish).x == doctest::Approx(1.9));
    // Its goal is on this side of the street.
    CHECK(pedestrian.prefers(20.0, {4, kKerb}, {3, -4}, {1.9, 0.0}).x == doctest::Approx(1.9));
    // The car is 20 m away.
    const Vec2 crosses = pedestrian.prefers(10.0, {4, kKerb}, {3, 4}, {0.0, 2.0});
    CHECK(crosses.y == doctest::Approx(2.0));
}
