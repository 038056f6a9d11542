#include "lab/reproduce/experiments/change_watch.h"

#include <doctest.h>
#include <cmath>

using namespace muster;

namespace {

/// One character at the origin whose place moves four metres away after a second.
WorldDef oneWhoGoes() {
    return {.groups = {{.count = 1, .formation = {.kind = FormationKind::Points, .points = {{0.0, 0.0}}}}}};
}

Command changeAt(std::uint32_t step, Vec2 place) {
    const ChangeGroup change{.group = {1},
                             .formation = FormationDef{.kind = FormationKind::Points, .points = {place}}};
    return {step, 1, step, change};
}

ChangeWatch watch(const WorldDef& def, const std::vector<Command>& commands, int steps) {
    World world = std::move(World::create(def)).value();
    for (const Command& command : commands) REQUIRE(world.submit(command).ok());
    ChangeWatch watch(world);
    for (int k = 0; k < steps; ++k) {
        world.step();
        watch.observe(world);
    }
    return watch;
}

}  // namespace

TEST_CASE("a change is timed from the step that makes it until the character is within reach") {
    const auto changes = watch(oneWhoGoes(), {changeAt(60, {4.0, 0.0})}, 360).changes();
    REQUIRE(changes.size() == 1);
    CHECK(changes[0].kind == FormationKind::Points);
    CHECK(changes[0].time == doctest::Approx(1.0));
    CHECK(changes[0].bottleneck == doctest::Approx(4.0).epsilon(0.01));
    // 3.5 m at 2 m/s, and the time lost while it gathers speed.
    CHECK(changes[0].arrived95 > 3.5 / 2.0);
    CHECK(changes[0].arrived95 < 3.5 / 2.0 + 0.4);
    CHECK(changes[0].arrived100 == changes[0].arrived95);
    CHECK(changes[0].stood95 > 3.9 / 2.0);
    CHECK(changes[0].stood95 < changes[0].arrived95 + 0.8);
    CHECK(changes[0].ratio(2.0) == doctest::Approx(changes[0].arrived95 / 2.0).epsilon(0.01));
    CHECK(changes[0].stuck == 0);
}

TEST_CASE("each change is judged when the next one comes") {
    const auto changes = watch(oneWhoGoes(), {changeAt(60, {4.0, 0.0}), changeAt(90, {0.0, 0.0})}, 360)
                             .changes();
    REQUIRE(changes.size() == 2);
    CHECK(std::isnan(changes[0].arrived95));
    CHECK(changes[1].time == doctest::Approx(1.5));
    CHECK(changes[1].bottleneck < 1.1);
    CHECK(changes[1].arrived95 < 1.2);
}

TEST_CASE("one who hardly moves and is not there is stuck after five seconds") {
    WorldDef def = oneWhoGoes();
    def.parameters.character.maxSpeed = 0.01;
    CHECK(watch(def, {changeAt(60, {4.0, 0.0})}, 60 + 240).changes()[0].stuck == 0);
    const auto changes = watch(def, {changeAt(60, {4.0, 0.0})}, 60 + 330).changes();
    CHECK(changes[0].stuck == 1);
    CHECK(std::isnan(changes[0].arrived95));
}
