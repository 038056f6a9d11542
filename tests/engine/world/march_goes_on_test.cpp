// Marches that go on: where something is built elsewhere, and where some of the group have fallen.
#include <doctest.h>

#include <algorithm>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Sixty people who cross a field.
WorldDef field() {
    return {.box = {{-80, -60}, {80, 60}}, .groups = {{.count = 60, .position = {-50, 0}}}};
}

/// A house in the way, round which the stream parts.
WorldDef fieldWithHouse() {
    WorldDef def = field();
    def.obstacles.push_back(block(-4, -3, 4, 3));
    return def;
}

struct Crossing {
    World world;

    explicit Crossing(const WorldDef& def) : world(World::create(def).value()) {
        tell(world, Order::move({50, 0}));
    }
    double meanSpeed() const {
        double sum = 0.0;
        for (const Vec2 v : world.characters().velocity) sum += length(v);
        return sum / static_cast<double>(world.characters().size());
    }
};

}  // namespace

TEST_CASE("what is built far from a march changes nothing about it, bit by bit") {
    Crossing plain(fieldWithHouse()), edited(fieldWithHouse());
    run(plain.world, 6.0);
    run(edited.world, 6.0);
    REQUIRE(give(edited.world, putThing(block(17, 42, 23, 48))).ok());
    std::vector<std::uint8_t> middle;
    for (int s = 0; s < 60 * 20; ++s) {
        plain.world.step();
        edited.world.step();
        if (s == 5) middle = edited.world.snapshot();
        REQUIRE(std::ranges::equal(plain.world.characters().position, edited.world.characters().position));
    }
    World copy = World::restore(middle).value();
    while (copy.stepCount() < edited.world.stepCount()) copy.step();
    CHECK(copy.hash() == edited.world.hash());
}

TEST_CASE("a march goes round what is built on its way") {
    Crossing crossing(fieldWithHouse());
    run(crossing.world, 6.0);
    REQUIRE(give(crossing.world, putThing(block(22, -2, 28, 4))).ok());
    run(crossing.world, 50.0);
    CHECK(worstToPlace(crossing.world) < 0.5);
    CHECK(distance(middleOf(crossing.world), {50, 0}) < 0.5);
}

TEST_CASE("a march takes the way that is opened") {
    // A wall with a closed door, and another door 50 m aside.
    WorldDef def = field();
    def.obstacles = {block(20, 5, 22, 50), block(20, -60, 22, -5), block(19, -6, 23, 6)};
    Crossing crossing(def);
    run(crossing.world, 8.0);
    REQUIRE(give(crossing.world, removeThing(crossing.world.obstacleIds()[2])).ok());
    double highest = -60.0;
    for (int s = 0; s < 60 * 60; ++s) {
        crossing.world.step();
        for (const Vec2 p : crossing.world.characters().position) highest = std::max(highest, p.y);
    }
    CHECK(worstToPlace(crossing.world) < 0.5);
    CHECK(highest < 40.0);
}

TEST_CASE("who is left goes on when some fall on a march, and they close their ranks at its end") {
    Crossing crossing(fieldWithHouse());
    World& world = crossing.world;
    run(world, 8.0);
    const double before = crossing.meanSpeed();
    double slowest = before;
    for (std::size_t k = 0; k < 5; ++k) {
        const auto ids = world.characters().id;
        REQUIRE(give(world, TransferCharacters{{ids[7 * k], ids[7 * k + 3]}, {}}).ok());
        for (int s = 0; s < 30; ++s) {
            world.step();
            slowest = std::min(slowest, crossing.meanSpeed());
        }
    }
    CHECK(slowest > 0.85 * before);
    World copy = World::restore(world.snapshot()).value();
    run(world, 45.0);
    run(copy, 45.0);
    CHECK(copy.hash() == world.hash());
    CHECK(world.characters().size() == 50);
    CHECK(worstToPlace(world) < 0.5);
    CHECK(distance(middleOf(world), {50, 0}) < 0.5);
    // No place is left empty: each stands where the mesh of fifty has it.
    std::vector<std::int32_t> places = copyOf(world.characters().place);
    std::ranges::sort(places);
    for (std::int32_t k = 0; k < 50; ++k) CHECK(places[static_cast<std::size_t>(k)] == k);
    CHECK(world.group(0).placePositions.size() == 50);
}
