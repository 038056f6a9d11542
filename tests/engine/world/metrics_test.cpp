#include "engine/world/metrics.h"
#include "engine/ground/environment/environment.h"

#include <doctest.h>

#include <cmath>

using namespace muster;

namespace {

/// One character that walks ten metres along x in the open.
WorldDef walkDef(double side = 0.0) {
    WorldDef def{.box = {{-8, -6}, {8, 6}},
                 .groups = {{.count = 3,
                             .formation = {.kind = FormationKind::Points,
                                           .points = {{5, side}, {5, side + 2}, {5, side - 2}}},
                             .starts = {{-5, side}, {-5, side + 2}, {-5, side - 2}}}}};
    def.parameters.field.enabled = false;
    return def;
}

RunFigures figuresAfter(World& world, double seconds) {
    RunMetrics metrics(world);
    const auto steps = static_cast<int>(seconds * 60.0 + 0.5);
    for (int i = 0; i < steps; ++i) {
        world.step();
        metrics.observe(world);
    }
    return metrics.figures(world);
}

}  // namespace

TEST_CASE("an open walk: arrival, path ratio and counts are those of arithmetic") {
    auto world = World::create(walkDef());
    REQUIRE(world.ok());
    const RunFigures f = figuresAfter(*world, 10.0);
    CHECK(f.characters == 3);
    CHECK(f.steps == 600);
    CHECK(f.hash == world->hash());
    // 9.5 m at 2 m/s, and some time to get up to speed.
    CHECK(f.arrived100 > 4.75);
    CHECK(f.arrived100 < 5.4);
    CHECK(f.arrived95 <= f.arrived100);
    CHECK(f.stuck == 0);
    CHECK(f.unmatched == 0);
    CHECK(f.overlapPairsMax == 0);
    CHECK(f.swapsPerCharacterPerSecond == 0.0);
    CHECK(f.pathRatio == doctest::Approx(1.0).epsilon(0.02));
    CHECK(f.lagP95 < 0.1);
    CHECK(f.walked.sum == doctest::Approx(3 * 10.0).epsilon(0.01));
    CHECK(f.walked.longest == doctest::Approx(10.0).epsilon(0.01));
    CHECK(f.walked.squares == doctest::Approx(3 * 10.0 * 10.0).epsilon(0.02));
    CHECK(f.planned.longest < 0.1);  // All stand on their places.
    CHECK(f.stepP50 <= f.stepP95);
    CHECK(f.stepP95 <= f.stepMax);
    double stages = 0.0;
    for (double s : f.stageMean) stages += s;
    CHECK(stages > 0.0);
    CHECK(stages < 2.0 * f.stepMax);
}

TEST_CASE("arrived needs a second of standing, and the moment it got there counts") {
    auto world = World::create(walkDef());
    REQUIRE(world.ok());
    RunMetrics metrics(*world);
    double reached = -1.0, noticed = -1.0;
    for (int i = 0; i < 600; ++i) {
        world->step();
        metrics.observe(*world);
        double farthest = 0.0;
        for (std::size_t k = 0; k < 3; ++k)
            farthest = std::max(farthest, std::fabs(5.0 - world->characters().position[k].x));
        if (reached < 0.0 && farthest <= 0.5) reached = world->time();
        const double at = metrics.figures(*world, false).arrived100;
        if (noticed < 0.0 && at >= 0.0) {
            noticed = world->time();
            CHECK(at == doctest::Approx(reached).epsilon(0.005));
        }
    }
    CHECK(noticed - reached == doctest::Approx(1.0).epsilon(0.03));
}

TEST_CASE("the clock starts at the last command") {
    auto world = World::create(walkDef());
    REQUIRE(world.ok());
    REQUIRE(world->submit({120, 1, 0, SetParameter{"plan.exponent", 2.0}}).ok());
    const RunFigures f = figuresAfter(*world, 10.0);
    CHECK(f.arrived100 > 2.75);
    CHECK(f.arrived100 < 3.4);
    CHECK(f.pathRatio == -1.0);
}

TEST_CASE("who cannot move is stuck, after five seconds and not before") {
    WorldDef def = walkDef();
    for (double y : {-2.0, 0.0, 2.0}) {  // Every start in a closed box of its own.
        for (int side = 0; side < 4; ++side) {
            const double a = side * 1.5707963267948966;
            const Vec2 d{std::round(std::cos(a)), std::round(std::sin(a))};
            const Vec2 c = Vec2{-5, y} + d * 0.6, half = {d.x != 0.0 ? 0.1 : 0.7, d.y != 0.0 ? 0.1 : 0.7};
            def.obstacles.push_back({.polygon = {c + Vec2{-half.x, -half.y}, c + Vec2{half.x, -half.y},
                                                 c + half, c + Vec2{-half.x, half.y}}});
        }
    }
    def.cell = 0.125;
    auto world = World::create(def);
    REQUIRE(world.ok());
    CHECK(figuresAfter(*world, 3.0).stuck == 0);
    auto again = World::create(def);
    const RunFigures f = figuresAfter(*again, 14.0);
    // All places lie in the box of one of them, who stands in one; the other two cannot come.
    CHECK(f.stuck == 2);
    CHECK(f.arrived95 == -1.0);
    CHECK(f.pathRatio == -1.0);
}

TEST_CASE("characters that join and leave are followed by id") {
    auto world = World::create(WorldDef{.groups = {GroupDef{}}});
    REQUIRE(world.ok());
    REQUIRE(world->submit({30, 1, 0, ChangeGroup{.group = GroupId{1}, .count = 40}}).ok());
    REQUIRE(world->submit({60, 1, 1, ChangeGroup{.group = GroupId{1}, .count = 20}}).ok());
    const RunFigures f = figuresAfter(*world, 8.0);
    CHECK(f.characters == 20);
    CHECK(f.arrived100 >= 0.0);
    CHECK(f.stuck == 0);
}

TEST_CASE("the least walk: in the open, round a wall, and none") {
    auto open = Environment::create({});
    REQUIRE(open.ok());
    const std::vector<Vec2> starts{{0, 0}, {1, 0}}, places{{4, 0}, {3, 0}};
    CHECK(leastWalk(*open, 0.25, starts, places) == doctest::Approx(6.0));
    // A wall from y = -16 to 3: the path from (-4, 0) to (4, 0) rounds its end with a radius to spare.
    REQUIRE(open->addObstacle({.polygon = {{-0.5, -17}, {0.5, -17}, {0.5, 3}, {-0.5, 3}}}).ok());
    open->setTime(0.0);
    const std::vector<Vec2> from{{-4, 0}}, to{{4, 0}};
    // A tangent to the disc of 0.25 m round each corner, an arc from its heading to the flat top, and the
    // top.
    const double reach = std::hypot(3.5, 3.0), tangent = std::sqrt(reach * reach - 0.0625);
    const double heading = std::atan2(3.0, 3.5) + std::asin(0.25 / reach);
    const double exact = 2.0 * (tangent + 0.25 * heading) + 1.0;
    CHECK(leastWalk(*open, 0.25, from, to) == doctest::Approx(exact).epsilon(0.01));
    CHECK(leastWalk(*open, 0.25, starts, from) == -1.0);
}
