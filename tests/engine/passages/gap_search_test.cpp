// Passages with their exact width.
#include <doctest.h>

#include "engine/passages/passage.h"
#include "engine/passages/passage_scene.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::vector<Vec2> straightWay(Vec2 a, Vec2 b) {
    std::vector<Vec2> way;
    for (int k = 0; k <= 80; ++k) way.push_back(lerp(a, b, k / 80.0));
    return way;
}

}  // namespace

TEST_CASE("a door is as wide as it is, however the way leads through it") {
    const Environment environment = walledFloor({{-0.6, 0.6}});
    for (const double slant : {0.0, 3.0, -6.0}) {
        const auto passage = narrowestPassage(environment, straightWay({-10, -slant}, {10, slant}));
        REQUIRE(passage);
        CHECK(passage->width() == doctest::Approx(1.2).epsilon(1e-6));
        CHECK(passage->throughput() == doctest::Approx(1.2).epsilon(1e-6));
        CHECK(std::abs(passage->middle().y) < 1e-6);
        CHECK(std::abs(passage->middle().x) <= 0.5 + 1e-6);
        // The narrows are as deep as the wall is thick.
        CHECK(passage->left + passage->right == doctest::Approx(1.0).epsilon(0.3));
    }
}

TEST_CASE("a gap between a corner and a disc is their distance; one to the edge of the world counts") {
    Environment environment = Environment::create({.box = {{-20, -20}, {20, 20}}}).value();
    ObstacleDef block, disc;
    block.polygon = {{-2, 1}, {2, 1}, {2, 5}, {-2, 5}};
    disc.radius = 1.0;
    disc.centre = {3.0, -1.5};
    REQUIRE(environment.addObstacle(block).ok());
    REQUIRE(environment.addObstacle(disc).ok());
    environment.setTime(0.0);
    const auto passage = narrowestPassage(environment, straightWay({-6, 0}, {8, 0.4}));
    REQUIRE(passage);
    CHECK(passage->width() == doctest::Approx(std::sqrt(1.0 + 2.5 * 2.5) - 1.0).epsilon(1e-4));
    const auto edge = narrowestPassage(environment, straightWay({-6, 7}, {8, 7}));
    REQUIRE(edge);
    CHECK(edge->width() == doctest::Approx(15.0).epsilon(1e-6));
}

TEST_CASE("slow ground takes its share of the capacity") {
    Environment environment = walledFloor({{-1, 1}});
    PatchDef patch{.polygon = {{-0.4, -1}, {0.4, -1}, {0.4, 1}, {-0.4, 1}}, .motion = 1, .speed = 0.25};
    REQUIRE(environment.addPatch(patch).ok());
    environment.setTime(0.0);
    const auto passage = narrowestPassage(environment, straightWay({-10, 0}, {10, 0}));
    REQUIRE(passage);
    CHECK(passage->throughput() == doctest::Approx(2.0 * 0.25).epsilon(1e-6));
}

TEST_CASE("points of a way beyond the edge of the world belong to no gap; those inside do as ever") {
    Environment environment = Environment::create({.box = {{-20, -20}, {20, 20}}}).value();
    ObstacleDef block{.polygon = {{-2, -17}, {2, -17}, {2, 5}, {-2, 5}}};
    REQUIRE(environment.addObstacle(block).ok());
    environment.setTime(0.0);
    CHECK_FALSE(narrowestPassage(environment, straightWay({-6, -20.25}, {6, -20.25})));
    // A way that leaves the world behind the gap between the block and the edge.
    std::vector<Vec2> way = straightWay({-6, -18}, {6, -18});
    way.push_back({7, -20.25});
    const auto passage = narrowestPassage(environment, way);
    REQUIRE(passage);
    CHECK(passage->width() == doctest::Approx(3.0).epsilon(1e-6));
}
