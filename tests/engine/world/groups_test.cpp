// Several groups and several clients at once; more characters than places; who comes late.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "engine/world/world_scenes.h"
#include "muster/views.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef twoGroups() {
    WorldDef def = openFloor(9);
    def.groups.push_back({.count = 16, .position = {6, 5}});
    return def;
}

/// Every character of a group has a place of that group, nobody the same as another.
void checkPlaces(const World& world) {
    std::set<std::pair<std::uint32_t, std::int32_t>> taken;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) {
        REQUIRE(c.group[i] < world.groupCount());
        if (c.place[i] < 0) continue;
        CHECK(static_cast<std::size_t>(c.place[i]) < world.group(c.group[i]).placePositions.size());
        CHECK(taken.insert({c.group[i], c.place[i]}).second);
    }
}

std::vector<Vec2> ofGroup(const World& world, std::size_t group) {
    std::vector<Vec2> positions;
    for (std::size_t i = 0; i < world.characters().size(); ++i) {
        if (world.characters().group[i] == group) positions.push_back(world.characters().position[i]);
    }
    return positions;
}

}  // namespace

TEST_CASE("two clients draw two groups in the same steps, with the same touch numbers") {
    World world = World::create(twoGroups()).value();
    for (int s = 0; s <= 120; ++s) {
        const double along = std::min(s / 100.0, 1.0);
        const auto send = [&](std::uint32_t client, Vec2 from, Vec2 travel) {
            const std::uint32_t sequence = static_cast<std::uint32_t>(s);
            if (s == 0)
                REQUIRE(world
                            .submit({world.stepCount(), client, sequence,
                                     Touch{TouchPhase::Down, 7, from, world.time(), {}}})
                            .ok());
            else if (s < 120)
                REQUIRE(world
                            .submit({world.stepCount(), client, sequence,
                                     Touch{TouchPhase::Move, 7, from + travel * along, world.time(), {}}})
                            .ok());
            else
                REQUIRE(world
                            .submit({world.stepCount(), client, sequence,
                                     Touch{TouchPhase::Up, 7, {}, world.time(), {}}})
                            .ok());
        };
        send(2, {6, 5}, {0, -8});
        send(1, {-6, 0}, {4, 4});
        world.step();
        REQUIRE(world.rejections().empty());
    }
    run(world, 8);
    CHECK(distance(world.group(0).pose.position, {-2, 4}) < 0.6);
    CHECK(distance(world.group(1).pose.position, {6, -3}) < 0.6);
    for (const std::size_t g : {0u, 1u}) {
        CHECK(worstToPlace(world, g) < 0.1);
        CHECK(world.group(g).controls.empty());
    }
    checkPlaces(world);
}

TEST_CASE("a client that leaves lifts its own fingers only") {
    World world = World::create(twoGroups()).value();
    REQUIRE(world.submit({0, 1, 0, Touch{TouchPhase::Down, 1, {-6, 0}, 0, {}}}).ok());
    REQUIRE(world.submit({0, 2, 0, Touch{TouchPhase::Down, 1, {6, 5}, 0, {}}}).ok());
    for (int s = 0; s < 30; ++s) world.step();
    REQUIRE(world.submit({world.stepCount(), 1, 1, ReleaseClient{}}).ok());
    run(world, 3);
    CHECK(world.group(0).controls.empty());
    CHECK(world.group(1).controls.size() == 1);
    REQUIRE(
        world.submit({world.stepCount(), 1, 2, Touch{TouchPhase::Move, 1, {0, 0}, world.time(), {}}}).ok());
    world.step();
    CHECK(world.rejections().size() == 1);  // Its finger is not down any more.
}

TEST_CASE("of commands in one step the last by client and sequence stands") {
    World world = World::create(openFloor(9)).value();
    const GroupId id = world.group(0).id;
    REQUIRE(world.submit({0, 9, 0, SetPose{id, {1, 0}, 0}}).ok());
    REQUIRE(world.submit({0, 3, 5, SetPose{id, {2, 0}, 0}}).ok());
    REQUIRE(world.submit({0, 3, 4, SetPose{id, {3, 0}, 0}}).ok());
    world.step();
    CHECK(distance(world.group(0).pose.position, {1, 0}) < 1e-6);
    REQUIRE(world.submit({1, 3, 7, SetPose{id, {2, 0}, 0}}).ok());
    REQUIRE(world.submit({1, 3, 6, SetPose{id, {3, 0}, 0}}).ok());
    world.step();
    CHECK(distance(world.group(0).pose.position, {2, 0}) < 1e-6);
    CHECK(world.lastCommandStep() == 1);
}

TEST_CASE("groups come and go while others stand; ids and places stay their own") {
    World world = World::create(twoGroups()).value();
    run(world, 0.5);
    const GroupId first = world.group(0).id, second = world.group(1).id;
    const auto standing = ofGroup(world, 1);
    GroupDef third{.count = 4, .position = {0, -8}};
    REQUIRE(give(world, AddGroup{third}).ok());
    run(world, 0.5);
    REQUIRE(world.groupCount() == 3);
    CHECK(world.characters().size() == 29);
    CHECK(world.group(2).id > second);
    checkPlaces(world);
    REQUIRE(give(world, RemoveGroup{first}).ok());
    run(world, 0.5);
    REQUIRE(world.groupCount() == 2);
    CHECK(world.group(0).id == second);
    CHECK(world.characters().size() == 20);
    CHECK(world.characters().id.front() == 10);  // The first nine are gone, nobody gets a new number.
    checkPlaces(world);
    const auto still = ofGroup(world, 0);
    REQUIRE(still.size() == standing.size());
    for (std::size_t i = 0; i < still.size(); ++i) CHECK(distance(still[i], standing[i]) < 1e-6);
    REQUIRE(give(world, RemoveGroup{first}).ok());
    REQUIRE(give(world, AddGroup{third}).ok());
    world.step();
    CHECK(world.rejections().size() == 1);
    REQUIRE(world.groupCount() == 3);
    CHECK(world.group(2).id.value == 4);
}

TEST_CASE("two groups change places through each other and end where they were sent") {
    WorldDef def = openFloor(16);
    def.groups.push_back({.count = 16, .position = {6, 0}});
    World world = World::create(def).value();
    REQUIRE(give(world, SetPose{world.group(0).id, {6, 0}, 0}).ok());
    REQUIRE(give(world, SetPose{world.group(1).id, {-6, 0}, 0}).ok());
    double worst = 0.0;
    for (int s = 0; s < 20 * 60; ++s) {
        world.step();
        worst = std::max(worst, world.contacts().worstPenetration);
        REQUIRE(world.contacts().overlapPairs == 0);
    }
    CHECK(worst < 0.1);
    CHECK(worstToPlace(world, 0) < 0.2);
    CHECK(worstToPlace(world, 1) < 0.2);
    for (const Vec2 p : ofGroup(world, 0)) CHECK(p.x > 2.5);
    for (const Vec2 p : ofGroup(world, 1)) CHECK(p.x < -2.5);
    checkPlaces(world);
}

TEST_CASE("events name the characters of the group that had them") {
    WorldDef def = twoGroups();
    def.patches = {rectangle(-11, -5, -1, 5, 3), rectangle(1, 0, 11, 11, 6)};  // One under each group.
    def.items = {{{-6, 0}, 1.0}, {{6, 5}, 1.0}};
    World world = World::create(def).value();
    std::set<std::uint32_t> entered[2], collected;
    for (int s = 0; s < 30; ++s) {
        world.step();
        for (const Event& event : world.events()) {
            if (event.kind == EventKind::EnterPatch) entered[event.value - 1].insert(event.subject);
            if (event.kind == EventKind::Collect) collected.insert(event.subject * 10 + event.value);
        }
    }
    const PatchId left = world.patchIds()[0];
    REQUIRE(left.value == 1);
    CHECK(entered[0].size() == 9);
    CHECK(*entered[0].rbegin() == 9);
    CHECK(entered[1].size() == 16);
    CHECK(*entered[1].begin() == 10);
    REQUIRE(collected.size() == 2);
    CHECK(*collected.begin() / 10 <= 9);
    CHECK(*collected.rbegin() / 10 >= 10);
}

TEST_CASE(
    "more characters than places that fit: who fits has a place, the others wait near and nobody overlaps") {
    WorldDef def{.box = {{-4, -2.2}, {4, 2.2}}};
    def.obstacles = {block(-4, -2.2, -1.5, 2.2), block(1.5, -2.2, 4, 2.2)};  // A room 3 m wide.
    GroupDef group{.count = 36, .formation = {.spacing = 1.0}};
    for (int i = 0; i < 36; ++i) {
        const int row = i / 5;
        group.starts.push_back({-1.15 + (i % 5) * 0.57, -1.9 + row * 0.52});
    }
    def.groups.push_back(group);
    World world = World::create(def).value();
    run(world, 12);
    const auto fit = world.group(0).placeUsable;
    const auto fitting = std::count(fit.begin(), fit.end(), 1);
    const CharactersView c = world.characters();
    const auto matched = std::count_if(c.place.begin(), c.place.end(), [](std::int32_t p) { return p >= 0; });
    CHECK(fitting < 36);
    CHECK(fitting > 18);
    CHECK(matched == fitting);
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.place[i] >= 0)
            CHECK(fit[c.place[i]] == 1);
        else
            CHECK(std::isinf(c.cost[i]));
    }
    checkPlaces(world);
    CHECK(world.contacts().overlapPairs == 0);
    CHECK(worstToPlace(world, 0) < 0.35);
}

TEST_CASE("late arrivals shift inward: those already there move on instead of being walked through") {
    // Twelve in file, one behind the other, walk to a square.
    WorldDef def = openFloor(12);
    def.groups[0].starts.clear();
    for (int i = 0; i < 12; ++i) def.groups[0].starts.push_back({-11.0 + 0.6 * i, 0.01 * i});  // In file.
    def.groups[0].position = {6, 0};
    World world = World::create(def).value();
    world.step();
    // The plan that is least in squares keeps the order along the path: the first in file goes farthest.
    const CharactersView c = world.characters();
    const auto placeX = [&](std::size_t i) { return world.group(0).placePositions[c.place[i]].x; };
    double front = 0.0, back = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        back += placeX(i) / 4;
        front += placeX(i + 8) / 4;
    }
    CHECK(front > back + 1.0);
    run(world, 20);
    CHECK(worstToPlace(world, 0) < 0.1);
    front = back = 0.0;
    for (std::size_t i = 0; i < 4; ++i) {
        back += placeX(i) / 4;
        front += placeX(i + 8) / 4;
    }
    CHECK(front > back + 1.0);
}

TEST_CASE("a thousand units, each a group of its own, go where each is sent") {
    constexpr int kSide = 32, kUnits = 1000;
    WorldDef def = openFloor(1);
    def.box = {{-60, -60}, {60, 60}};
    def.groups.assign(kUnits, def.groups.front());
    for (int k = 0; k < kUnits; ++k) {
        const int row = k / kSide;
        def.groups[k].position = {-40.0 + 2.0 * (k % kSide), 3.0 * row - 45.0};
    }
    World world = World::create(def).value();
    const auto targetOf = [&](int k) { return def.groups[k].position + Vec2{12.0, 0.0}; };
    for (int k = 0; k < kUnits; ++k) tell(world, Order::move(targetOf(k)), k);
    run(world, 10.0);
    std::size_t begun = 0, there = 0;
    for (int k = 0; k < kUnits; ++k) {
        const Vec2 p = ofGroup(world, k).front();
        begun += distance(p, def.groups[k].position) > 1.0 ? 1 : 0;
        there += distance(p, targetOf(k)) < 0.5 ? 1 : 0;
    }
    CHECK(begun == kUnits);
    CHECK(there == kUnits);
    checkPlaces(world);
}

TEST_CASE("who has just joined a group that is stopped stays where it is") {
    WorldDef def = twoGroups();
    def.box = {{-60, -60}, {60, 60}};
    def.groups[1].position = {45, 40};
    World world = World::create(def).value();
    const GroupId first = world.group(0).id;
    REQUIRE(world.submit({0, 1, 0, GiveOrder{first, QueueMode::Replace, 0, Order::move({-45, -40})}}).ok());
    run(world, 3.0);
    std::vector<std::uint32_t> joining;
    std::vector<Vec2> before;
    for (std::size_t i = 0; i < world.characters().size(); ++i) {
        if (world.characters().group[i] != 1 || joining.size() == 8) continue;
        joining.push_back(world.characters().id[i]);
        before.push_back(world.characters().position[i]);
    }
    REQUIRE(world.submit({world.stepCount(), 1, 1, TransferCharacters{joining, first}}).ok());
    REQUIRE(world.submit({world.stepCount() + 1, 1, 2, EditQueue{first, QueueEdit::Stop, 0}}).ok());
    run(world, 5.0);
    const CharactersView c = world.characters();
    for (std::size_t k = 0; k < joining.size(); ++k) {
        const auto i = std::find(c.id.begin(), c.id.end(), joining[k]) - c.id.begin();
        CHECK(c.group[i] == 0);
        CHECK(distance(before[k], c.position[i]) < 0.5);
    }
    checkPlaces(world);
}
