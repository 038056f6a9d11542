// Characters join, leave and change groups; groups split and merge: ids, positions, velocities and places of
// all others stay.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "base/maths.h"
#include "engine/world/world_scenes.h"
#include "muster/world.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// Where each character is, by id.
std::map<std::uint32_t, Vec2> positionsOf(const World& world) {
    std::map<std::uint32_t, Vec2> positions;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) positions[c.id[i]] = c.position[i];
    return positions;
}

/// Where the place of each character is, by id.
std::map<std::uint32_t, Vec2> placesOf(const World& world) {
    std::map<std::uint32_t, Vec2> places;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c.place[i] >= 0) places[c.id[i]] = world.group(c.group[i]).placePositions[c.place[i]];
    return places;
}

std::map<std::uint32_t, double> speedsOf(const World& world) {
    std::map<std::uint32_t, double> speeds;
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) speeds[c.id[i]] = length(c.velocity[i]);
    return speeds;
}

double farthestMove(const std::map<std::uint32_t, Vec2>& before, const std::map<std::uint32_t, Vec2>& after) {
    double most = 0.0;
    for (const auto& [id, p] : after)
        if (const auto at = before.find(id); at != before.end())
            most = std::max(most, distance(at->second, p));
    return most;
}

/// A field with one square group that walks to the right: every place is under way for half a minute.
WorldDef field(std::int32_t count) {
    WorldDef def{.box = {{-20, -30}, {90, 30}}};
    def.groups.emplace_back().count = count;
    return def;
}

World walking(std::int32_t count) {
    World world = World::create(field(count)).value();
    run(world, 0.5);
    REQUIRE(give(world, SetPose{world.group(0).id, {70, 0}, 0.0}).ok());
    run(world, 6.0);
    return world;
}

const Event* eventOf(const World& world, EventKind kind) {
    for (const Event& event : world.events())
        if (event.kind == kind) return &event;
    return nullptr;
}

std::int32_t countOf(const World& world, EventKind kind) {
    return static_cast<std::int32_t>(std::count_if(world.events().begin(), world.events().end(),
                                                   [&](const Event& e) { return e.kind == kind; }));
}

/// Everybody is alive, apart from the others, and at a place at the end.
void checkSettled(World& world, double seconds) {
    run(world, seconds);
    const CharactersView c = world.characters();
    std::set<std::pair<std::uint32_t, std::int32_t>> taken;
    for (std::size_t i = 0; i < c.size(); ++i) {
        REQUIRE(std::isfinite(c.position[i].x));
        REQUIRE(c.place[i] >= 0);
        CHECK(taken.insert({c.group[i], c.place[i]}).second);
        CHECK(distance(c.position[i], world.group(c.group[i]).placePositions[c.place[i]]) < 0.5);
    }
    CHECK(world.contacts().overlapPairs == 0);
}

/// The same bits after a snapshot.
void checkSnapshot(World& world, double seconds) {
    World copy = World::restore(world.snapshot()).value();
    REQUIRE(copy.hash() == world.hash());
    run(copy, seconds);
    run(world, seconds);
    CHECK(copy.hash() == world.hash());
}

}  // namespace

TEST_CASE("one death among 60 on the way moves nobody but those behind in the file") {
    World world = walking(60);
    const auto positions = positionsOf(world), places = placesOf(world);
    const CharactersView c = world.characters();
    // Somebody in the front rank of the mesh.
    std::size_t dead = 0;
    for (std::size_t i = 0; i < c.size(); ++i) {
        const GroupView group = world.group(0);
        const auto restX = [&](std::size_t k) {
            return group.meshPlaces[c.place[k]].position(copyOf(group.triangles), copyOf(group.restMesh)).x;
        };
        if (restX(i) > restX(dead)) dead = i;
    }
    const std::uint32_t id = c.id[dead];
    REQUIRE(give(world, TransferCharacters{{id}, {}}).ok());
    world.step();
    REQUIRE(world.rejections().empty());
    REQUIRE(countOf(world, EventKind::Left) == 1);
    CHECK(eventOf(world, EventKind::Left)->subject == id);
    CHECK(world.characters().size() == 59);
    CHECK(world.group(0).count == 59);
    // Nobody jumps; places move up by a rank, and the last rank closes up sideways.
    CHECK(farthestMove(positions, positionsOf(world)) < 0.05);
    const auto after = placesOf(world);
    CHECK(after.size() == 59);
    CHECK(farthestMove(places, after) < 6.0);
    std::int32_t moved = 0;
    for (const auto& [who, place] : after) moved += distance(places.at(who), place) > 0.5 ? 1 : 0;
    // 60 in 8 files: at most the file behind, of 8 ranks, and the last rank of 4, which is centred again.
    CHECK(moved <= 12);
    checkSnapshot(world, 1.0);
    checkSettled(world, 40.0);
}

TEST_CASE("ten deaths on the way, one after the other, stop nobody") {
    World world = walking(60);
    for (int death = 0; death < 10; ++death) {
        const auto speeds = speedsOf(world);
        const std::uint32_t id = world.characters().id[(death * 17u) % world.characters().size()];
        REQUIRE(give(world, TransferCharacters{{id}, {}}).ok());
        run(world, 0.25);
        REQUIRE(world.rejections().empty());
        for (const auto& [who, speed] : speedsOf(world))
            if (speeds.at(who) > 1.5) CHECK(speed > 0.8);
        run(world, 0.25);
    }
    CHECK(world.characters().size() == 50);
    checkSettled(world, 40.0);
}

TEST_CASE("reinforcements join where they stand, and their ids are told") {
    World world = walking(36);
    const auto positions = positionsOf(world), places = placesOf(world);
    std::vector<Vec2> joining;
    for (int k = 0; k < 7; ++k) joining.push_back({-15.0 + k, 12.0});
    REQUIRE(give(world, AddCharacters{world.group(0).id, joining, {}}).ok());
    world.step();
    REQUIRE(world.rejections().empty());
    REQUIRE(countOf(world, EventKind::Joined) == 7);
    CHECK(world.group(0).count == 43);
    const auto after = positionsOf(world);
    std::size_t k = 0;
    for (const Event& event : world.events()) {
        if (event.kind != EventKind::Joined) continue;
        CHECK(event.value == world.group(0).id.value);
        CHECK(positions.count(event.subject) == 0);
        CHECK(distance(after.at(event.subject), joining[k++]) < 0.6);
    }
    CHECK(farthestMove(positions, after) < 0.05);
    // The others stay, but for exchanges that pay.
    std::int32_t moved = 0;
    for (const auto& [who, place] : placesOf(world))
        if (const auto at = places.find(who); at != places.end()) moved += distance(at->second, place) > 0.5;
    CHECK(moved <= 3);
    checkSnapshot(world, 1.0);
    checkSettled(world, 55.0);
}

TEST_CASE("a group may become empty, stay, and be filled again") {
    World world = walking(9);
    const GroupId id = world.group(0).id;
    const auto all = copyOf(world.characters().id);
    REQUIRE(give(world, TransferCharacters{all, {}}).ok());
    run(world, 1.0);
    REQUIRE(world.groupCount() == 1);
    CHECK(world.characters().size() == 0);
    CHECK(world.group(0).count == 0);
    checkSnapshot(world, 0.5);
    REQUIRE(give(world, SetPose{id, {10, 5}, 0.0}).ok());
    run(world, 0.5);
    REQUIRE(give(world, AddCharacters{id, {{0, 0}, {1, 0}, {2, 0}, {0, 2}}, {}}).ok());
    world.step();
    REQUIRE(world.rejections().empty());
    CHECK(world.group(0).count == 4);
    CHECK(world.characters().id[0] > all.back());
    checkSettled(world, 20.0);
}

TEST_CASE("characters change groups with their ids and velocities") {
    WorldDef def = field(25);
    def.groups.push_back(def.groups[0]);
    def.groups[1].position = {0, 15};
    World world = World::create(def).value();
    run(world, 0.5);
    const GroupId second = world.group(1).id;
    REQUIRE(give(world, SetPose{world.group(0).id, {40, 0}, 0.0}).ok());
    run(world, 3.0);
    const auto positions = positionsOf(world);
    const auto speeds = speedsOf(world);
    REQUIRE(give(world, TransferCharacters{{3, 7, 11, 30}, second}).ok());
    world.step();
    REQUIRE(world.rejections().empty());
    CHECK(countOf(world, EventKind::Transferred) == 3);  // 30 was there already.
    CHECK(world.group(0).count == 22);
    CHECK(world.group(1).count == 28);
    CHECK(farthestMove(positions, positionsOf(world)) < 0.05);
    for (const auto& [who, speed] : speedsOf(world)) CHECK(std::fabs(speed - speeds.at(who)) < 0.4);
    checkSnapshot(world, 1.0);
    checkSettled(world, 35.0);
}

TEST_CASE("a split stops nobody, and each part keeps the places that it held") {
    for (const PartShape shape : {PartShape::AsHeld, PartShape::Smaller}) {
        World world = walking(60);
        const auto positions = positionsOf(world), places = placesOf(world);
        const auto speeds = speedsOf(world);
        const GroupView group = world.group(0);
        Vec2 middle;
        for (const Vec2 v : group.finalMesh) middle += v / static_cast<double>(group.finalMesh.size());
        SplitGroup split{group.id, SplitBy::Line, {},   {middle - Vec2{9, 0}, middle + Vec2{9, 0}},
                         {},       false,         shape};
        REQUIRE(give(world, split).ok());
        world.step();
        REQUIRE(world.rejections().empty());
        REQUIRE(world.groupCount() == 2);
        REQUIRE(eventOf(world, EventKind::GroupAdded) != nullptr);
        CHECK(eventOf(world, EventKind::GroupAdded)->subject == world.group(1).id.value);
        CHECK(eventOf(world, EventKind::GroupAdded)->value == world.group(0).id.value);
        CHECK(world.group(0).count + world.group(1).count == 60);
        CHECK(farthestMove(positions, positionsOf(world)) < 0.05);
        if (shape == PartShape::AsHeld) CHECK(farthestMove(places, placesOf(world)) < 0.2);
        checkSnapshot(world, 0.5);
        for (const auto& [who, speed] : speedsOf(world))
            if (speeds.at(who) > 1.5) CHECK(speed > 1.0);
        checkSettled(world, 45.0);
    }
}

TEST_CASE("the sides of a line, a lasso, ids and shares say who leaves") {
    World world = World::create(field(36)).value();
    run(world, 0.2);
    const GroupId whole = world.group(0).id;
    // The six files of the square lie at y = -2.5 to 2.5: three lie to the left of the axis.
    REQUIRE(give(world, SplitGroup{whole, SplitBy::Line, {}, {{-9, 0}, {9, 0}}, {}, false, {}}).ok());
    world.step();
    REQUIRE(world.groupCount() == 2);
    CHECK(world.group(1).count == 18);
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) CHECK((c.position[i].y > 0.0) == (c.group[i] == 1));
    // The two front ranks of what is left.
    REQUIRE(
        give(world, SplitGroup{whole, SplitBy::Lasso, {}, {{1, -9}, {9, -9}, {9, 9}, {1, 9}}, {}, false, {}})
            .ok());
    world.step();
    REQUIRE(world.groupCount() == 3);
    CHECK(world.group(2).count == 6);
    REQUIRE(
        give(world, SplitGroup{world.group(1).id, SplitBy::Shares, {}, {}, {1.0, 2.0, 3.0}, true, {}}).ok());
    world.step();
    REQUIRE(world.groupCount() == 5);
    CHECK(world.group(1).count == 3);
    CHECK(world.group(3).count == 6);
    CHECK(world.group(4).count == 9);
    std::vector<std::uint32_t> ids;
    for (std::size_t i = 0; i < world.characters().size(); ++i)
        if (world.characters().group[i] == 4 && ids.size() < 4) ids.push_back(world.characters().id[i]);
    REQUIRE(give(world, SplitGroup{world.group(4).id, SplitBy::Ids, ids, {}, {}, false, {}}).ok());
    world.step();
    REQUIRE(world.groupCount() == 6);
    CHECK(world.group(5).count == 4);
    checkSettled(world, 5.0);
}

TEST_CASE("a merge joins all to the first, and stops nobody") {
    for (const PartShape shape : {PartShape::Smaller, PartShape::AsHeld}) {
        World world = walking(48);
        const GroupId first = world.group(0).id;
        REQUIRE(
            give(world, SplitGroup{first, SplitBy::Shares, {}, {}, {1, 1, 1}, true, PartShape::AsHeld}).ok());
        run(world, 1.0);
        REQUIRE(world.groupCount() == 3);
        const GroupId second = world.group(1).id, third = world.group(2).id;
        const auto positions = positionsOf(world);
        const auto speeds = speedsOf(world);
        REQUIRE(give(world, MergeGroups{{first, third, second}, shape}).ok());
        world.step();
        REQUIRE(world.rejections().empty());
        CHECK(world.groupCount() == 1);
        CHECK(countOf(world, EventKind::GroupRemoved) == 2);
        CHECK(world.group(0).count == 48);
        CHECK(farthestMove(positions, positionsOf(world)) < 0.05);
        checkSnapshot(world, 0.5);
        std::int32_t slowed = 0;
        for (const auto& [who, speed] : speedsOf(world))
            slowed += speeds.at(who) > 1.5 && speed < 1.0 ? 1 : 0;
        CHECK(slowed == 0);
        checkSettled(world, 45.0);
    }
}

TEST_CASE("bad changes of groups are refused and change nothing") {
    World world = World::create(field(9)).value();
    run(world, 0.2);
    const GroupId group = world.group(0).id;
    World twin = World::restore(world.snapshot()).value();
    const std::vector<CommandBody> bad{
        TransferCharacters{{77}, {}},
        TransferCharacters{{1, 2}, GroupId{9}},
        TransferCharacters{{1, 2}, group},
        AddCharacters{GroupId{9}, {{0, 0}}, {}},
        SplitGroup{group, SplitBy::Line, {}, {{-9, 25}, {9, 25}}, {}, false, {}},
        SplitGroup{group, SplitBy::Ids, {77}, {}, {}, false, {}},
        SplitGroup{group, SplitBy::Shares, {}, {}, std::vector<double>(20, 1.0), false, {}},
        MergeGroups{{group, GroupId{9}}, {}},
    };
    for (const CommandBody& body : bad) {
        REQUIRE(give(world, body).ok());
        world.step();
        twin.step();
        REQUIRE(world.rejections().size() == 1);
        CHECK(!world.rejections()[0].status.message().empty());
        CHECK(world.characters().size() == 9);
        CHECK(positionsOf(world) == positionsOf(twin));
    }
    CHECK(!give(world, TransferCharacters{{1, 1}, {}}).ok());
    CHECK(!give(world, TransferCharacters{}).ok());
    CHECK(!give(world, MergeGroups{{group, group}, {}}).ok());
}
