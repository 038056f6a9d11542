// A battle between groups of two sides: nobody is lost in it, and it repeats.
#include "scale/battle.h"

#include <doctest.h>

using namespace muster::scale;

TEST_CASE("a small battle") {
    BattleDef def;
    def.groups = 6;
    def.obstacles = 12;
    def.side = 100.0;
    def.seconds = 12.0;
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
