#include "engine/state/standing_room.h"

#include <doctest.h>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

TEST_CASE("all who join at one point beside a wall stand apart and outside it") {
    Environment environment = Environment::create({.box = {{-10, -10}, {10, 10}}}).value();
    REQUIRE(environment.addObstacle(block(-10, -10, -2, 10)).ok());
    environment.setTime(0.0);
    StandingRoom room(environment, 0.25);
    std::vector<Vec2> all{{0, 0}, {0.6, 0.3}};
    for (const Vec2 p : all) room.occupy(p);
    for (int k = 0; k < 150; ++k) all.push_back(room.take({-3, 0.1}));
    for (std::size_t i = 0; i < all.size(); ++i) {
        CHECK(environment.distanceToObstacle(all[i]) > 0.25 - 1e-6);
        for (std::size_t k = 0; k < i; ++k) CHECK(distance(all[i], all[k]) > 0.5);
    }
}

TEST_CASE("where nothing is free, those who join stand at the nearest point all the same") {
    EnvironmentDef def{.box = {{-0.6, -0.6}, {0.6, 0.6}}};
    Environment environment = Environment::create(def).value();
    environment.setTime(0.0);
    StandingRoom room(environment, 0.25);
    for (int k = 0; k < 9; ++k) CHECK(def.box.contains(room.take({0, 0})));
}
