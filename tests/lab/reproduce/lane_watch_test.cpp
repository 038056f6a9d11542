// Who crosses a line, in which lane and when: cases worked out by hand.
#include "lab/reproduce/experiments/lane_watch.h"

#include <doctest.h>

#include <cmath>

using namespace muster;

namespace {

// Characters that stand at these points and are drawn to others, one group each, in the open.
WorldDef walkers(const std::vector<std::pair<Vec2, Vec2>>& ways) {
    WorldDef def;
    for (const auto& [from, to] : ways) def.groups.push_back({.count = 1, .position = to, .starts = {from}});
    return def;
}

}  // namespace

TEST_CASE("lanes between borders") {
    const World world = *World::create(walkers({{{-4, 0}, {-4, 0}}}));
    const LaneWatch watch(0.0, {-2.0, 1.0}, world);
    CHECK(watch.laneAt(-9.0) == 0);
    CHECK(watch.laneAt(-2.0) == 1);
    CHECK(watch.laneAt(0.9) == 1);
    CHECK(watch.laneAt(1.0) == 2);
    CHECK(watch.laneAt(50.0) == 2);
    CHECK(watch.lanes() == std::vector<std::int32_t>{-1});
    CHECK(std::isnan(watch.lastCrossing()));
}

TEST_CASE("a crossing counts from left to right, in its lane and at its time") {
    // The third walks the other way, the fourth stays before the line; the second comes from far away.
    World world = *World::create(
        walkers({{{-2, 3}, {4, 3}}, {{-6, -3}, {4, -3}}, {{3, 0}, {-3, 0}}, {{-9, 0}, {-8, 0}}}));
    LaneWatch watch(0.0, {-1.0, 1.0}, world);
    double first = -1.0, second = -1.0;
    while (world.time() < 8.0) {
        const std::span<const Vec2> then = world.characters().position;
        const std::vector<Vec2> before(then.begin(), then.end());
        world.step();
        watch.observe(world);
        const std::span<const Vec2> now = world.characters().position;
        // The expected counts of this step, computed again.
        std::vector<std::size_t> crossed;
        for (std::size_t i = 0; i < now.size(); ++i)
            if (before[i].x < 0.0 && now[i].x >= 0.0) crossed.push_back(i);
        CHECK(watch.crossedNow() == crossed);
        if (first < 0.0 && now[0].x >= 0.0) first = world.time();
        if (second < 0.0 && now[1].x >= 0.0) second = world.time();
    }
    CHECK(watch.lanes() == std::vector<std::int32_t>{2, 0, -1, -1});
    CHECK(watch.count(0) == 1);
    CHECK(watch.count(1) == 0);
    CHECK(watch.count(-1) == 2);
    CHECK(std::isnan(watch.lastCrossing()));
    CHECK(first > 0.9);
    CHECK(second > first);
}

TEST_CASE("the last crossing of all") {
    World world = *World::create(walkers({{{-1, 0}, {4, 0}}, {{-5, 2}, {4, 2}}}));
    LaneWatch watch(0.0, {1.0}, world);
    double last = 0.0;
    while (world.time() < 6.0) {
        world.step();
        watch.observe(world);
        if (last == 0.0 && world.characters().position[1].x >= 0.0) last = world.time();
    }
    CHECK(watch.lastCrossing() == last);
    CHECK(last > 2.4);  // 5 m at 2 m/s and a start from rest.
}
