// What a world refuses, however it is given: whole definitions, commands, parameters that contradict each
// other.
#include <doctest.h>

#include <cmath>

#include "engine/fields/cost/density.h"
#include "engine/ground/environment/environment.h"
#include "engine/state/validation.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"
#include "muster/parameter_table.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// The sentence of the only rejection of the next step; empty where there is none.
std::string refusalOf(World& world, CommandBody body) {
    const Status status = give(world, std::move(body));
    if (!status.ok()) return status.message();
    world.step();
    return world.rejections().empty() ? std::string() : world.rejections()[0].status.message();
}

bool holds(const std::string& text, const char* part) {
    return text.find(part) != std::string::npos;
}

}  // namespace

TEST_CASE("a world holds as many groups as their numbers can tell apart") {
    WorldDef def = openFloor(1);
    def.groups.assign(kMaxGroups + 1, def.groups.front());
    const auto many = World::create(def);
    REQUIRE_FALSE(many.ok());
    CHECK(holds(many.status().message(), "groups: found 20001, at most 20000"));
}

TEST_CASE("a world is checked whole before it is made") {
    WorldDef def = openFloor(4);
    def.parameters.plan.period = -1;
    const auto still = World::create(def);
    REQUIRE_FALSE(still.ok());
    CHECK(holds(still.status().message(), "plan.period"));
    def = openFloor(4);
    def.parameters.cost.alpha = def.parameters.cost.beta = 0.0;
    const auto free = World::create(def);
    REQUIRE_FALSE(free.ok());
    CHECK(holds(free.status().message(), "cost.alpha and cost.beta"));
    def = openFloor(4);
    def.parameters.density.cell = 0.1;
    def.box = {{-4000, -4000}, {4000, 4000}};
    def.cell = 50.0;
    const auto fine = World::create(def);
    REQUIRE_FALSE(fine.ok());
    CHECK(holds(fine.status().message(), "density.cell"));
}

TEST_CASE("parameters that contradict each other are refused while the world runs, and nothing changes") {
    World world = World::create(openFloor(4)).value();
    CHECK(refusalOf(world, SetParameter{"cost.alpha", 0.0}).empty());
    CHECK(holds(refusalOf(world, SetParameter{"cost.beta", 0.0}), "cost.beta"));
    CHECK(world.parameters().cost.beta == 0.5);
    CHECK(holds(refusalOf(world, SetParameter{"density.min", 50.0}), "density.max"));
    CHECK(world.parameters().density.min == Parameters{}.density.min);
    // What a metre may cost has a bound that snapshots keep to.
    CHECK(refusalOf(world, SetParameter{"discomfort.gain", 1000.0}).empty());
    CHECK(refusalOf(world, SetParameter{"cost.minSpeed", 0.002}).empty());
    CHECK(holds(refusalOf(world, SetParameter{"cost.gamma", 1000.0}), "cost.gamma"));
    CHECK(World::restore(world.snapshot()).ok());
}

TEST_CASE("the density grid follows its parameters, and a restored world goes on bit for bit") {
    WorldDef def = openFloor(36);
    def.groups[0].formation.spacing = 0.55;
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, {3, 0}, 0}).ok());
    for (int s = 0; s < 5; ++s) world.step();
    REQUIRE(give(world, SetParameter{"density.cell", 0.5}).ok());
    REQUIRE(give(world, SetParameter{"density.lambda", 2.0}).ok());
    for (int s = 0; s < 6; ++s) world.step();
    CHECK(inspect::density(world).grid().cell == 0.5);
    CHECK(inspect::density(World::restore(world.snapshot()).value()).grid().cell == 0.5);
    checkGoesOn(world, 90);
}

TEST_CASE("one limit on characters, for scenarios, groups that join, and counts") {
    for (const bool exact : {true, false}) {
        const std::int32_t most = exact ? kMaxExact : kMaxCharacters;
        const std::string expected = "at most " + std::to_string(most);
        WorldDef def = openFloor(4);
        def.parameters.plan.solver = exact ? PlanSolver::Exact : PlanSolver::Fast;
        WorldDef full = def;
        full.groups.push_back(def.groups[0]);
        full.groups[1].count = most - 3;
        const auto many = World::create(full);
        REQUIRE_FALSE(many.ok());
        CHECK(holds(many.status().message(), expected.c_str()));
        World world = World::create(def).value();
        GroupDef group{.count = most - 3};
        CHECK(holds(refusalOf(world, AddGroup{group}), expected.c_str()));
        group.count = 5;
        CHECK(refusalOf(world, AddGroup{group}).empty());
        CHECK(holds(refusalOf(world, ChangeGroup{.group = world.group(1).id, .count = most - 3}),
                    expected.c_str()));
        CHECK(holds(refusalOf(world, ChangeGroup{.group = world.group(1).id, .count = kMaxCharacters + 1}),
                    "200000"));
        CHECK(world.characters().size() == 9);
    }
}

TEST_CASE("a crowd too large for exact plans stays with fast ones, and says so") {
    WorldDef def = openFloor(kMaxExact + 1);
    def.box = {{-60, -60}, {60, 60}};
    def.groups[0].position = {};
    def.parameters.plan.solver = PlanSolver::Exact;
    CHECK(holds(World::create(def).status().message(), "exact plans (plan.solver 0) serve at most 5000"));
    def.parameters.plan.solver = PlanSolver::Fast;
    Result<World> world = World::create(def);
    REQUIRE(world.ok());
    CHECK(holds(refusalOf(*world, SetParameter{"plan.solver", 0.0}), "serve at most 5000"));
    CHECK(world->parameters().plan.solver == PlanSolver::Fast);
    CHECK(world->characters().size() == static_cast<std::size_t>(kMaxExact) + 1);
}

TEST_CASE("the widest characters that may be still find free space in the open") {
    double widest = 0.0;
    double clearest = 0.0;
    for (const ParameterInfo& info : parameterTable()) {
        if (info.name == "character.radius") widest = info.maximum;
        if (info.name == "place.clearance") clearest = info.maximum;
    }
    CHECK(widest + clearest <= Environment::kClearanceLimit);
    WorldDef def{.box = {{-60, -60}, {60, 60}}, .cell = 1.0, .parameters = {.character = {.radius = widest}}};
    def.parameters.place.clearance = clearest;
    def.groups.emplace_back().count = 4;
    def.groups[0].formation.spacing = 10.0;
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, {20, 0}, 0}).ok());
    for (int s = 0; s < 1500; ++s) world.step();
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) {
        REQUIRE(c.place[i] >= 0);
        CHECK(distance(c.position[i], world.group(0).placePositions[c.place[i]]) < 0.3);
        CHECK(c.position[i].x > 10.0);
    }
}

TEST_CASE("a checkpoint keeps to its group when another goes") {
    WorldDef def = openFloor(4);
    def.box = {{-20, -12}, {20, 12}};
    for (int k = 0; k < 3; ++k) {
        if (k > 0) def.groups.push_back(def.groups[0]);
        def.groups.back().position = {-10.0 + 8.0 * k, 0};
    }
    def.checkpoints = {{.position = {10, 8},
                        .formation = {.kind = FormationKind::Ring},
                        .group = 2,
                        .trigger = CheckpointTrigger::Mesh}};
    World world = World::create(def).value();
    const GroupId second = world.group(1).id;
    const GroupId third = world.group(2).id;
    REQUIRE(give(world, RemoveGroup{world.group(0).id}).ok());
    world.step();
    world = World::restore(world.snapshot()).value();
    const auto changesOf = [&](GroupId id) {
        REQUIRE(give(world, SetPose{id, {10, 8}, 0}).ok());
        int changes = 0;
        for (int s = 0; s < 3; ++s) {
            world.step();
            for (const Event& event : world.events())
                changes += event.kind == EventKind::FormationChange ? 1 : 0;
        }
        return changes;
    };
    CHECK(changesOf(second) == 0);
    CHECK(changesOf(third) == 1);
}
