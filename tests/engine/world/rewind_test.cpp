// Going back within a world: the same bits as a fresh process has, whatever the caches hold.
#include <doctest.h>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A busy floor with walls that make fields necessary.
WorldDef maze(std::uint64_t seed) {
    WorldDef def = busyFloor(seed);
    Random random(seed + 77);
    for (int k = 0; k < 4; ++k) {
        const double x = random.uniform(-10, 8), y = random.uniform(-10, 8);
        def.obstacles.push_back(block(x, y, x + random.uniform(0.3, 2.0), y + random.uniform(0.3, 3.0)));
    }
    return def;
}

std::vector<std::uint64_t> hashesOf(World& world, RandomDirector& director, int steps) {
    std::vector<std::uint64_t> hashes;
    for (int s = 0; s < steps; ++s) {
        director.act(world);
        world.step();
        hashes.push_back(world.hash());
    }
    return hashes;
}

}  // namespace

TEST_CASE("random runs with edits: a rewound world, a restored one and the first run agree in every step") {
    for (std::uint64_t seed = 1; seed <= 8; ++seed) {
        CAPTURE(seed);
        Random random(seed * 31);
        World world = World::create(maze(seed), seed % 2 == 0 ? 2 : 1).value();
        RandomDirector director(seed);
        (void)hashesOf(world, director, 30 + static_cast<int>(random.below(100)));
        for (int turn = 0; turn < 4; ++turn) {
            CAPTURE(turn);
            const auto bytes = world.snapshot();
            const RandomDirector then = director;
            const int steps = 8 + static_cast<int>(random.below(60));
            const auto first = hashesOf(world, director, steps);
            REQUIRE(world.rewind(bytes).ok());
            CHECK(world.snapshot() == bytes);
            RandomDirector again = then, other = then;
            CHECK(hashesOf(world, again, steps) == first);
            World restored = World::restore(bytes).value();
            CHECK(hashesOf(restored, other, steps) == first);
        }
    }
}

TEST_CASE("an edit in the very step after a snapshot, and an edit between snapshot and rewind") {
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        CAPTURE(seed);
        World world = World::create(maze(seed)).value();
        RandomDirector director(seed);
        (void)hashesOf(world, director, 60);
        const auto bytes = world.snapshot();
        const auto goOn = [&](World& w) {
            REQUIRE(give(w, putThing(block(-3, 4, -1, 6))).ok());
            REQUIRE(give(w, putThing(rectangle(-8, -2, -5, 2, 3))).ok());
            std::vector<std::uint64_t> hashes;
            for (int s = 0; s < 20; ++s) {
                w.step();
                hashes.push_back(w.hash());
            }
            return hashes;
        };
        const auto first = goOn(world);
        World restored = World::restore(bytes).value();
        CHECK(goOn(restored) == first);
        REQUIRE(world.rewind(bytes).ok());
        CHECK(goOn(world) == first);
    }
}

TEST_CASE("a world rewinds to snapshots of long ago, in any order, and of other commands") {
    World world = World::create(maze(5)).value();
    RandomDirector director(5);
    std::vector<std::vector<std::uint8_t>> snapshots;
    std::vector<RandomDirector> directors;
    std::vector<std::vector<std::uint64_t>> hashes;
    for (int k = 0; k < 6; ++k) {
        snapshots.push_back(world.snapshot());
        directors.push_back(director);
        hashes.push_back(hashesOf(world, director, 40));
    }
    Random random(9);
    for (int turn = 0; turn < 14; ++turn) {
        const std::uint32_t k = random.below(6);
        CAPTURE(k);
        REQUIRE(world.rewind(snapshots[k]).ok());
        RandomDirector again = directors[k];
        CHECK(hashesOf(world, again, 40) == hashes[k]);
        // Another course of events from there on.
        RandomDirector stranger(100 + static_cast<std::uint64_t>(turn));
        (void)hashesOf(world, stranger, 10);
    }
}

TEST_CASE("the exact plan and another world's snapshot rewind too") {
    WorldDef def = maze(3);
    def.parameters.plan.solver = PlanSolver::Exact;
    def.groups[0].count = 9;
    World world = World::create(def).value();
    RandomDirector director(3);
    (void)hashesOf(world, director, 25);
    const auto bytes = world.snapshot();
    RandomDirector then = director;
    const auto first = hashesOf(world, director, 12);
    REQUIRE(world.rewind(bytes).ok());
    CHECK(hashesOf(world, then, 12) == first);

    WorldDef wide = openFloor(30);
    wide.box = {{-30, -30}, {30, 30}};
    wide.cell = 0.5;
    World other = World::create(wide).value();
    for (int s = 0; s < 20; ++s) other.step();
    REQUIRE(world.rewind(other.snapshot()).ok());
    for (int s = 0; s < 20; ++s) {
        world.step();
        other.step();
        REQUIRE(world.hash() == other.hash());
    }
}
