#include "muster/ground.h"
#include "test_folders.h"

#include <doctest.h>

#include <cmath>
#include <fstream>
#include <sstream>

#include "base/stopwatch.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

namespace {

std::string readMap(const char* name) {
    std::ifstream file(sourceFolder() + "/../shared/maps/" + name, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

std::string messageOf(const std::string& text) {
    const auto map = parseMap(text);
    REQUIRE(!map.ok());
    CHECK(map.status().code() == StatusCode::ParseError);
    return map.status().message();
}

bool isBlocked(char c) {
    return c == '@' || c == 'O' || c == 'T' || c == 'W';
}

// How many of the rectangles hold each cell's centre, counted cell by cell.
std::vector<int> countCells(const MapGrid& map, const MapDef& def, const std::vector<Polygon>& polygons) {
    std::vector<int> count(map.cells.size(), 0);
    for (const Polygon& polygon : polygons) {
        const Box box = boundsOf(polygon);
        for (std::int32_t row = 0; row < map.height; ++row) {
            const double y = def.origin.y + (map.height - row - 0.5) * def.metresPerCell;
            if (y < box.min.y || y > box.max.y) continue;
            for (std::int32_t column = 0; column < map.width; ++column) {
                const double x = def.origin.x + (column + 0.5) * def.metresPerCell;
                if (x > box.min.x && x < box.max.x)
                    count[row * map.width + column] += containsPoint(polygon, {x, y}) ? 1 : 0;
            }
        }
    }
    return count;
}

}  // namespace

TEST_CASE("a small map, with any line ends") {
    for (const std::string end : {"\n", "\r\n"}) {
        const std::string text = "type octile" + end + "height 3" + end + "width 4" + end + "map" + end +
                                 "..@@" + end + "G.TO" + end + "SS.W" + end;
        const auto map = parseMap(text);
        REQUIRE(map.ok());
        CHECK(map->width == 4);
        CHECK(map->height == 3);
        CHECK(map->cells == "..@@G.TOSS.W");
        const MapDef def{0.5, {10, 20}, 0.3};
        const auto obstacles = mapObstacles(*map, def);
        REQUIRE(obstacles.size() == 2);
        CHECK(boundsOf(obstacles[0].polygon).min == Vec2{11, 20.5});
        CHECK(boundsOf(obstacles[0].polygon).max == Vec2{12, 21.5});
        CHECK(boundsOf(obstacles[1].polygon).min == Vec2{11.5, 20});
        const auto patches = mapPatches(*map, def, 4);
        REQUIRE(patches.size() == 1);
        CHECK(patches[0].speed == 0.3);
        CHECK(patches[0].motion == 4);
        CHECK(boundsOf(patches[0].polygon).max == Vec2{11, 20.5});
    }
    CHECK(parseMap("width 1\nheight 1\ntype octile\nmap\n.").ok());
}

TEST_CASE("errors name the line") {
    CHECK(messageOf("") == "line 1: the file ends before `map`");
    CHECK(messageOf("type tile\n") == "line 1: expected `type octile`, found type `tile`");
    CHECK(messageOf("type octile\nheight x\n") == "line 2: expected height from 1 to 4096, found `x`");
    CHECK(messageOf("type octile\nheight 99999\n") ==
          "line 2: expected height from 1 to 4096, found `99999`");
    CHECK(messageOf("type octile\nheight 0\n").find("line 2") == 0);
    CHECK(messageOf("type octile\nheight 2\nmap\n..") == "line 3: the header gives no width before `map`");
    CHECK(messageOf("hello\n") == "line 1: expected type, height, width or map, found `hello`");
    const std::string head = "type octile\nheight 2\nwidth 3\nmap\n";
    CHECK(messageOf(head + "...\n..\n") == "line 6: expected a row of 3 cells, found 2");
    CHECK(messageOf(head + "...\n") == "line 6: expected 2 rows, found 1");
    CHECK(messageOf(head + "...\n.x.\n") ==
          "line 6: unknown cell in column 2: expected one of . G S @ O T W");
    CHECK(messageOf(head + "...\n...\n...\n") == "line 7: more rows than the height of 2");
    Random random(1);
    for (int i = 0; i < 3000; ++i) {
        std::string text = head + "...\n.@.\n";
        for (int k = 0; k < 3; ++k)
            text[random.below(static_cast<std::uint32_t>(text.size()))] = static_cast<char>(random.next());
        const auto map = parseMap(text);
        if (map.ok()) CHECK(map->cells.size() == static_cast<std::size_t>(map->width * map->height));
    }
}

TEST_CASE("cells that touch at a corner leave no gap") {
    Environment environment = emptyWorld(20.0, 0.25);
    const auto map = parseMap("type octile\nheight 2\nwidth 2\nmap\n@.\n.@\n");
    REQUIRE(map.ok());
    for (const ObstacleDef& def : mapObstacles(*map, {0.7, {-0.7, -0.7}, 0.4}))
        REQUIRE(environment.addObstacle(def).ok());
    CHECK(!environment.clearLine({-1, -1}, {1, 1}, 1e-3));
    CHECK(!environment.clearLine({-1, -1}, {1, 1}, 0.0));
    CHECK(environment.narrowGaps(0.5).empty());
}

TEST_CASE("real maps: every blocked cell lies in exactly one piece, no free cell in any") {
    for (const char* name : {"Berlin_0_256.map", "lak303d.map", "arena.map", "Brushfire.map"}) {
        const std::string text = readMap(name);
        if (text.empty()) {
            MESSAGE("skipped: ", std::string(name), " is not here");
            continue;
        }
        const auto map = parseMap(text);
        REQUIRE(map.ok());
        const MapDef def{1.0, {-3, 7}, 0.4};
        Stopwatch watch;
        std::vector<Polygon> polygons;
        for (const ObstacleDef& obstacle : mapObstacles(*map, def)) polygons.push_back(obstacle.polygon);
        const double ms = watch.milliseconds();
        const std::vector<int> count = countCells(*map, def, polygons);
        int wrong = 0, blocked = 0;
        for (std::size_t i = 0; i < count.size(); ++i) {
            wrong += count[i] != (isBlocked(map->cells[i]) ? 1 : 0) ? 1 : 0;
            blocked += isBlocked(map->cells[i]) ? 1 : 0;
        }
        CHECK(wrong == 0);
        CHECK(polygons.size() * 7 < static_cast<std::size_t>(blocked));
        MESSAGE(std::string(name), ": ", blocked, " blocked cells in ", polygons.size(), " pieces, ", ms,
                " ms");
    }
}

TEST_CASE("Berlin as an environment: the raster separates walls and streets") {
    const std::string text = readMap("Berlin_0_256.map");
    if (text.empty()) {
        MESSAGE("skipped: Berlin_0_256.map is not here");
        return;
    }
    const auto map = parseMap(text);
    REQUIRE(map.ok());
    auto made = Environment::create({.box = {{0, 0}, {256, 256}}, .cell = 0.5});
    REQUIRE(made.ok());
    Environment& environment = *made;
    for (const ObstacleDef& obstacle : mapObstacles(*map, {}))
        REQUIRE(environment.addObstacle(obstacle).ok());
    const Grid& grid = environment.grid();
    int wrong = 0;
    for (std::int32_t i = 0; i < grid.count(); ++i) {
        const Vec2 p = grid.centre(grid.at(i));
        const char c = map->cells[(255 - static_cast<int>(p.y)) * 256 + static_cast<int>(p.x)];
        if ((environment.clearance()[i] <= 0.0f) != isBlocked(c)) ++wrong;
    }
    CHECK(wrong == 0);
}
