// Routes over a real city, against flood fill of its map.
#include <fstream>
#include <sstream>

#include "engine/ground/routes/route_scene.h"
#include "muster/ground.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::test;

namespace {

// The regions of the free cells of a map, joined over their edges. Cells are wider than people and blocked
// cells that meet at a corner leave no gap, so people get exactly as far.
std::vector<std::int32_t> regionsOf(const MapGrid& map, const Grid& grid) {
    std::vector<std::int32_t> label(grid.count());
    for (std::int32_t i = 0; i < grid.count(); ++i) {
        const Cell c = grid.at(i);
        const char here = map.cells[(map.height - 1 - c.y) * map.width + c.x];
        label[i] = here == '.' || here == 'G' ? kUnlabelled : -1;
    }
    std::vector<std::int32_t> stack;
    labelRegions(grid, label, stack);
    return label;
}

}  // namespace

TEST_CASE("in Berlin a route leads between two cells exactly where flood fill of the map joins them") {
    std::ifstream file(sourceFolder() + "/../shared/maps/Berlin_0_256.map", std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (text.str().empty()) {
        MESSAGE("skipped: Berlin_0_256.map is not here");
        return;
    }
    const auto map = parseMap(text.str());
    REQUIRE(map.ok());
    EnvironmentDef def{.box = {{0, 0}, {256, 256}}, .cell = 0.5};
    auto environment = Environment::create(def);
    REQUIRE(environment.ok());
    for (const ObstacleDef& obstacle : mapObstacles(*map, {}))
        REQUIRE(environment->addObstacle(obstacle).ok());
    environment->setTime(0.0);
    RouteGraph graph;
    graph.update(*environment, 0.25);
    const Grid cells = Grid::covering(def.box, 1.0);
    const std::vector<std::int32_t> label = regionsOf(*map, cells);
    CHECK(graph.regionCount() == 1 + *std::max_element(label.begin(), label.end()));
    Random random(3);
    const auto any = [&] {
        for (;;) {
            const auto i = static_cast<std::int32_t>(random.below(static_cast<std::uint32_t>(cells.count())));
            if (label[i] >= 0) return i;
        }
    };
    int joined = 0, apart = 0;
    for (int k = 0; k < 400; ++k) {
        const std::int32_t i = any(), j = any();
        const Vec2 a = cells.centre(cells.at(i)), b = cells.centre(cells.at(j));
        const bool same = label[i] == label[j];
        CHECK(graph.reachable(a, b) == same);
        if (k % 10 == 0) CHECK(findRoute(graph, a, b).empty() == !same);
        ++(same ? joined : apart);
    }
    CHECK(joined > 200);
    CHECK(apart > 0);
}
