// The lane ahead of a walker, against geometry; and who overtakes whom, in worlds of a few people.
#include <doctest.h>

#include <cmath>
#include <limits>
#include <vector>

#include "engine/steering/lane.h"
#include "muster/parameter_table.h"
#include "muster/world.h"

using namespace muster;

namespace {

GroupDef walkers(std::vector<Vec2> starts, double speed) {
    GroupDef group{.count = static_cast<std::int32_t>(starts.size())};
    Body body{.maxSpeed = speed};
    group.bodies.assign(starts.size(), body);
    group.starts = std::move(starts);
    group.orders = {Order::walk(0.0)};
    return group;
}

WorldDef corridor(double width, std::vector<GroupDef> groups) {
    return {
        .box = {{0, 0}, {60, width}}, .groups = std::move(groups), .parameters = *parameterPreset("people")};
}

void walk(World& world, double seconds) {
    while (world.time() < seconds) world.step();
}

}  // namespace

TEST_CASE("the way in the lane ends where two touch, and has no end beside it and behind") {
    constexpr double kEndless = std::numeric_limits<double>::infinity();
    const Vec2 east{1, 0}, north{0, 1};
    CHECK(wayAhead({2.0, 0.0}, east, 0.4) == doctest::Approx(1.6));
    CHECK(wayAhead({0.0, 2.0}, north, 0.4) == doctest::Approx(1.6));
    CHECK(wayAhead({0.4, 0.0}, east, 0.4) == doctest::Approx(0.0));
    CHECK(wayAhead({-2.0, 0.0}, east, 0.4) == kEndless);
    CHECK(wayAhead({2.0, 0.4 + kShoulders}, east, 0.4) == kEndless);
    CHECK(wayAhead({2.0, -0.4 - kShoulders}, east, 0.4) == kEndless);
    // Half as far to the side as the lane is wide: an ellipse of half axes 0.4 m and 0.5 m.
    CHECK(wayAhead({2.0, 0.25}, east, 0.4) == doctest::Approx(2.0 - 0.4 * std::sqrt(0.75)));
    CHECK(wayAhead({2.0, 0.25}, east, 0.4) == wayAhead({2.0, -0.25}, east, 0.4));
}

TEST_CASE("who is faster overtakes on the side that is open, wherever the slow one walks") {
    for (const double y : {0.3, 0.5, 0.7, 1.5, 2.3, 2.5, 2.7})
        for (const double aside : {-0.1, 0.0, 0.1}) {
            CAPTURE(y);
            CAPTURE(aside);
            World world = World::create(
                              corridor(3.0, {walkers({{8.0, y}}, 0.6), walkers({{4.0, y + aside}}, 1.4)}))
                              .value();
            walk(world, 20.0);
            const auto position = world.characters().position;
            CHECK(position[1].x > position[0].x + 3.0);
        }
}

TEST_CASE("where there is no side to overtake on the fast one keeps behind") {
    World world = World::create(corridor(0.6, {walkers({{8.0, 0.3}}, 0.6), walkers({{4.0, 0.3}}, 1.4)}))
                      .value();
    walk(world, 30.0);
    const CharactersView c = world.characters();
    CHECK(c.position[1].x < c.position[0].x - 2.0 * world.parameters().character.radius);
    // The law of headway: a gap of 0.6 m/s times the headway.
    const double gap = c.position[0].x - c.position[1].x - 2.0 * world.parameters().character.radius;
    CHECK(gap == doctest::Approx(0.6 * world.parameters().character.headway).epsilon(0.05));
}

TEST_CASE("in an even stream nobody turns") {
    std::vector<Vec2> starts;
    for (int row = 0; row < 48; ++row)
        for (int file = 0; file < 12; ++file) starts.push_back({1.25 * row + 0.5, 0.25 + 0.5 * file});
    WorldDef def = corridor(6.0, {walkers(starts, 1.34)});
    def.ring = true;
    World world = World::create(def).value();
    walk(world, 15.0);
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < starts.size(); ++i) CHECK(std::fabs(c.position[i].y - starts[i].y) < 0.05);
}
