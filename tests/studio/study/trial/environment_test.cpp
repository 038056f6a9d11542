#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "muster/scenario.h"
#include "muster/world.h"
#include "studio/study/trial/trial_environment.h"

namespace muster {
namespace {

double outside(const Polygon& corners, Vec2 p) {
    const Vec2 low = corners[0];
    const Vec2 high = corners[2];
    const double x = std::max(std::max(low.x - p.x, p.x - high.x), 0.0);
    const double y = std::max(std::max(low.y - p.y, p.y - high.y), 0.0);
    return std::hypot(x, y);
}

TEST_CASE("items of the study lie on free ground, apart from each other and from the start") {
    const StudyRules& rules = studyRules();
    for (const StudyEnvironment& environment : studyEnvironments()) {
        for (std::uint64_t seed = 1; seed <= 60; ++seed) {
            const auto def = studyWorld(environment, 36, seed, seed % 2 == 0);
            REQUIRE(def.ok());
            const std::vector<ItemDef>& items = def.value().items;
            REQUIRE(std::ssize(items) == rules.items);
            for (std::size_t i = 0; i < items.size(); ++i) {
                const Vec2 p = items[i].position;
                for (const ObstacleDef& obstacle : def.value().obstacles)
                    CHECK(outside(obstacle.polygon, p) >= rules.itemClearance - 1e-12);
                CHECK(p.x - rules.box.min.x >= rules.itemClearance);
                CHECK(rules.box.max.y - p.y >= rules.itemClearance);
                for (std::size_t j = 0; j < i; ++j)
                    CHECK(std::hypot(p.x - items[j].position.x, p.y - items[j].position.y) >=
                          rules.itemSpacing);
                const Vec2 start = def.value().groups[0].position;
                CHECK(std::max(std::abs(p.x - start.x), std::abs(p.y - start.y)) >= rules.startFree);
            }
        }
    }
}

TEST_CASE("items are spread evenly: each quarter of Four Blocks gets a quarter of them") {
    const StudyEnvironment environment = studyEnvironment("four-blocks").value();
    double upper = 0.0;
    double right = 0.0;
    double count = 0.0;
    for (std::uint64_t seed = 1; seed <= 200; ++seed) {
        const auto def = studyWorld(environment, 36, seed, false);
        for (const ItemDef& item : def.value().items) {
            upper += item.position.y > 0.0 ? 1.0 : 0.0;
            right += item.position.x > 0.0 ? 1.0 : 0.0;
            count += 1.0;
        }
    }
    // Four standard deviations of a fair coin.
    const double reach = 4.0 * 0.5 / std::sqrt(count);
    CHECK(std::abs(upper / count - 0.5) < reach);
    CHECK(std::abs(right / count - 0.5) < reach);
}

TEST_CASE("a mirrored world is the world upside down, and crowds of all sizes have the same items") {
    for (const StudyEnvironment& environment : studyEnvironments()) {
        const WorldDef plain = studyWorld(environment, 36, 7, false).value();
        const WorldDef mirrored = studyWorld(environment, 36, 7, true).value();
        const WorldDef large = studyWorld(environment, 100, 7, false).value();
        for (std::size_t i = 0; i < plain.items.size(); ++i) {
            CHECK(mirrored.items[i].position.x == plain.items[i].position.x);
            CHECK(mirrored.items[i].position.y == -plain.items[i].position.y);
            CHECK(large.items[i].position == plain.items[i].position);
        }
        double plainArea = 0.0;
        double mirroredArea = 0.0;
        for (const ObstacleDef& o : plain.obstacles) plainArea += (o.polygon[2].y - o.polygon[0].y);
        for (const ObstacleDef& o : mirrored.obstacles) mirroredArea += (o.polygon[2].y - o.polygon[0].y);
        CHECK(mirroredArea == doctest::Approx(plainArea));
        CHECK(scenarioWarnings(large).empty());
        CHECK(World::create(mirrored).ok());
    }
}

TEST_CASE("other names and numbers are refused by one sentence") {
    CHECK(studyEnvironment("maze").status().message().find("single-block") != std::string::npos);
    const StudyEnvironment environment = studyEnvironments()[0];
    CHECK_FALSE(studyWorld(environment, 0, 1, false).ok());
    CHECK(studyWorld(environment, 401, 1, false).status().message() ==
          "found a crowd of 401, expected 1 to 400");
}

TEST_CASE("the view shows the whole ground in the whole window") {
    const GroundView view = studyView();
    const StudyRules& rules = studyRules();
    const Vec2 corner = view.screenOf({rules.box.min.x, rules.box.max.y}).value();
    CHECK(corner.x == doctest::Approx(0.0));
    CHECK(corner.y == doctest::Approx(0.0));
    const Vec2 other = view.screenOf({rules.box.max.x, rules.box.min.y}).value();
    CHECK(other.x == doctest::Approx(rules.width));
    CHECK(other.y == doctest::Approx(rules.height));
    const Vec2 back = view.groundAt({480.0, 270.0}).value();
    CHECK(back.x == doctest::Approx(-10.0));
    CHECK(back.y == doctest::Approx(5.625));
}

}  // namespace
}  // namespace muster
