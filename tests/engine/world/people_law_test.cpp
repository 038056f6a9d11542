// The law of headway as people walk by it, against its closed form and against measurements.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "base/random.h"
#include "engine/passages/specific_flow.h"
#include "muster/parameter_table.h"
#include "muster/world.h"

using namespace muster;

namespace {

Parameters people() {
    return *parameterPreset("people");
}

// A ring on which a group walks to the right.
WorldDef ringOf(double length, double width, const Parameters& parameters) {
    WorldDef def{.box = {{0, 0}, {length, width}}, .ring = true, .parameters = parameters};
    def.groups = {{.formation = {.spacing = 0.5}, .orders = {Order::walk(0.0)}}};
    return def;
}

double meanSpeed(const World& world) {
    double sum = 0.0;
    for (const Vec2 v : world.characters().velocity) sum += v.x;
    return sum / static_cast<double>(world.characters().size());
}

double weidmann(double density) {
    return 1.34 * (1.0 - exponential(-1.913 * (1.0 / density - 1.0 / 5.4)));
}

}  // namespace

TEST_CASE("a file in a ring walks at its gap over its headway, out of step") {
    for (const double inStep : {0.0, 0.5}) {
        Parameters parameters = people();
        parameters.character.inStep = inStep;
        WorldDef def = ringOf(24.0, 0.6, parameters);
        def.cell = 0.1;
        def.groups[0].count = 32;
        for (int i = 0; i < 32; ++i) def.groups[0].starts.push_back({0.75 * i, 0.3});
        World world = *World::create(def);
        for (int k = 0; k < 1800; ++k) world.step();
        const double gap = 0.75 - 2.0 * parameters.character.radius;
        const double expected = gap / (parameters.character.headway * (1.0 - inStep));
        CHECK(meanSpeed(world) == doctest::Approx(expected).epsilon(0.01));
    }
}

TEST_CASE("who walks out of a ring on one side comes in on the other, and keeps from who is there") {
    WorldDef def = ringOf(12.0, 2.0, people());
    def.groups[0].count = 2;
    def.groups[0].starts = {{11.0, 1.0}, {0.4, 1.0}};
    def.groups[0].bodies = {Body{}, Body{.maxSpeed = 0.3}};
    World world = *World::create(def);
    double nearest = 12.0, walked = 0.0;
    for (int k = 0; k < 3600; ++k) {
        const Vec2 before = world.characters().position[0];
        world.step();
        const CharactersView c = world.characters();
        for (const Vec2 p : c.position) CHECK((p.x >= 0.0 && p.x < 12.0));
        walked += std::fmod(c.position[0].x - before.x + 18.0, 12.0) - 6.0;
        Vec2 between = c.position[1] - c.position[0];
        between.x -= 12.0 * std::floor(between.x / 12.0 + 0.5);
        nearest = std::min(nearest, length(between));
    }
    CHECK(nearest > 0.43);
    CHECK(walked > 40.0);  // It passes by the slow one.
}

TEST_CASE("the speed of people falls with their density as Weidmann's curve does, within 15 %") {
    constexpr double kLength = 20.0, kWidth = 4.0;
    for (const double density : {0.5, 1.0, 2.0, 3.0, 4.0}) {
        WorldDef def = ringOf(kLength, kWidth, people());
        GroupDef& group = def.groups[0];
        group.count = static_cast<std::int32_t>(density * kLength * kWidth);
        group.people = {adults()};
        // An open lattice, shaken.
        Random random(1);
        const int rows = static_cast<int>(std::floor(kWidth / std::sqrt(0.866 / density)));
        const int files = (group.count + rows - 1) / rows;
        for (int i = 0; i < group.count; ++i) {
            const double x = (i / rows + (i % rows % 2) * 0.5) * kLength / files;
            const double y = (i % rows + 0.5) * kWidth / rows;
            group.starts.push_back({x + random.uniform(0.0, 0.05), y + random.uniform(-0.05, 0.05)});
        }
        World world = *World::create(def);
        double sum = 0.0;
        for (int k = 0; k < 1800; ++k) {
            world.step();
            if (k >= 600) sum += meanSpeed(world) / 1200.0;
            CHECK(world.contacts().overlapPairs == 0);
        }
        CHECK(sum == doctest::Approx(weidmann(density)).epsilon(0.15));
    }
}

TEST_CASE("presets differ in the law, and all but the former name of units are their own") {
    CHECK(people().character.inStep == 0.0);
    CHECK(parameterPreset("units")->character.inStep == 1.0);
    CHECK(parameterPreset("muster")->character.headway == parameterPreset("units")->character.headway);
    Parameters parameters = people();
    REQUIRE(usePreset(parameters, "paper").ok());
    CHECK(parameters.character.headway == Parameters{}.character.headway);
    CHECK(parameters.plan.solver == PlanSolver::Exact);
}

TEST_CASE("the flow of passages follows from the law of headway") {
    const Parameters::Character units = parameterPreset("units")->character;
    const Parameters::Character people = parameterPreset("people")->character;
    CHECK(specificFlow(units) == doctest::Approx(4.5).epsilon(1e-4));
    CHECK(specificFlow(people) == doctest::Approx(1.325).epsilon(0.01));
    Parameters::Character slow = people;
    slow.headway = 2.0 * people.headway;
    CHECK(specificFlow(slow) < specificFlow(people));
}
