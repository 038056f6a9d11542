// Items, checkpoints, and where groups stand are changed while the world runs.
#include <doctest.h>

#include <algorithm>
#include <string>

#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

struct Floor {
    explicit Floor(const WorldDef& def = openFloor()) : world(std::move(World::create(def)).value()) {}

    /// The refusal of a command in the next step; empty where it was carried out.
    std::string carryOut(CommandBody body) {
        REQUIRE(give(world, std::move(body)).ok());
        world.step();
        return world.rejections().empty() ? "" : world.rejections()[0].status.message();
    }
    void run(int steps) {
        for (int s = 0; s < steps; ++s) world.step();
    }
    Vec2 middle() const {
        Vec2 sum;
        for (const Vec2 p : world.characters().position) sum += p;
        return sum / static_cast<double>(world.characters().size());
    }

    World world;
};

FormationCheckpointDef ringAt(Vec2 position) {
    return {.position = position, .radius = 3.0, .formation = {.kind = FormationKind::Ring}};
}

bool took(const World& world, EventKind kind) {
    return std::any_of(world.events().begin(), world.events().end(),
                       [&](const Event& event) { return event.kind == kind; });
}

}  // namespace

TEST_CASE("an item that is added under somebody is collected, and stays so when it moves") {
    Floor floor;
    CHECK(floor.carryOut(putThing(ItemDef{{-6, 0}, 1.0})).empty());
    REQUIRE(floor.world.itemIds().size() == 1);
    const ItemId id = floor.world.itemIds()[0];
    CHECK(floor.world.collected()[0] == 1);
    CHECK(floor.carryOut(putThing(ItemDef{{9, 9}, 0.5}, id)).empty());
    CHECK(floor.world.collected()[0] == 1);
    CHECK(floor.carryOut(putThing(ItemDef{{9, -9}, 0.5})).empty());
    CHECK(floor.carryOut(removeThing(id)).empty());
    REQUIRE(floor.world.items().size() == 1);
    CHECK(floor.world.itemIds()[0].value == 2);
    CHECK(floor.world.collected()[0] == 0);
    CHECK(floor.carryOut(removeThing(id)) == "no item has the id 1");
    CHECK(floor.carryOut(putThing(ItemDef{}, id)) == "no item has the id 1");
}

TEST_CASE("a checkpoint that is added changes the group that stands in it, once") {
    Floor floor;
    CHECK(floor.carryOut(putThing(ringAt({-6, 0}), {}, GroupId{1})).empty());
    CHECK(took(floor.world, EventKind::FormationChange));
    CHECK(floor.world.group(0).formation == FormationKind::Ring);
    FormationCheckpointDef wedge = ringAt({-6, 0});
    wedge.formation.kind = FormationKind::Wedge;
    // Who has passed it stays.
    CHECK(floor.carryOut(putThing(wedge, CheckpointId{1}, GroupId{1})).empty());
    floor.run(2);
    CHECK(floor.world.group(0).formation == FormationKind::Ring);
    CHECK(floor.carryOut(putThing(wedge)).empty());
    CHECK(floor.world.group(0).formation == FormationKind::Wedge);
    CHECK(floor.carryOut(putThing(wedge, {}, GroupId{7})) == "no group has the id 7");
    CHECK(floor.carryOut(putThing(wedge, CheckpointId{9})) == "no checkpoint has the id 9");
    CHECK(floor.carryOut(removeThing(CheckpointId{9})) == "no checkpoint has the id 9");
}

TEST_CASE("what groups have passed stays with its checkpoint when another one goes") {
    WorldDef def = openFloor();
    GroupDef second = def.groups[0];
    second.position = {6, 6};
    def.groups.push_back(second);
    def.checkpoints = {ringAt({9, -9}), ringAt({-6, 0}), ringAt({6, 6})};
    Floor floor(def);
    floor.run(2);
    REQUIRE(floor.world.group(0).formation == FormationKind::Ring);
    REQUIRE(floor.world.group(1).formation == FormationKind::Ring);
    CHECK(floor.carryOut(removeThing(CheckpointId{1})).empty());
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{1}, .formation = FormationDef{}}).empty());
    floor.run(3);
    CHECK(floor.world.group(0).formation != FormationKind::Ring);
    // The first group has not been in the third checkpoint yet.
    CHECK(floor.carryOut(SetPose{GroupId{1}, {6, 6}, 0.0, true}).empty());
    floor.run(2);
    CHECK(floor.world.group(0).formation == FormationKind::Ring);
}

TEST_CASE("a group is placed at once, stands there, and goes on from there") {
    Floor floor;
    const std::vector<std::uint32_t> ids = copyOf(floor.world.characters().id);
    CHECK(floor.carryOut(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({9, 9}, 0.0)}).empty());
    floor.run(60);
    CHECK(floor.carryOut(SetPose{GroupId{1}, {5, -4}, 1.0, true}).empty());
    CHECK(distance(floor.middle(), {5, -4}) < 0.3);
    CHECK(copyOf(floor.world.characters().id) == ids);
    CHECK(floor.world.group(0).orders.empty());
    floor.run(120);
    CHECK(distance(floor.middle(), {5, -4}) < 0.3);
    CHECK(floor.world.group(0).meanLag < 0.05);
    CHECK(floor.carryOut(GiveOrder{GroupId{1}, QueueMode::Replace, 0, Order::move({-5, 4}, 0.0)}).empty());
    floor.run(900);
    CHECK(distance(floor.middle(), {-5, 4}) < 0.5);
}

TEST_CASE("a group that is placed in a wall stands beside it") {
    WorldDef def = openFloor();
    def.obstacles.push_back(block(2, -2, 6, 2));
    Floor floor(def);
    CHECK(floor.carryOut(SetPose{GroupId{1}, {4, 0}, 0.0, true}).empty());
    floor.run(30);
    for (const Vec2 p : floor.world.characters().position)
        CHECK((p.x < 2.0 || p.x > 6.0 || p.y < -2.0 || p.y > 2.0));
    CHECK(floor.world.contacts().worstPenetration < 0.1);
}

TEST_CASE("names are kept, and too long ones refused") {
    Floor floor;
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{1}, .name = "Guests"}).empty());
    CHECK(floor.world.group(0).name == "Guests");
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{3}, .name = "Guests"}) == "no group has the id 3");
    CHECK_FALSE(give(floor.world, ChangeGroup{.group = GroupId{1}, .name = std::string(5000, 'x')}).ok());
}

TEST_CASE("a colour is taken and given back, and bad ones are refused") {
    Floor floor;
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{1}, .colour = GroupColour{0xD60EA8}}).empty());
    CHECK(floor.world.group(0).colour == 0xD60EA8u);
    CHECK(floor.world.groupDef(0).colour == 0xD60EA8u);
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{1}, .colour = GroupColour{std::nullopt}}).empty());
    CHECK_FALSE(floor.world.group(0).colour);
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{3}, .colour = GroupColour{0}}) ==
          "no group has the id 3");
    CHECK_FALSE(give(floor.world, ChangeGroup{.group = GroupId{1}, .colour = GroupColour{0x1000000}}).ok());
    WorldDef def = openFloor();
    def.groups[0].colour = 0x1000000;
    CHECK_FALSE(World::create(def).ok());
}

TEST_CASE("an appearance is taken and given back, moves nobody, and unknown ones are refused") {
    Floor plain, marching;
    CHECK(marching
              .carryOut(
                  ChangeGroup{.group = GroupId{1}, .look = GroupLook{BodyBuild::Narrow, MotionSet::March}})
              .empty());
    CHECK(marching.world.group(0).build == BodyBuild::Narrow);
    CHECK(marching.world.groupDef(0).motions == MotionSet::March);
    plain.run(1);
    CHECK(plain.world.hash() != marching.world.hash());
    plain.run(60);
    marching.run(60);
    CHECK(copyOf(plain.world.characters().position) == copyOf(marching.world.characters().position));
    auto restored = World::restore(marching.world.snapshot());
    REQUIRE(restored.ok());
    CHECK(restored->group(0).motions == MotionSet::March);
    CHECK(marching.carryOut(ChangeGroup{.group = GroupId{1}, .look = GroupLook{std::nullopt, std::nullopt}})
              .empty());
    CHECK(plain.carryOut(ChangeGroup{.group = GroupId{1}, .name = "Group"}).empty());
    CHECK(plain.world.hash() == marching.world.hash());
    CHECK(plain.carryOut(ChangeGroup{.group = GroupId{3}, .look = GroupLook{{}, {}}}) ==
          "no group has the id 3");
    CHECK_FALSE(
        give(plain.world, ChangeGroup{.group = GroupId{1}, .look = GroupLook{BodyBuild{2}, {}}}).ok());
    CHECK_FALSE(
        give(plain.world, ChangeGroup{.group = GroupId{1}, .look = GroupLook{{}, MotionSet{2}}}).ok());
    WorldDef def = openFloor();
    def.groups[0].motions = MotionSet{9};
    CHECK_FALSE(World::create(def).ok());
}

TEST_CASE("a chosen colour is in the hash and moves nobody; without one the hash is that of before") {
    Floor plain, coloured;
    plain.run(1);
    CHECK(coloured.carryOut(ChangeGroup{.group = GroupId{1}, .colour = GroupColour{0x05536D}}).empty());
    CHECK(plain.world.hash() != coloured.world.hash());
    plain.run(60);
    coloured.run(60);
    CHECK(copyOf(plain.world.characters().position) == copyOf(coloured.world.characters().position));
    // The last command's step is state: both worlds get one.
    CHECK(plain.carryOut(ChangeGroup{.group = GroupId{1}, .name = "Group"}).empty());
    CHECK(coloured.carryOut(ChangeGroup{.group = GroupId{1}, .colour = GroupColour{std::nullopt}}).empty());
    CHECK(plain.world.hash() == coloured.world.hash());
}

TEST_CASE("colours are saved with the world, and a part that is split off has none") {
    Floor floor(busyFloor(3));
    CHECK(floor.carryOut(ChangeGroup{.group = GroupId{2}, .colour = GroupColour{0x00A1FF}}).empty());
    auto restored = World::restore(floor.world.snapshot());
    REQUIRE(restored.ok());
    CHECK_FALSE(restored->group(0).colour);
    CHECK(restored->group(1).colour == 0x00A1FFu);
    CHECK(restored->hash() == floor.world.hash());
    SplitGroup halves{GroupId{2}, SplitBy::Shares, {}, {}, {1.0, 1.0}, false, PartShape::AsHeld};
    CHECK(floor.carryOut(halves).empty());
    REQUIRE(floor.world.groupCount() == 3);
    CHECK(floor.world.group(1).colour == 0x00A1FFu);
    CHECK_FALSE(floor.world.group(2).colour);
}

TEST_CASE("a world with edited items and checkpoints is saved and goes on to the same hash") {
    Floor floor(busyFloor(3));
    CHECK(floor.carryOut(putThing(ItemDef{{3, 3}, 0.5})).empty());
    CHECK(floor.carryOut(putThing(ItemDef{{-3, 3}, 0.5})).empty());
    CHECK(floor.carryOut(removeThing(ItemId{1})).empty());
    CHECK(floor.carryOut(putThing(ringAt({3, 3}), {}, GroupId{2})).empty());
    CHECK(floor.carryOut(SetPose{GroupId{1}, {-8, -8}, 2.0, true}).empty());
    checkGoesOn(floor.world, 240);
    World restored = World::restore(floor.world.snapshot()).value();
    CHECK(restored.itemIds()[0].value == 2);
    REQUIRE(give(restored, putThing(ItemDef{{0, 9}, 0.5})).ok());
    restored.step();
    CHECK(restored.itemIds().back().value == 3);
}
