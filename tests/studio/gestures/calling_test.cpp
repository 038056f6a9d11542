// Two taps where nobody stands call whoever is nearest.
#include "studio/gestures/group_lookup.h"

#include "studio/gestures/driven_world.h"

using namespace muster;
using namespace muster::testing;

namespace {

ObstacleDef wall(Vec2 least, Vec2 most) {
    return {.polygon = {least, {most.x, least.y}, most, {least.x, most.y}}};
}

/// Single people who stand in groups of their own.
WorldDef singles(const std::vector<Vec2>& where) {
    WorldDef def = floorWith({});
    for (const Vec2 ground : where) def.groups.push_back(squareOf(1, ground));
    return def;
}

std::uint32_t comesTo(const WorldDef& def, Vec2 ground) {
    return whoComes(World::create(def).value(), ground).value();
}

/// The index of the group of one person alone; -1 for none.
int aloneAt(const DrivenWorld& driven) {
    for (std::size_t g = 0; g < driven.world.groupCount(); ++g)
        if (driven.members(g).size() == 1) return static_cast<int>(g);
    return -1;
}

}  // namespace

TEST_CASE("Two taps on free ground call exactly the nearest one, who arrives") {
    DrivenWorld driven(sixteen(), "touch");
    const Vec2 there{6, 0.6};
    const std::uint32_t nearest = driven.nearestTo(there);
    driven.tapTwice(there);
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(1) == std::vector<std::uint32_t>{nearest});
    CHECK(driven.members(0).size() == 15);
    CHECK(driven.world.group(1).orders.size() == 1);
    driven.run(6.0);
    CHECK(distance(driven.positionOf(nearest), there) < 0.3);
    CHECK(driven.world.group(1).orders.empty());
    CHECK(driven.world.group(0).orders.empty());
    CHECK(distance(driven.middle(0), {0, 0}) < 0.3);
    CHECK(driven.formation(0).spacing == 1.0);
    CHECK(driven.refused.empty());
}

TEST_CASE("Those from whom somebody is called close ranks, by a place at most") {
    DrivenWorld driven(sixteen(), "touch");
    const auto before = driven.positions();
    driven.tapTwice({6, 0.6});
    driven.run(6.0);
    REQUIRE(driven.world.groupCount() == 2);
    for (const std::uint32_t id : driven.members(0)) {
        CAPTURE(id);
        CHECK(distance(driven.positionOf(id), before[id - 1]) < 1.2);
    }
}

TEST_CASE("One tap, and taps too far apart in time or place, call nobody") {
    DrivenWorld driven(sixteen(), "touch");
    const auto before = driven.positions();
    driven.tap({6, 0});
    driven.run(0.5);
    driven.tapTwice({6, 0}, {6, 0}, 0.4);
    driven.run(0.5);
    driven.tapTwice({6, 0}, {6.8, 0});  // 9 mm.
    driven.run(1.0);
    CHECK(driven.world.groupCount() == 1);
    CHECK(driven.world.group(0).orders.empty());
    CHECK(driven.farthestFrom(before) < 0.1);
    driven.tapTwice({6, 0}, {6.6, 0}, 0.28);  // 6.7 mm.
    driven.run(0.1);
    CHECK(driven.world.groupCount() == 2);
}

TEST_CASE("A third tap calls nobody else") {
    DrivenWorld driven(sixteen(), "touch");
    driven.tapTwice({6, 0});
    driven.run(0.1);
    driven.tap({6, 0});
    driven.run(1.0);
    CHECK(driven.world.groupCount() == 2);
}

TEST_CASE("Cancelled pointers call nobody") {
    DrivenWorld driven(sixteen(), "touch");
    for (int i = 0; i < 3; ++i) {
        driven.down(1, {6, 0});
        driven.run(0.05);
        driven.cancel(1);
        driven.run(0.05);
    }
    driven.tap({6, 0});
    driven.run(0.5);
    CHECK(driven.world.groupCount() == 1);
    driven.down(1, {6, 0});
    driven.run(0.05);
    driven.cancel(1);
    driven.tap({6, 0});
    driven.run(0.5);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("A wall between makes somebody farther away with a free way come") {
    WorldDef def = singles({{-2, 0}, {5, 0}});
    CHECK(comesTo(def, {1, 0}) == 1);
    def.obstacles = {wall({-0.8, -3}, {-0.4, 3})};
    CHECK(comesTo(def, {1, 0}) == 2);
    // A barred way counts twice, not more.
    def.groups[1].position = {7.5, 0};
    CHECK(comesTo(def, {1, 0}) == 1);
    def.groups[1].position = {5, 0};
    DrivenWorld driven(def, "touch");
    driven.tapTwice({1, 0});
    driven.run(5.0);
    CHECK(distance(driven.positionOf(2), {1, 0}) < 0.3);
    CHECK(distance(driven.positionOf(1), {-2, 0}) < 0.3);
}

TEST_CASE("Whoever is called from behind a wall goes round it") {
    WorldDef def = singles({{-2, 0}, {12, 0}});
    def.obstacles = {wall({-0.8, -3}, {-0.4, 3})};
    DrivenWorld driven(def, "touch");
    driven.tapTwice({1.5, 0});
    driven.run(10.0);
    CHECK(distance(driven.positionOf(1), {1.5, 0}) < 0.3);
    CHECK(distance(driven.positionOf(2), {12, 0}) < 0.1);
}

TEST_CASE("A round obstacle bars a way as a wall does") {
    WorldDef def = singles({{-2, 0}, {5, 0}});
    def.obstacles = {{.centre = {-0.5, 0}, .radius = 1.0}};
    CHECK(comesTo(def, {1, 0}) == 2);
}

TEST_CASE("A second call elsewhere does not turn the first one round") {
    DrivenWorld driven(sixteen(), "touch");
    driven.tapTwice({8, 0.6});
    driven.run(1.5);
    const int first = aloneAt(driven);
    REQUIRE(first >= 0);
    const std::uint32_t called = driven.members(static_cast<std::size_t>(first))[0];
    const Vec2 second = driven.positionOf(called) + Vec2{0, 3};
    REQUIRE(driven.nearestTo(second) == called);
    driven.tapTwice(second);
    driven.run(8.0);
    CHECK(driven.world.groupCount() == 3);
    CHECK(distance(driven.positionOf(called), {8, 0.6}) < 0.3);
    const std::uint32_t other = driven.nearestTo(second);
    CHECK(other != called);
    CHECK(distance(driven.positionOf(other), second) < 0.3);
    CHECK(driven.members(0).size() == 14);
}

TEST_CASE("Between the people of a formation that follows a drawn way one is called and the rest goes on") {
    DrivenWorld driven(floorWith({squareOf(16, {-6, -5}, 3.0)}), "touch");
    const Vec2 person = driven.positionOf(1);
    driven.draw({person, person + Vec2{0, 10}}, 0.5);
    driven.run(1.0);
    const ControlId way = driven.world.group(0).controls[0].id;
    const Vec2 between = driven.world.group(0).pose.position;
    const std::uint32_t nearest = driven.nearestTo(between + Vec2{0, 0.2});
    REQUIRE(distance(driven.positionOf(nearest), between) > 1.2);
    driven.tapTwice(between);
    driven.run(0.2);
    REQUIRE(driven.world.groupCount() == 2);
    CHECK(driven.members(0).size() == 15);
    CHECK(driven.members(1).size() == 1);
    REQUIRE(driven.world.group(0).controls.size() == 1);
    CHECK(driven.world.group(0).controls[0].id == way);
    CHECK(driven.world.group(1).controls.empty());
    const std::uint32_t called = driven.members(1)[0];
    driven.run(9.0);
    CHECK(distance(driven.positionOf(called), between) < 0.3);
    CHECK(distance(driven.middle(0), {-6, 5}) < 0.8);
    CHECK(driven.world.group(0).controls.empty());
}

TEST_CASE("Who is called from a formation that marches leaves it its orders") {
    WorldDef def = floorWith({squareOf(16, {-8, 0})});
    def.groups[0].orders = {Order::move({4, 0})};
    DrivenWorld driven(def, "touch");
    driven.run(1.0);
    const std::uint32_t order = driven.world.group(0).orders[0].id;
    driven.tapTwice({-6, -8});
    driven.run(0.1);
    REQUIRE(driven.world.groupCount() == 2);
    const std::uint32_t called = driven.members(1)[0];
    REQUIRE(driven.world.group(0).orders.size() == 1);
    CHECK(driven.world.group(0).orders[0].id == order);
    CHECK(driven.world.group(1).orders.size() == 1);
    driven.run(12.0);
    CHECK(distance(driven.middle(0), {4, 0}) < 0.5);
    CHECK(distance(driven.positionOf(called), {-6, -8}) < 0.3);
}

TEST_CASE("touch-no-calls and touch-no-splits call nobody") {
    for (const char* scheme : {"touch-no-calls", "touch-no-splits"}) {
        CAPTURE(scheme);
        DrivenWorld driven(sixteen(), scheme);
        const auto before = driven.positions();
        driven.tapTwice({6, 0});
        driven.run(2.0);
        CHECK(driven.world.groupCount() == 1);
        CHECK(driven.world.group(0).orders.empty());
        CHECK(driven.farthestFrom(before) < 0.1);
        // Between people a finger takes hold at once.
        DrivenWorld wide(floorWith({squareOf(16, {0, 0}, 3.0)}), scheme);
        wide.down(1, {0, 0});
        wide.step();
        CHECK(wide.world.group(0).controls.size() == 1);
        wide.up(1);
        wide.tapTwice({0, 0});
        wide.run(1.0);
        CHECK(wide.world.groupCount() == 1);
    }
}

TEST_CASE("Where all people are under way two taps do nothing; who has arrived comes again") {
    DrivenWorld driven(singles({{-4, 0}}), "touch");
    driven.tapTwice({4, 0});
    driven.run(1.0);
    REQUIRE(driven.world.group(0).orders.size() == 1);
    driven.tapTwice({-4, 6});
    driven.run(0.1);
    CHECK(!whoComes(driven.world, {-4, 6}));
    REQUIRE(driven.world.group(0).orders.size() == 1);
    CHECK(distance(driven.world.group(0).orders[0].order.target, {4, 0}) < 1e-6);
    driven.run(7.0);
    CHECK(distance(driven.positionOf(1), {4, 0}) < 0.3);
    driven.tapTwice({4, 6});
    driven.run(6.0);
    CHECK(distance(driven.positionOf(1), {4, 6}) < 0.3);
    CHECK(driven.world.groupCount() == 1);
}

TEST_CASE("Of two that are as near the one with the smaller id comes") {
    CHECK(comesTo(singles({{0, 2}, {0, -2}}), {3, 0}) == 1);
    CHECK(comesTo(singles({{5, 5}, {0, -2}, {0, 2}}), {3, 0}) == 2);
    WorldDef def = singles({{0, -2}, {0, 2}});
    def.groups.push_back(squareOf(1, {6, 2}));
    CHECK(comesTo(def, {3, 0}) == 1);
}

TEST_CASE("Nobody comes in a world without people") {
    CHECK(!whoComes(World::create(floorWith({})).value(), {0, 0}));
}
