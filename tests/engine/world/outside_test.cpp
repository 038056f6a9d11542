// Characters that are moved from outside.
#include <doctest.h>

#include <limits>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "engine/world/played.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

// One that is moved through a crowd of 25 that stands, along the x axis at 1.5 m/s.
struct Driven {
    Played played;

    explicit Driven(std::int32_t threads = 1) : played(scene()) {
        (void)threads;
        played.give(ChangeCharacters{{26}, {}, Driver::Outside});
    }
    static WorldDef scene() {
        WorldDef def = openFloor(25);
        def.groups.push_back({.count = 1, .position = {-11, 0}});
        return def;
    }
    Vec2 at(std::uint32_t step) const { return {-11.0 + 1.5 * step / 60.0, 0.1}; }
    void step() {
        played.give(WriteMotion{{26}, {at(played.world.stepCount() + 1)}, {}});
        played.run(1.0 / 60.0);
    }
};

}  // namespace

TEST_CASE("who is moved from outside is where it is put, and the others make room") {
    Driven driven;
    driven.played.run(0.1);
    const World& world = driven.played.world;
    double deepest = 0.0;
    for (int s = 0; s < 700; ++s) {
        driven.step();
        const CharactersView c = world.characters();
        CHECK(c.position[25] == driven.at(world.stepCount()));
        if (s > 0) CHECK(distance(c.velocity[25], {1.5, 0.0}) < 1e-6);
        for (std::size_t i = 0; i < 25; ++i)
            deepest = std::max(deepest, 1.0 - distance(c.position[i], c.position[25]) / 0.5);
    }
    CHECK(deepest < 0.35);
    CHECK(world.characters().driver[25] == Driver::Outside);
    driven.played.run(8.0);
    CHECK(driven.played.farthest(0) < 0.5);
    // Nobody has written since: it stands.
    CHECK(world.characters().velocity[25] == Vec2{});
    CHECK(world.characters().position[25] == driven.at(701 + 5));
}

TEST_CASE("Muster answers place, cost, way and wanted velocity of who is moved from outside") {
    WorldDef def = openFloor(4);
    def.obstacles = {block(-1, -4, 1, 12)};
    Played played(def);
    played.give(ChangeCharacters{{1}, {}, Driver::Outside});
    played.give(SetPose{GroupId{1}, {6, 3}, 0.0});
    played.run(8.0);
    const CharactersView c = played.world.characters();
    REQUIRE(c.place[0] >= 0);
    const std::vector<Vec2> way = played.world.wayAhead(0);
    REQUIRE(way.size() >= 3);
    CHECK(way.front() == c.position[0]);
    CHECK(distance(way.back(), played.world.group(0).placePositions[c.place[0]]) < 1e-9);
    double length = 0.0;
    for (std::size_t k = 1; k < way.size(); ++k) {
        length += distance(way[k - 1], way[k]);
        CHECK(inspect::environment(played.world).clearLine(way[k - 1], way[k], 0.24));
    }
    CHECK(c.cost[0] == doctest::Approx(length).epsilon(0.05));
    CHECK(muster::length(c.wantedVelocity[0]) == doctest::Approx(2.0).epsilon(0.05));
    CHECK(dot(normalized(c.wantedVelocity[0]), normalized(way[1] - way[0])) > 0.97);
    CHECK(c.velocity[0] == Vec2{});
    CHECK(played.world.wayAhead(99).empty());
}

TEST_CASE("who walks by the wanted velocity from outside arrives, and replays have the same bits") {
    std::uint64_t hashes[2];
    for (std::uint64_t& hash : hashes) {
        WorldDef def = openFloor(9);
        def.obstacles = {block(-1, -4, 1, 4)};
        Played played(def);
        std::vector<std::uint32_t> ids;
        for (std::uint32_t id = 1; id <= 9; ++id) ids.push_back(id);
        played.give(ChangeCharacters{ids, {}, Driver::Outside});
        played.give(SetPose{GroupId{1}, {6, 0}, 0.0});
        for (int s = 0; s < 900; ++s) {
            const CharactersView c = played.world.characters();
            WriteMotion write{ids, {}, {}};
            for (std::size_t i = 0; i < c.size(); ++i)
                write.positions.push_back(c.position[i] + c.wantedVelocity[i] * (1.0 / 60.0));
            played.give(write);
            played.run(1.0 / 60.0);
        }
        CHECK(played.farthest(0) < 0.2);
        hash = played.world.hash();
        const auto bytes = played.world.snapshot();
        CHECK(World::restore(bytes).value().hash() == hash);
    }
    CHECK(hashes[0] == hashes[1]);
}

TEST_CASE("positions are kept inside the box; of others and of nobody they are refused") {
    Driven driven;
    driven.played.run(0.1);
    driven.played.give(WriteMotion{{26}, {{500, -500}}, {{3, 0}}});
    driven.played.run(1.0 / 60.0);
    World& world = driven.played.world;
    CHECK(world.characters().position[25] == Vec2{11.75, -11.75});
    CHECK(world.characters().velocity[25] == Vec2{3, 0});
    const auto refusal = [&](CommandBody body) {
        REQUIRE(world.submit({world.stepCount(), 7, driven.played.sequence++, std::move(body)}).ok());
        world.step();
        REQUIRE(world.rejections().size() == 1);
        return world.rejections()[0].status.message();
    };
    CHECK(refusal(WriteMotion{{3}, {{0, 0}}, {}}) == "character 3 is moved by Muster, not from outside");
    CHECK(refusal(WriteMotion{{99}, {{0, 0}}, {}}) == "no character has the id 99");
    CHECK(refusal(ChangeCharacters{{99}, {}, Driver::Outside}) == "no character has the id 99");
    const double nan = std::numeric_limits<double>::quiet_NaN();
    CHECK(!world.submit({world.stepCount(), 7, 99, WriteMotion{{26}, {{nan, 0}}, {}}}).ok());
    // Taken back by Muster it walks home.
    driven.played.give(ChangeCharacters{{26}, {}, Driver::Muster});
    driven.played.run(25.0);
    CHECK(driven.played.farthest(1) < 0.3);
}
