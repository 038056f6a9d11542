// A large world works from end to end, and repeats.
#include "scale/large_ground.h"

#include <doctest.h>

using namespace muster;
using namespace muster::scale;

TEST_CASE("a made world of many obstacles is created, ordered about, edited and restored") {
    LargeGroundDef def{.side = 260.0, .obstacles = 150, .characters = 16, .away = 120.0, .steps = 60};
    const auto world = largeWorld(def);
    REQUIRE(world.ok());
    CHECK(world->obstacles.size() == 150);
    const auto row = runLargeGround(def);
    REQUIRE(row.ok());
    CHECK(row->edits.size() == 3);
    CHECK(row->create > 0.0);
    CHECK(largeGroundText(*row).find("edit: moved") != std::string::npos);
    const auto again = runLargeGround(def);
    REQUIRE(again.ok());
    CHECK(again->hash == row->hash);
    def.seed = 2;
    CHECK(runLargeGround(def)->hash != row->hash);
    def.map = "no such file";
    CHECK_FALSE(runLargeGround(def).ok());
}
