// Gaps too narrow to pass, against flood fill on a fine raster, and the log of edits.
#include <doctest.h>

#include <cmath>

#include "base/random.h"
#include "engine/ground/environment/environment_scene.h"

using namespace muster;
using namespace muster::test;

TEST_CASE("a step through a gap narrower than a diameter is not free, one through a wider gap is") {
    for (const double shift : {0.0, 0.03, 0.08, 0.125}) {
        for (const double width : {0.44, 0.48, 0.499, 0.501, 0.52, 0.6}) {
            CAPTURE(shift);
            CAPTURE(width);
            Environment environment = emptyWorld(12.0, 0.25);
            // Two tips face each other, so that centres of cells on both sides are free.
            ObstacleDef upper, lower;
            upper.polygon = {{shift, 0.5 * width}, {3.0, 3.0}, {-3.0, 3.0}};
            lower.polygon = {{shift, -0.5 * width}, {-3.0, -3.0}, {3.0, -3.0}};
            REQUIRE(environment.addObstacle(upper).ok());
            REQUIRE(environment.addObstacle(lower).ok());
            CHECK(environment.stepIsFree({shift - 0.2, 0.0}, {shift + 0.2, 0.0}, 0.25) == (width > 0.5));
            CHECK(environment.stepIsFree({shift - 0.4, 0.0}, {shift - 0.2, 0.0}, 0.25));
            std::vector<ClosedGap> gaps;
            environment.closedGaps(environment.def().box, 0.5, gaps);
            REQUIRE(gaps.size() == (width < 0.5 ? 1 : 0));
            if (gaps.empty()) continue;
            CHECK(distance(gaps[0].a, gaps[0].b) == doctest::Approx(width));
            CHECK(crosses(gaps[0], {shift - 0.1, 0.05}, {shift + 0.1, -0.05}));
            CHECK_FALSE(crosses(gaps[0], {shift + 0.1, 0.05}, {shift + 0.2, -0.05}));
            CHECK_FALSE(crosses(gaps[0], {shift - 1, 0.3}, {shift + 1, 0.3}));
        }
    }
}

TEST_CASE("closed gaps lie between discs, parts and the edge of the world, and not where parts touch") {
    Environment environment = emptyWorld(12.0, 0.25);
    REQUIRE(environment.addObstacle(disc({0, 0}, 1.0)).ok());
    REQUIRE(environment.addObstacle(disc({2.3, 0}, 1.0)).ok());
    REQUIRE(environment.addObstacle(rectangle({-5.7, -1}, {-3, 1})).ok());
    REQUIRE(environment.addObstacle(rectangle({-5.7, 1}, {-3, 2})).ok());  // Touches the one before.
    std::vector<ClosedGap> gaps;
    environment.closedGaps(environment.def().box, 0.5, gaps);
    REQUIRE(gaps.size() == 3);  // Two to the left edge and one between the discs.
    CHECK(gaps[0].b.x == doctest::Approx(-6.0));
    CHECK(gaps[1].b.x == doctest::Approx(-6.0));
    CHECK(distance(gaps[2].a, gaps[2].b) == doctest::Approx(0.3));
    gaps.clear();
    environment.closedGaps({{3.0, 3.0}, {4.0, 4.0}}, 0.5, gaps);
    CHECK(gaps.empty());
    CHECK_FALSE(environment.stepIsFree({1.15, -0.2}, {1.15, 0.2}, 0.25));
    CHECK(environment.stepIsFree({-2.5, 0.9}, {-2.5, 1.1}, 0.25));
}

TEST_CASE("what free steps connect is what a fine raster connects") {
    Random random(11);
    const double radius = 0.25;
    int divided = 0;
    for (int round = 0; round < 12; ++round) {
        Environment coarse = emptyWorld(8.0, 0.25);
        Environment fine = emptyWorld(8.0, 0.02);
        const auto add = [&](Vec2 centre, double size) {
            REQUIRE(coarse.addObstacle(disc(centre, size)).ok());
            REQUIRE(fine.addObstacle(disc(centre, size)).ok());
        };
        for (int k = 0; k < 15; ++k)
            add({random.uniform(-4, 4), random.uniform(-4, 4)}, random.uniform(0.05, 0.4));
        // Pairs about a diameter apart, on either side of the step between two cells.
        for (int k = 0; k < 10; ++k) {
            const Vec2 middle{0.25 * random.below(24) - 3.0,
                              0.25 * random.below(24) - 2.875 + random.uniform(-0.02, 0.02)};
            const Vec2 half{random.uniform(-0.02, 0.02), random.uniform(0.26, 0.30)};
            add(middle + half, 0.04);
            add(middle - half, 0.04);
        }
        const FineRegions wider(fine, radius + 0.02, 0.02), slimmer(fine, radius - 0.02, 0.02);
        const Grid& grid = coarse.grid();
        int wrong = 0;
        for (std::int32_t i = 0; i < grid.count(); ++i) {
            const Cell c = grid.at(i);
            for (const Cell n : {Cell{c.x + 1, c.y}, Cell{c.x, c.y + 1}}) {
                if (!grid.contains(n)) continue;
                const Vec2 a = grid.centre(c), b = grid.centre(n);
                if (!coarse.clearLine(a, a, radius) || !coarse.clearLine(b, b, radius)) continue;
                const bool free = coarse.stepIsFree(a, b, radius);
                if (!free) {
                    ++divided;
                    // Certainly no straight line, then.
                    if (fine.clearLine(a, b, radius)) ++wrong;
                } else if (wider.at(a) != wider.at(b) && slimmer.at(a) != slimmer.at(b)) {
                    ++wrong;
                }
            }
        }
        CHECK(wrong == 0);
    }
    CHECK(divided > 10);
    MESSAGE("steps that lead through closed gaps: " << divided);
}

TEST_CASE("edits of things that stand still are remembered with the cells that they may change") {
    Environment environment = emptyWorld(40.0, 0.25);
    std::vector<CellRect> areas;
    CHECK(environment.staticChangesSince(0, areas));
    CHECK(areas.empty());
    const auto id = environment.addObstacle(rectangle({-1, -1}, {1, 1}));
    REQUIRE(id.ok());
    const std::uint64_t first = environment.staticVersion();
    REQUIRE(environment.changeObstacle(*id, rectangle({9, 9}, {10, 10})).ok());
    REQUIRE(environment.staticChangesSince(first, areas));
    CHECK(areas.size() == 2);  // Where it was and where it is, nothing between.
    const std::vector<float> before(environment.staticClearance().begin(),
                                    environment.staticClearance().end());
    const std::uint64_t second = environment.staticVersion();
    const std::uint64_t patches = environment.staticPatchVersion();
    REQUIRE(environment.removeObstacle(*id).ok());
    CHECK(environment.staticPatchVersion() == patches);
    areas.clear();
    REQUIRE(environment.staticChangesSince(second, areas));
    REQUIRE(areas.size() == 1);
    for (std::int32_t i = 0; i < environment.grid().count(); ++i) {
        const Cell c = environment.grid().at(i);
        if (environment.staticClearance()[i] != before[i]) REQUIRE(!areas[0].common({c, c}).empty());
    }
    REQUIRE(environment.addPatch({.polygon = {{0, 0}, {1, 0}, {1, 1}}, .speed = 0.5}).ok());
    CHECK(environment.staticPatchVersion() == environment.staticVersion());
    for (int k = 0; k < 1000; ++k) REQUIRE(environment.addObstacle(rectangle({-1, -1}, {1, 1})).ok());
    CHECK_FALSE(environment.staticChangesSince(second, areas));
    CHECK(environment.staticChangesSince(environment.staticVersion() - 100, areas));
}
