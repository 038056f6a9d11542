// A ChangeGroup: what is not given stays, several fields at once, and none where one is bad.
#include <doctest.h>

#include "engine/world/world_scenes.h"
#include "muster/world.h"

using namespace muster;
using namespace muster::testing;

namespace {

World twenty() {
    WorldDef def{.box = {{-30, -30}, {30, 30}}};
    def.groups.emplace_back().count = 20;
    World world = World::create(def).value();
    run(world, 0.2);
    return world;
}

/// What the world answers to the command in the next step.
Status applied(World& world, CommandBody body) {
    if (const Status given = give(world, std::move(body)); !given.ok()) return given;
    world.step();
    return world.rejections().empty() ? Status() : world.rejections().front().status;
}

Status change(World& world, const ChangeGroup& change) {
    return applied(world, change);
}

}  // namespace

TEST_CASE("fields that are given change, all others stay") {
    World world = twenty();
    const GroupId id = world.group(0).id;
    REQUIRE(change(world, {.group = id,
                           .formation = FormationDef{.kind = FormationKind::Ring},
                           .count = 24,
                           .conduct = Conduct{.stance = Stance::Hold},
                           .name = "Ring"})
                .ok());
    const GroupDef ring = world.groupDef(0);
    CHECK(ring.formation.kind == FormationKind::Ring);
    CHECK(world.group(0).members.size() == 24);
    CHECK(ring.conduct.stance == Stance::Hold);
    CHECK(ring.name == "Ring");
    REQUIRE(change(world, {.group = id, .colour = GroupColour{0x102030}}).ok());
    REQUIRE(change(world, {.group = id, .look = GroupLook{BodyBuild::Narrow, {}}}).ok());
    const GroupDef after = world.groupDef(0);
    CHECK(after.colour == 0x102030u);
    CHECK(after.build == BodyBuild::Narrow);
    CHECK(after.formation == ring.formation);
    CHECK(after.name == "Ring");
    REQUIRE(change(world, {.group = id, .colour = GroupColour{}}).ok());
    CHECK_FALSE(world.groupDef(0).colour);
    CHECK(world.groupDef(0).build == BodyBuild::Narrow);
}

TEST_CASE("demands are counted by the places that there are after the change") {
    World world = twenty();
    const GroupId id = world.group(0).id;
    CHECK_FALSE(change(world, {.group = id, .count = 22, .demands = std::vector<double>(20, 1.0)}).ok());
    CHECK(world.group(0).members.size() == 20);
    REQUIRE(change(world, {.group = id, .count = 22, .demands = std::vector<double>(22, 0.5)}).ok());
    CHECK(world.groupDef(0).demands.size() == 22);
}

TEST_CASE("a change with one bad field changes nothing") {
    World world = twenty();
    const GroupId id = world.group(0).id;
    const std::uint64_t hash = world.hash();
    const ChangeGroup bad[] = {
        {.group = id},
        {.group = id, .count = 0, .name = "Other"},
        {.group = id,
         .formation = FormationDef{.kind = FormationKind::Points, .points = {{0, 0}}},
         .name = "Other"},
        {.group = id, .conduct = Conduct{.cohesion = 2.0}, .name = "Other"},
        {.group = id, .demands = std::vector<double>(3, 1.0), .name = "Other"},
        {.group = GroupId{99}, .name = "Other"},
    };
    for (const ChangeGroup& one : bad) {
        World copy = World::restore(world.snapshot()).value();
        CHECK_FALSE(change(copy, one).ok());
        CHECK(copy.groupDef(0).name == "Group");
        CHECK(copy.group(0).members.size() == 20);
    }
    CHECK(world.hash() == hash);
}

TEST_CASE("commands by former names lead to the same state") {
    const GroupId id{1};
    const FormationDef wedge{.kind = FormationKind::Wedge};
    const Body body{.radius = 0.3};
    const std::pair<CommandBody, CommandBody> pairs[] = {
        {SetFormation{id, wedge}, ChangeGroup{.group = id, .formation = wedge}},
        {SetCount{id, 25}, ChangeGroup{.group = id, .count = 25}},
        {SetAppearance{id, BodyBuild::Narrow, {}},
         ChangeGroup{.group = id, .look = GroupLook{BodyBuild::Narrow, {}}}},
        {RemoveCharacters{{3, 4}}, TransferCharacters{{3, 4}, {}}},
        {SetBodies{{3}, {body}}, ChangeCharacters{{3}, std::vector{body}, {}}},
        {SetDriver{{3}, Driver::Outside}, ChangeCharacters{{3}, {}, Driver::Outside}},
        {PlaceGroup{id, {4, 5}, 0.5}, SetPose{id, {4, 5}, 0.5, true}},
    };
    for (const auto& [former, now] : pairs) {
        World first = twenty(), second = twenty();
        REQUIRE(applied(first, former).ok());
        REQUIRE(applied(second, now).ok());
        CHECK(first.hash() == second.hash());
    }
}
