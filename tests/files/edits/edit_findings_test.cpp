// What is wrong with edited paths, against cases that one can compute by hand.
#include <doctest.h>

#include "engine/ground/environment/environment.h"
#include "files/edits/edit_findings.h"

using namespace muster;

namespace {

constexpr double kSpacing = 0.25;

/// Somebody who walks along x at 1 m/s, for 20 s.
RecordedPath walker(std::uint32_t id, Vec2 from) {
    RecordedPath path;
    path.person = id;
    path.radius = 0.25;
    path.topSpeed = 2.0;
    for (int k = 0; k <= 80; ++k) path.points.push_back(from + Vec2{k * kSpacing, 0.0});
    return path;
}

Environment groundWith(const std::vector<ObstacleDef>& obstacles) {
    EnvironmentDef def;
    def.box = {{-20.0, -20.0}, {40.0, 20.0}};
    auto ground = Environment::create(def);
    REQUIRE(ground.ok());
    for (const ObstacleDef& one : obstacles) REQUIRE(ground->addObstacle(one).ok());
    return std::move(ground).value();
}

TEST_CASE("edit findings: who is led onto another's path overlaps while the bodies meet") {
    // Both walk side by side, 2 m apart; a pin at 10 s brings the first onto the second.
    const std::vector<RecordedPath> paths{walker(1, {0.0, 0.0}), walker(2, {0.0, 2.0}),
                                          walker(3, {0.0, -9.0})};
    const std::vector<TakeEdit> edits{{{1}, {{10.0, {0.0, 2.0}, 4.0}}, {}, {}, {}}};
    const Environment ground = groundWith({});
    const auto found = findTroubles(edits, paths, kSpacing, 20.0, ground);
    REQUIRE(found.size() == 1);
    CHECK(found[0].person == 1);
    CHECK(found[0].kind == FindingKind::Person);
    CHECK(found[0].other == 2);
    // The weight is above (2 - 0.45) / 2 for shares below 0.335: 1.34 s to either side.
    CHECK(found[0].from == doctest::Approx(8.7).epsilon(0.011));
    CHECK(found[0].to == doctest::Approx(11.3).epsilon(0.011));
    CHECK(distance(found[0].where, {10.0, 2.0}) < 0.11);
    CHECK(found[0].worst == doctest::Approx(0.5));
    CHECK(found[0].text == "overlaps with person 2 from 8.7 to 11.3 s");
    CHECK(findTroubles({}, paths, kSpacing, 20.0, ground).empty());
}

TEST_CASE("edit findings: obstacles are named, and pins are moved clear of them") {
    ObstacleDef wall;
    wall.name = "Wall 2";
    wall.polygon = {{9.0, 2.0}, {11.0, 2.0}, {11.0, 4.0}, {9.0, 4.0}};
    const Environment ground = groundWith({wall});
    const std::vector<RecordedPath> paths{walker(1, {0.0, 0.0})};
    TakeEdit edit{{1}, {{10.0, {0.0, 2.2}, 6.0}}, {}, {}, {}};
    const auto found = findTroubles({edit}, paths, kSpacing, 20.0, ground);
    REQUIRE(found.size() == 1);
    CHECK(found[0].kind == FindingKind::Obstacle);
    CHECK(found[0].text.starts_with("goes through Wall 2 from "));
    CHECK(found[0].from < 10.0);
    CHECK(found[0].to > 10.0);
    keepClear(edit, paths, kSpacing, ground);
    CHECK(edit.pins[0].offset.y <= 1.75 + 1e-9);
    CHECK(edit.pins[0].offset.y > 1.7);
    CHECK(findTroubles({edit}, paths, kSpacing, 20.0, ground).empty());
}

TEST_CASE("edit findings: too fast, and off the ground") {
    const Environment ground = groundWith({});
    const std::vector<RecordedPath> paths{walker(1, {0.0, 0.0})};
    // 5 m aside within a second: 1.875 * 5 m/s at most.
    const auto fast = findTroubles({{{1}, {{10.0, {0.0, 5.0}, 1.0}}, {}, {}, {}}}, paths, kSpacing, 20.0,
                                   ground);
    REQUIRE_FALSE(fast.empty());
    CHECK(fast[0].kind == FindingKind::Speed);
    CHECK(fast[0].worst > 5.0);
    CHECK(fast[0].worst < 9.5);
    const auto away = findTroubles({{{1}, {{10.0, {0.0, 30.0}, 60.0}}, {}, {}, {}}}, paths, kSpacing, 20.0,
                                   ground);
    REQUIRE_FALSE(away.empty());
    CHECK(away[0].kind == FindingKind::Outside);
    CHECK(away[0].text.starts_with("leaves the ground from "));
    // Three times as fast for two seconds.
    const auto hurried = findTroubles({{{1}, {}, {{4.0, 4.0}, {6.0, 10.0}}, {}, {}}}, paths, kSpacing, 20.0,
                                      ground);
    REQUIRE(hurried.size() == 1);
    CHECK(hurried[0].kind == FindingKind::Speed);
}

}  // namespace
