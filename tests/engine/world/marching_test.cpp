// Marches: a formation goes along its way in one piece, turns rigidly, and is about as fast as those who go
// freely.
#include <doctest.h>

#include "engine/formation/mesh/rigid_fit.h"
#include "engine/world/inspect.h"
#include "engine/world/world_scenes.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A floor of 120 m x 80 m with a house of 20 m in the middle and 60 people, ten abreast, to the west of it.
WorldDef houseScene(double angle = 0.0) {
    WorldDef def{.box = {{-60, -40}, {60, 40}}, .cell = 0.5, .obstacles = {block(-10, -10, 10, 10)}};
    def.groups.push_back({.count = 60, .formation = {.files = 10}, .position = {-36, 0}, .angle = angle});
    return def;
}

/// Rms distance of characters to the best rigid fit of their places at rest.
double rigidRms(const World& world, std::size_t group = 0) {
    const GroupView view = world.group(group);
    const CharactersView c = world.characters();
    std::vector<Vec2> rest, now;
    for (const std::int32_t i : view.members) {
        if (c.place[i] < 0) continue;
        rest.push_back(view.meshPlaces[c.place[i]].position(copyOf(view.triangles), copyOf(view.restMesh)));
        now.push_back(c.position[i]);
    }
    if (now.empty()) return 0.0;
    const Pose pose = bestRigidFit(rest, now);
    double sum = 0.0;
    for (std::size_t k = 0; k < now.size(); ++k) sum += lengthSquared(pose.apply(rest[k]) - now[k]);
    return std::sqrt(sum / static_cast<double>(now.size()));
}

/// Share of the group that is within 0.5 m of where its place will be at the end.
double arrived(const World& world) {
    const GroupView view = world.group(0);
    const CharactersView c = world.characters();
    int count = 0;
    for (const std::int32_t i : view.members)
        if (c.place[i] >= 0 && distance(c.position[i], view.placeTargets[c.place[i]]) <= 0.5) ++count;
    return count / static_cast<double>(view.members.size());
}

struct Run {
    double seconds = 0.0;
    double worst = 0.0;  ///< Rms on the way [m].
    bool done = false;
};

Run run(const WorldDef& def, const Order& order, double most) {
    World world = World::create(def).value();
    for (int s = 0; s < 60; ++s) world.step();
    tell(world, order);
    Run result;
    const double begun = world.time();
    while (world.time() - begun < most && !result.done) {
        world.step();
        result.worst = std::max(result.worst, rigidRms(world));
        for (const Event& event : world.events())
            result.done = result.done || event.kind == EventKind::OrderDone;
    }
    CHECK(arrived(world) >= 0.95);
    result.seconds = world.time() - begun;
    return result;
}

}  // namespace

TEST_CASE("round a house a march is rigid, and about as fast as people on their own") {
    const Vec2 target{40, 0};
    const Run free = run(houseScene(), Order::go(target, 0.0), 120.0);
    Order keep = Order::move(target, 0.0);
    keep.turn = Turn::Keep;
    const Run kept = run(houseScene(), keep, 120.0);
    Order wheel = Order::move(target);
    wheel.turn = Turn::Wheel;
    const Run wheeled = run(houseScene(), wheel, 120.0);
    MESSAGE("free " << free.seconds << " s, keep " << kept.seconds << " s, rms " << kept.worst << " m, wheel "
                    << wheeled.seconds << " s, rms " << wheeled.worst << " m");
    CHECK(free.done);
    CHECK(kept.done);
    CHECK(wheeled.done);
    CHECK(kept.worst <= 0.5);
    CHECK(wheeled.worst <= 0.5);
    CHECK(kept.seconds <= 1.12 * free.seconds);
    CHECK(wheeled.seconds <= 1.25 * free.seconds);
}

TEST_CASE("half a turn wheels or reverses, and never shrinks") {
    for (const Turn turn : {Turn::Wheel, Turn::Reverse}) {
        WorldDef def = houseScene();
        def.obstacles.clear();
        def.groups[0].position = {0, 0};
        Order back = Order::move({-25, 0});
        back.turn = turn;
        const Run result = run(def, back, 90.0);
        CAPTURE(static_cast<int>(turn));
        MESSAGE("turn " << static_cast<int>(turn) << ": " << result.seconds << " s, rms " << result.worst);
        CHECK(result.done);
        CHECK(result.worst <= 0.3);
    }
    WorldDef def = houseScene();
    def.obstacles.clear();
    Order turn = Order::face(3.1);
    turn.turn = Turn::Wheel;
    const Run face = run(def, turn, 60.0);
    CHECK(face.done);
    CHECK(face.worst <= 0.3);
}
