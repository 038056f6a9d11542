// A crowd that is led through made caves arrives.
#include "scale/led_ground.h"

#include <doctest.h>

#include <algorithm>

#include "scale/caves.h"

using namespace muster;
using namespace muster::scale;

TEST_CASE("made caves are framed by rock, about half free, and repeat") {
    const MapGrid caves = madeCaves(200, 150, 4);
    REQUIRE(caves.cells.size() == 200 * 150);
    const auto free = std::count(caves.cells.begin(), caves.cells.end(), '.');
    CHECK(free > 200 * 150 / 4);
    CHECK(free < 200 * 150 * 3 / 4);
    for (int x = 0; x < 200; ++x) CHECK(caves.cells[x] == '@');
    CHECK(madeCaves(200, 150, 4).cells == caves.cells);
    CHECK(madeCaves(200, 150, 5).cells != caves.cells);
}

TEST_CASE("a few are led through a map from end to end") {
    LedGroundDef def{
        .ground = {.characters = 20, .caves = {160, 160}, .metres = 0.5}, .length = 25.0, .seconds = 120.0};
    const auto row = runLedGround(def);
    REQUIRE(row.ok());
    CHECK(row->led > 0.0);
    CHECK(row->missing == 0);
    CHECK(row->arrived >= row->led);
    CHECK(ledGroundText(*row).find("arrived") != std::string::npos);
    def.ground.map = "no such file";
    CHECK_FALSE(runLedGround(def).ok());
}
