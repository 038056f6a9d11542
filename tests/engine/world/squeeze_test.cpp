// Formations before passages, and checkpoints that crowds pass.
#include <doctest.h>

#include <fstream>
#include <sstream>

#include "engine/world/world_scenes.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A wall across a floor of 60 m x 40 m with a gap of a given width, and 36 people in front of it.
WorldDef gapScene(double gap, Turn turn = Turn::Wheel) {
    WorldDef def{.box = {{-30, -20}, {30, 20}},
                 .obstacles = {block(-1, -20, 1, -0.5 * gap), block(-1, 0.5 * gap, 1, 20)}};
    GroupDef group{
        .count = 36, .formation = {.files = 9}, .position = {-18, 0}, .orders = {Order::move({18, 0})}};
    group.orders.front().turn = turn;
    def.groups.push_back(group);
    return def;
}

struct Passing {
    double width = 0.0;  ///< Between the outermost places within a metre of the wall, at most [m].
    double least = 1e9;  ///< That of the whole formation beyond 12 m from the wall, at least [m].
    bool done = false;
    double seconds = 0.0;
    World world;
};

Passing pass(const WorldDef& def, double most = 150.0) {
    Passing result{0.0, 1e9, false, 0.0, World::create(def).value()};
    World& world = result.world;
    while (!result.done && world.time() < most) {
        world.step();
        double low = 1e9, high = -1e9, nearLow = 0.0, nearHigh = 0.0, near = 1e9;
        for (const Vec2 p : world.group(0).placePositions) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
            near = std::min(near, std::fabs(p.x));
            if (std::fabs(p.x) > 1.0) continue;
            nearLow = std::min(nearLow, p.y);
            nearHigh = std::max(nearHigh, p.y);
        }
        result.width = std::max(result.width, nearHigh - nearLow);
        if (near > 12.0) result.least = std::min(result.least, high - low);
        for (const Event& e : world.events()) result.done = result.done || e.kind == EventKind::OrderDone;
        REQUIRE(world.contacts().overlapPairs == 0);
    }
    result.seconds = world.time();
    return result;
}

}  // namespace

TEST_CASE("a formation narrows only as far as a gap asks, and restores itself behind it") {
    for (const double gap : {14.0, 6.0, 3.0, 1.2})
        for (const Turn turn : {Turn::Flow, Turn::Wheel}) {
            CAPTURE(gap);
            const Passing passing = pass(gapScene(gap, turn));
            MESSAGE("gap of " << gap << " m: " << passing.width << " m wide in it, " << passing.seconds
                              << " s");
            CHECK(passing.done);
            // Nine abreast are 8 m wide; half a metre is for a body.
            const double room = std::min(8.0, gap - 0.5);
            CHECK(passing.width > 0.6 * room);
            CHECK(passing.width < room + 0.1);
            CHECK(passing.least > 7.9);
        }
}

TEST_CASE("who may not narrow takes the wide way, and narrows where there is none") {
    WorldDef def = gapScene(3.0);
    def.groups[0].conduct.squeeze = 0.0;
    const Passing passing = pass(def);
    CHECK(passing.done);
    CHECK(passing.width < 2.6);
    CHECK(passing.least > 7.9);
    // A gap of 12 m farther north.
    def.obstacles[1] = block(-1, 1.5, 1, 7);
    for (const double squeeze : {0.0, 0.5}) {
        def.groups[0].conduct.squeeze = squeeze;
        World world = World::create(def).value();
        double north = 0.0;
        for (int s = 0; s < 60 * 60 && !world.group(0).orders.empty(); ++s) {
            world.step();
            if (std::fabs(world.group(0).pose.position.x) < 1.0)
                north = std::max(north, world.group(0).pose.position.y);
        }
        CHECK(north > 10.0);
        CHECK(world.group(0).orders.empty());
    }
}

TEST_CASE("trees on the way do not narrow a formation, and a thin wall with a door does") {
    WorldDef def = gapScene(3.0);
    def.obstacles.clear();
    for (const double y : {-3.0, 3.2, 7.0}) def.obstacles.push_back(tree({0, y}, 0.4));
    Passing passing = pass(def);
    CHECK(passing.done);
    CHECK(passing.width > 7.9);
    def.obstacles = {block(-0.15, -20, 0.15, -1.5), block(-0.15, 1.5, 0.15, 20)};
    passing = pass(def);
    CHECK(passing.done);
    CHECK(passing.least > 7.9);
}

TEST_CASE("checkpoints fire when the crowd passes, however it was ordered") {
    for (const bool march : {false, true}) {
        WorldDef def{.box = {{-25, -12}, {25, 12}}};
        def.groups.push_back({.count = 16,
                              .position = {-15, 0},
                              .orders = {march ? Order::move({15, 0}) : Order::go({15, 0})}});
        FormationCheckpointDef crowd{
            .position = {0, 0}, .radius = 2.5, .formation = {.kind = FormationKind::Wedge}};
        FormationCheckpointDef mesh = crowd;
        mesh.position = {15, 0};
        mesh.trigger = CheckpointTrigger::Mesh;
        mesh.formation.kind = FormationKind::Circle;
        def.checkpoints = {crowd, mesh};
        World world = World::create(def).value();
        double crowdAt = -1.0, meshAt = -1.0, middle = 99.0;
        for (int s = 0; s < 40 * 60; ++s) {
            world.step();
            for (const Event& e : world.events()) {
                if (e.kind != EventKind::Passed) continue;
                (e.value == 0 ? crowdAt : meshAt) = world.time();
                if (e.value != 0) continue;
                middle = 0.0;
                for (const Vec2 p : world.characters().position) middle += p.x / 16.0;
            }
        }
        CAPTURE(march);
        CHECK(crowdAt > 3.0);
        CHECK(std::fabs(middle) < 3.0);
        // Poses of free orders jump: their mesh is there at once.
        CHECK((march ? meshAt > crowdAt : meshAt < 1.0));
    }
}

TEST_CASE("a checkpoint smaller than the crowd fires when the middle of the crowd is in it") {
    WorldDef def{.box = {{-25, -12}, {25, 12}}};
    def.groups.push_back({.count = 100, .position = {-12, 0}, .orders = {Order::move({14, 0})}});
    FormationCheckpointDef small{.radius = 0.8, .formation = {.kind = FormationKind::Line}};
    FormationCheckpointDef aside = small;
    aside.position = {0, 3};
    FormationCheckpointDef most = small;
    most.position = {6, 0};
    most.share = 0.6;
    def.checkpoints = {small, aside, most};
    World world = World::create(def).value();
    std::vector<std::uint32_t> passed;
    for (int s = 0; s < 30 * 60; ++s) {
        world.step();
        for (const Event& e : world.events()) {
            if (e.kind != EventKind::Passed) continue;
            passed.push_back(e.value);
            Vec2 sum;
            for (const Vec2 p : world.characters().position) sum += p;
            CHECK(length(sum / 100.0) <= 0.8);
        }
    }
    CHECK(passed == std::vector<std::uint32_t>{0});
}

TEST_CASE("a front of a given width: ranks and files take it up, other shapes keep theirs") {
    for (const FormationKind kind :
         {FormationKind::Square, FormationKind::Line, FormationKind::Column, FormationKind::Wedge}) {
        CAPTURE(formationName(kind));
        WorldDef def{.box = {{-25, -25}, {25, 25}}};
        def.groups.push_back({.count = 24,
                              .formation = {.kind = kind},
                              .position = {-10, 0},
                              .orders = {Order::moveToLine({8, 4.5}, {8, -4.5})}});
        World world = World::create(def).value();
        for (int s = 0; s < 40 * 60; ++s) world.step();
        double low = 0.0, high = 0.0, foremost = -99.0;
        for (const Vec2 p : world.characters().position) {
            low = std::min(low, p.y);
            high = std::max(high, p.y);
            foremost = std::max(foremost, p.x);
        }
        if (kind == FormationKind::Wedge) {
            CHECK(world.groupDef(0).formation.kind == kind);
            continue;
        }
        // Nine metres hold ten files a metre apart.
        CHECK(world.groupDef(0).formation.files == 10);
        CHECK(high == doctest::Approx(4.5).epsilon(0.05));
        CHECK(low == doctest::Approx(-4.5).epsilon(0.05));
    }
}

TEST_CASE("whatever shape follows whatever shape on a march, places stay with the crowd") {
    const std::vector<FormationKind> kinds{
        FormationKind::Square, FormationKind::Line,   FormationKind::Column,   FormationKind::Wedge,
        FormationKind::Ring,   FormationKind::Circle, FormationKind::Crescent, FormationKind::Pacman};
    for (const FormationKind before : kinds) {
        for (const FormationKind after : kinds) {
            CAPTURE(formationName(before));
            CAPTURE(formationName(after));
            WorldDef def{.box = {{100, 80}, {170, 140}}};
            GroupDef group{.count = 60, .formation = {.kind = before}, .position = {120, 100}};
            Order order = Order::move({145, 115});
            order.formation = FormationDef{.kind = after};
            group.orders = {Order::move({123, 100}), order};
            def.groups.push_back(group);
            World world = World::create(def).value();
            double farthest = 0.0;
            for (int s = 0; s < 15 * 60; ++s) {
                world.step();
                const GroupView view = world.group(0);
                for (const Vec2 place : view.placePositions) {
                    double nearest = 1e9;
                    for (const Vec2 p : world.characters().position)
                        nearest = std::min(nearest, distance(p, place));
                    farthest = std::max(farthest, nearest);
                }
            }
            CHECK(farthest < 2.5);
        }
    }
}

TEST_CASE("formations wider than the streets get through a town, however they turn") {
    for (const Turn turn : {Turn::Wheel, Turn::Reverse, Turn::Keep}) {
        for (const FormationKind kind : {FormationKind::Line, FormationKind::Square, FormationKind::Ring}) {
            CAPTURE(static_cast<int>(turn));
            CAPTURE(formationName(kind));
            WorldDef def{.box = {{-50, -35}, {50, 35}}};
            // Three by four houses of 10 m to 16 m, on streets of 5 m; every second column is shifted.
            for (int x = 0; x < 3; ++x)
                for (int y = 0; y < 4; ++y) {
                    const double left = -20.0 + 15.0 * x, low = -34.0 + 17.0 * y + (x % 2) * 6.0;
                    def.obstacles.push_back(block(left, low, left + 10.0, std::min(34.0, low + 12.0)));
                }
            GroupDef group{.count = 60, .formation = {.kind = kind}, .position = {-36, 0}};
            Order order = Order::move({36, 4}, 0.5);
            order.turn = turn;
            group.orders = {order};
            def.groups.push_back(group);
            World world = World::create(def).value();
            bool done = false;
            while (!done && world.time() < 360.0) {
                world.step();
                for (const Event& e : world.events()) done = done || e.kind == EventKind::OrderDone;
                REQUIRE(world.contacts().worstPenetration < 0.1);
            }
            CHECK(done);
        }
    }
}

TEST_CASE("a free group follows a drawn way, and faces as that ends") {
    WorldDef def{.box = {{-30, -25}, {30, 25}}};
    GroupDef group{.count = 30, .position = {-20, 0}};
    Order order = Order::go({20, 0});
    order.route = {{-20, 18}, {20, 18}};
    group.orders = {order};
    def.groups.push_back(group);
    World world = World::create(def).value();
    bool done = false;
    double high = 0.0, aside = 0.0;
    while (!done && world.time() < 90.0) {
        world.step();
        for (const Event& e : world.events()) done = done || e.kind == EventKind::OrderDone;
        Vec2 middle;
        for (const Vec2 p : world.characters().position) middle += p / 30.0;
        high = std::max(high, middle.y);
        if (std::fabs(middle.x) < 12.0) aside = std::max(aside, std::fabs(middle.y - 18.0));
    }
    CHECK(done);
    CHECK(high > 17.0);
    CHECK(aside < 2.0);
    CHECK(world.time() < 60.0);  // 76 m at 2 m/s, and the start.
    CHECK(world.group(0).pose.rotation.s == doctest::Approx(-1.0).epsilon(0.01));
}

TEST_CASE("five orders over Berlin, one after the other") {
    std::ifstream file(sourceFolder() + "/../shared/maps/Berlin_0_256.map", std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    if (text.str().empty()) {
        MESSAGE("skipped: Berlin_0_256.map is not here");
        return;
    }
    const auto map = parseMap(text.str());
    REQUIRE(map.ok());
    WorldDef def{.box = {{0, 0}, {256, 256}}, .cell = 0.5, .map = MapGround{*map, {}}};
    GroupDef group{.count = 30};
    def.groups.push_back(group);
    // Free points far apart, by the map.
    const auto freeNear = [&](Vec2 p) {
        for (int reach = 0; reach < 60; ++reach)
            for (int dy = -reach; dy <= reach; ++dy)
                for (int dx = -reach; dx <= reach; ++dx) {
                    const int x = static_cast<int>(p.x) + dx, y = static_cast<int>(p.y) + dy;
                    bool open = true;
                    for (int v = -3; v <= 3; ++v)
                        for (int u = -3; u <= 3; ++u)
                            open = open &&
                                   map->cells[(map->height - 1 - (y + v)) * map->width + x + u] == '.';
                    if (open) return Vec2{x + 0.5, y + 0.5};
                }
        return p;
    };
    def.groups[0].position = freeNear({60, 60});
    for (const Vec2 p : {Vec2{90, 60}, Vec2{100, 100}, Vec2{60, 110}, Vec2{110, 60}, Vec2{60, 60}})
        def.groups[0].orders.push_back(Order::move(freeNear(p)));
    World world = World::create(def).value();
    int done = 0, skipped = 0;
    while (!world.group(0).orders.empty() && world.time() < 900.0) {
        world.step();
        for (const Event& e : world.events()) {
            done += e.kind == EventKind::OrderDone ? 1 : 0;
            skipped += e.kind == EventKind::OrderSkipped ? 1 : 0;
        }
    }
    MESSAGE("five orders over Berlin took " << world.time() << " s");
    CHECK(done == 5);
    CHECK(skipped == 0);
    CHECK(distance(world.group(0).pose.position, def.groups[0].orders.back().target) < 1.0);
}
