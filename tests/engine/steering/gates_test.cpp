#include "engine/steering/gates.h"

#include <doctest.h>

#include "engine/steering/characters.h"

using namespace muster;

namespace {

/// A wall of 1 m with a door of `width` [m] in the middle.
Environment wallWithDoor(double width) {
    EnvironmentDef def;
    def.box = {{-10, -10}, {10, 10}};
    Environment environment = Environment::create(def).value();
    for (const double side : {-1.0, 1.0}) {
        ObstacleDef wall;
        const double from = side * 0.5 * width, to = side * 10.0;
        wall.polygon = {{-0.5, std::min(from, to)},
                        {0.5, std::min(from, to)},
                        {0.5, std::max(from, to)},
                        {-0.5, std::max(from, to)}};
        REQUIRE(environment.addObstacle(wall).ok());
    }
    return environment;
}

/// One who comes from the left at 1.2 m from the wall, one from the right, both on the line through the door.
struct Meeting {
    Characters now;
    std::vector<Vec2> leaving = std::vector<Vec2>(2), preferred{{2, 0}, {-2, 0}};

    Meeting() {
        now.id = {1, 2};
        now.group = {0, 1};
        now.position = {{-1.7, 0}, {1.7, 0}};
        now.direction = {{1, 0}, {-1, 0}};
        now.velocity = {{2, 0}, {-2, 0}};
        now.cost = {8, 8};
    }
    bool run(Environment& environment, double time) {
        environment.setTime(time);
        leaving.assign(2, {});
        preferred = {{2, 0}, {-2, 0}};
        return Gates().run({}, now, environment, leaving, preferred);
    }
    bool hasTurn(std::size_t i) const { return leaving[i] == Vec2{} && lengthSquared(preferred[i]) > 3.9; }
};

}  // namespace

TEST_CASE("those who meet at a door for one take turns, and all stand clear before it changes") {
    Environment environment = wallWithDoor(0.55);
    Meeting meeting;
    int turns[2] = {0, 0}, neither = 0, changes = 0;
    std::size_t last = 2;
    for (int second = 0; second < 160; ++second) {
        CHECK(meeting.run(environment, second));
        const bool first = meeting.hasTurn(0), other = meeting.hasTurn(1);
        CHECK_FALSE((first && other));
        neither += !first && !other ? 1 : 0;
        if (!first && !other) continue;
        const std::size_t now = first ? 0 : 1;
        ++turns[now];
        changes += last != now ? 1 : 0;
        last = now;
    }
    CHECK(std::abs(turns[0] - turns[1]) <= 8);
    CHECK(changes >= 6);
    CHECK(neither >= 3);
    CHECK(neither < 40);
    // Who waits on the line leaves it sideways.
    meeting.run(environment, 1.0);
    const std::size_t waits = meeting.hasTurn(0) ? 1 : 0;
    CHECK(meeting.leaving[waits].x == doctest::Approx(0.0));
    CHECK(length(meeting.leaving[waits]) > 1.0);
}

TEST_CASE("nobody waits at a door for two, at one that is too narrow, or where all go the same way") {
    for (const double width : {0.4, 1.2}) {
        Environment environment = wallWithDoor(width);
        Meeting meeting;
        CHECK_FALSE(meeting.run(environment, 0.0));
        CHECK((meeting.hasTurn(0) && meeting.hasTurn(1)));
    }
    Environment environment = wallWithDoor(0.55);
    Meeting meeting;
    meeting.now.position[1] = {-2.6, 0};
    meeting.now.direction[1] = {1, 0};
    for (int second = 0; second < 60; ++second) CHECK_FALSE(meeting.run(environment, second));
}

TEST_CASE("a gate is as deep as what stands still makes it, wherever moving things were when it was found") {
    Environment environment = wallWithDoor(0.55);
    ObstacleDef car;  // Passes along the axis of the door, and is away from it at the end.
    car.centre = {1.5, 0.6};
    car.radius = 0.5;
    car.path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {0, 8}, 0.0}};
    REQUIRE(environment.addObstacle(car).ok());
    Gates kept;
    Meeting meeting;
    for (const double x : {0.7, 1.2, 1.7, 2.5, 3.5, 4.2}) {
        CAPTURE(x);
        environment.setTime(0.0);
        meeting.now.position = {{-x, 0.3}, {x, 0.3}};
        kept.run({}, meeting.now, environment, meeting.leaving, meeting.preferred);
        environment.setTime(10.0);
        meeting.leaving.assign(2, {});
        meeting.preferred = {{2, 0}, {-2, 0}};
        kept.run({}, meeting.now, environment, meeting.leaving, meeting.preferred);
        const std::vector<Vec2> leaving = meeting.leaving, preferred = meeting.preferred;
        meeting.run(environment, 10.0);
        CHECK(leaving == meeting.leaving);
        CHECK(preferred == meeting.preferred);
    }
}
