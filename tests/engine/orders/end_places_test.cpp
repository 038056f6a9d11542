#include "engine/orders/end_places.h"

#include <doctest.h>

#include <algorithm>

#include "base/maths.h"

using namespace muster;

namespace {

struct RoutedGround {
    Environment environment;
    RouteGraph routes;
    PlaceDef def;
    NearestReachable nearest;

    explicit RoutedGround(const std::vector<Polygon>& walls, Box box = {{-20, -20}, {20, 20}})
        : environment(make(walls, box)) {
        routes.update(environment, def.radius);
    }
    static Environment make(const std::vector<Polygon>& walls, Box box) {
        Environment environment = Environment::create({.box = box}).value();
        for (const Polygon& outline : walls) {
            ObstacleDef wall;
            wall.name = "wall";
            wall.polygon = outline;
            REQUIRE(environment.addObstacle(wall).ok());
        }
        environment.setTime(0.0);
        return environment;
    }
};

std::vector<Vec2> squareOf(int side, double spacing) {
    std::vector<Vec2> points;
    for (int k = 0; k < side * side; ++k)
        points.push_back(Vec2{k / side - (side - 1) / 2.0, k % side - (side - 1) / 2.0} * spacing);
    return points;
}

struct Found {
    std::vector<Vec2> ends;
    Pose pose;
    double nearest = 1e9;
    bool free = true;
};

Found foundAt(RoutedGround& ground, const std::vector<Vec2>& offsets, Vec2 target,
              std::vector<Vec2> taken = {}) {
    const FreeSpace space(ground.def, ground.routes, -1, ground.nearest);
    EndDef def{.offsets = offsets};
    for (const Vec2 p : offsets) def.reach = std::max(def.reach, length(p));
    def.pose.position = target;
    def.taken = taken;
    def.from = target - Vec2{30, 0};
    Found found;
    EndPlaces places;
    places.find(def, space, 2.4 * ground.def.radius, found.ends, found.pose);
    for (std::size_t i = 0; i < found.ends.size(); ++i) {
        found.free = found.free && space.contains(found.ends[i]);
        for (std::size_t j = 0; j < i; ++j)
            found.nearest = std::min(found.nearest, distance(found.ends[i], found.ends[j]));
    }
    return found;
}

}  // namespace

TEST_CASE("on open ground places are as ordered") {
    RoutedGround ground({});
    const std::vector<Vec2> offsets = squareOf(8, 1.0);
    const Found found = foundAt(ground, offsets, {3, -2});
    CHECK(found.pose.position == Vec2{3, -2});
    for (std::size_t i = 0; i < offsets.size(); ++i) CHECK(found.ends[i] == offsets[i] + Vec2{3, -2});
}

TEST_CASE("at the edge of the world and beside a house the whole formation stands where it fits") {
    RoutedGround ground({{{5, -3}, {9, -3}, {9, 3}, {5, 3}}});
    const std::vector<Vec2> offsets = squareOf(6, 1.0);
    for (const Vec2 target : {Vec2{19.5, 10}, Vec2{4, 0}, Vec2{-19, -19}}) {
        const Found found = foundAt(ground, offsets, target);
        CHECK(found.free);
        CHECK(found.nearest == doctest::Approx(1.0));
        CHECK(distance(found.pose.position, target) < 6.0);
    }
}

TEST_CASE("in a room that is too small for it, a formation is laid out in it and not behind its walls") {
    // A room of 5 by 5 m with a door far from the target; outside there is room for all.
    RoutedGround ground({{{0, 0}, {0.2, 0}, {0.2, 6}, {0, 6}},
                         {{0.2, 0}, {5.2, 0}, {5.2, 0.2}, {0.2, 0.2}},
                         {{5.2, 0}, {5.4, 0}, {5.4, 6}, {5.2, 6}}});
    const Found found = foundAt(ground, squareOf(4, 1.1), {2.6, 2.2});
    CHECK(found.free);
    CHECK(found.nearest >= 0.6 - 1e-9);
    for (const Vec2 p : found.ends) {
        CHECK(p.x > 0.2);
        CHECK(p.x < 5.2);
        CHECK(p.y > 0.2);
    }
}

TEST_CASE("where others stand, or will stand, a formation stands beside them on its own side") {
    RoutedGround ground({});
    const std::vector<Vec2> offsets = squareOf(6, 1.0);
    const Found first = foundAt(ground, offsets, {0, 0});
    const Found second = foundAt(ground, offsets, {0, 0}, first.ends);
    double between = 1e9, middle = 0.0;
    for (const Vec2 p : second.ends) {
        middle += p.x / static_cast<double>(second.ends.size());
        for (const Vec2 q : first.ends) between = std::min(between, distance(p, q));
    }
    CHECK(second.free);
    CHECK(between >= 0.6);
    CHECK(middle < -2.0);  // It comes from there.
}

TEST_CASE("formations that come from all sides to one point stand round it, each on its own side") {
    RoutedGround ground({}, {{-60, -60}, {60, 60}});
    const std::vector<Vec2> offsets = squareOf(10, 1.0);
    std::vector<Vec2> taken;
    for (int k = 0; k < 20; ++k) {
        const double angle = 2.0 * kPi * k / 20.0;
        const FreeSpace space(ground.def, ground.routes, -1, ground.nearest);
        EndDef def{.offsets = offsets};
        for (const Vec2 p : offsets) def.reach = std::max(def.reach, length(p));
        def.from = Vec2{cosine(angle), sine(angle)} * 55.0;
        def.pose.rotation = {cosine(angle), sine(angle)};
        def.taken = taken;
        EndPlaces places;
        std::vector<Vec2> ends;
        Pose pose;
        places.find(def, space, 0.5, ends, pose);
        CAPTURE(k);
        CHECK((k == 0 || dot(pose.position, normalized(def.from)) > 0.5 * length(pose.position)));
        // As near as there is room: twenty squares of 110 square metres in a disc of 40 m.
        for (const Vec2 p : ends) CHECK(length(p) < 40.0);
        for (const Vec2 p : ends)
            for (const Vec2 q : taken) CHECK(distance(p, q) > 0.5);
        taken.insert(taken.end(), ends.begin(), ends.end());
    }
}
