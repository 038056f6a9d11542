// A battle between groups of two sides: nobody is lost in it, and it repeats.
#include "scale/battle.h"

#include <doctest.h>

#include "scale/battle_script.h"

using namespace muster;
using namespace muster::scale;

namespace {

BattleDef smallBattle() {
    return {.groups = 6, .obstacles = 12, .side = 100.0, .seconds = 12.0};
}

}  // namespace

TEST_CASE("a small battle") {
    BattleDef def = smallBattle();
    const auto row = measureBattle(def);
    REQUIRE(row.ok());
    CHECK(row->characters >= 6 * 30);
    CHECK(row->orders == 2 * 40);
    CHECK(row->changes > 0.0);
    CHECK(row->changes < 3.0);
    CHECK(row->stuck == 0);
    CHECK(row->overlap <= 0.1);
    CHECK(row->speed <= 1.05);
    CHECK(row->outOfPlace <= row->characters / 20);
    CHECK(row->worst >= row->p95);
    CHECK(battleText(def, *row).find("silently stuck") != std::string::npos);
    const auto again = measureBattle(def);
    REQUIRE(again.ok());
    CHECK(again->hash == row->hash);
    def.seed = 2;
    const auto other = measureBattle(def);
    REQUIRE(other.ok());
    CHECK(other->hash != row->hash);
}

// Orders come in every 18th step: what a step knows only from the step before it would be missing there.
TEST_CASE("a battle goes on bit for bit from a snapshot with its orders, restored or rewound") {
    BattleDef def{.groups = 10, .seed = 3};
    BattleScript script(def);
    World world = World::create(script.world()).value();
    for (int s = 0; s < 720; ++s) {
        REQUIRE(script.before(world).ok());
        const bool looks = s % 18 == 0;
        const auto bytes = looks ? world.snapshot() : std::vector<std::uint8_t>();
        world.step();
        script.after(world);
        if (!looks) continue;
        const std::uint64_t hash = world.hash();
        World restored = World::restore(bytes, 2).value();
        restored.step();
        REQUIRE(restored.hash() == hash);
        REQUIRE(world.rewind(bytes).ok());
        world.step();
        REQUIRE(world.hash() == hash);
    }
}
