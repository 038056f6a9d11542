#include "muster/views.h"

#include <doctest.h>

#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <string_view>

#include "engine/world/world_scenes.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A disc and a block of which the latter moves 1 m/s along x, and a patch that stands still.
WorldDef groundScene() {
    WorldDef def = openFloor(9);
    def.obstacles.push_back(tree({5, 5}, 1.0));
    def.obstacles.push_back(block(0, -9, 2, -8));
    def.obstacles.back().path.waypoints = {{0.0, {0, 0}, 0.0}, {10.0, {10, 0}, 0.0}};
    def.patches.push_back(rectangle(-2, 6, 2, 8, 2));
    return def;
}

}  // namespace

TEST_CASE("the view of characters has one entry per character in every span") {
    World world = World::create(openFloor(16)).value();
    world.step();
    const CharactersView view = world.characters();
    CHECK(view.size() == 16);
    for (const std::size_t size :
         {view.group.size(), view.position.size(), view.velocity.size(), view.heading.size(),
          view.place.size(), view.direction.size(), view.cost.size(), view.motion.size(), view.phase.size(),
          view.motionTime.size(), view.patch.size()})
        CHECK(size == 16);
}

TEST_CASE("the view of a group: definition, members, mesh and places") {
    WorldDef def = openFloor(16);
    def.groups[0].name = "Guards";
    def.groups.push_back(def.groups[0]);
    def.groups[1].position = {6, 0};
    def.groups[1].count = 9;
    World world = World::create(def).value();
    world.step();
    const GroupView group = world.group(1);
    CHECK(group.name == "Guards");
    CHECK(group.count == 9);
    CHECK(group.formation == FormationKind::Square);
    CHECK(world.groupDef(1).formation.spacing == def.groups[1].formation.spacing);
    REQUIRE(group.members.size() == 9);
    CHECK(group.members.front() == 16);
    CHECK(group.placePositions.size() == 9);
    CHECK(group.placeTargets.size() == 9);
    CHECK(group.meshPlaces.size() == 9);
    CHECK(group.finalMesh.size() == group.restMesh.size());
    for (const Triangle& triangle : group.triangles)
        for (const std::int32_t vertex : triangle) CHECK(std::cmp_less(vertex, group.restMesh.size()));
    CHECK(distance(group.pose.position, {6, 0}) < 1e-9);
}

TEST_CASE("the view of an obstacle: where it stands now") {
    World world = World::create(groundScene()).value();
    for (int s = 0; s < 61; ++s) world.step();
    REQUIRE(world.obstacleIds().size() == 2);
    const ObstacleView disc = world.obstacle(world.obstacleIds()[0]);
    CHECK(disc.outline.empty());
    CHECK(disc.centre == Vec2{5, 5});
    const ObstacleView moving = world.obstacle(world.obstacleIds()[1]);
    CHECK(moving.def.polygon[0] == Vec2{0, -9});
    CHECK(distance(moving.outline[0], {1, -9}) < 1e-9);
    CHECK(distance(moving.centre, {2, -8.5}) < 1e-9);
    CHECK_FALSE(world.obstacle(ObstacleId{99}).id);
}

TEST_CASE("the view of a patch, and of a patch that is not there") {
    const World world = World::create(groundScene()).value();
    REQUIRE(world.patchIds().size() == 1);
    const PatchView patch = world.patch(world.patchIds()[0]);
    CHECK(patch.def.motion == 2);
    CHECK(patch.outline.size() == 4);
    CHECK_FALSE(world.patch(PatchId{99}).id);
}

TEST_CASE("stages have names of their own, and say what they read, write and do") {
    std::set<std::string> names;
    for (const StageInfo& stage : stepStages()) {
        CAPTURE(std::string(stage.name));
        CHECK(names.insert(std::string(stage.name)).second);
        CHECK_FALSE(stage.reads.empty());
        CHECK_FALSE(stage.writes.empty());
        CHECK(stage.about.back() == '.');
    }
}

TEST_CASE("the page on the architecture shows the table of stages") {
    std::string table = "| stage | reads | writes | what it does |\n| --- | --- | --- | --- |\n";
    for (const StageInfo& stage : stepStages()) {
        for (const std::string_view cell : {stage.name, stage.reads, stage.writes, stage.about})
            table += "| " + std::string(cell) + " ";
        table += "|\n";
    }

    std::ifstream file(sourceFolder() + "/docs/architecture.md");
    std::stringstream page;
    page << file.rdbuf();
    INFO("The table as it should be:\n" << table);
    CHECK(page.str().find(table) != std::string::npos);
}

TEST_CASE("stages that have an index of their own have the name of their row") {
    const std::pair<Stage, std::string_view> names[] = {
        {Stage::Commands, "commands"},      {Stage::Orders, "orders"},        {Stage::Controls, "controls"},
        {Stage::UserMesh, "user mesh"},     {Stage::FinalMesh, "final mesh"}, {Stage::Places, "places"},
        {Stage::DensityAndCost, "density"}, {Stage::Plan, "plans"},           {Stage::Steering, "steering"},
        {Stage::Contacts, "contacts"},      {Stage::Patches, "patches"},      {Stage::Events, "arrivals"}};
    for (const auto& [stage, name] : names) {
        CHECK(stageName(stage) == name);
        CHECK(stepStages()[static_cast<std::size_t>(stage)].name == name);
    }
    CHECK(std::string_view(stageName(Stage::Count)).empty());
}
