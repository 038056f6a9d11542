// Marches that flow against what can be reckoned, and over scenes: times, distances, free ground, exact ends.
#include "engine/orders/stream.h"

#include <doctest.h>

#include "engine/orders/stream_scenes.h"
#include "engine/orders/stream_ways.h"

using namespace muster;
using namespace muster::stream_scenes;

namespace {

/// Free ground of any size.
constexpr auto open = [](Vec2) { return 50.0; };

/// What holds for every planned march.
void checkEnds(const Task& task, const Stream& stream) {
    Points places(task.starts.size());
    stream.at(0.0, places);
    for (std::size_t i = 0; i < places.size(); ++i) CHECK(distance(places[i], task.starts[i]) < 1e-9);
    CHECK(largestMove(stream, 0.0, 1e-9) < 1e-4);
    stream.at(1.0, places);
    for (std::size_t i = 0; i < places.size(); ++i) CHECK(distance(places[i], task.ends[i]) < 1e-9);
    CHECK(largestMove(stream, 1.0 - 1e-9, 1e-9) < 1e-4);
}

struct Bounds {
    double seconds = 0.0;  ///< At most [s].
    double nearest = 0.5;  ///< At least [m].
};

void checkScene(const Scene& scene, const Bounds& bounds) {
    CAPTURE(scene.name);
    Stream stream;
    const Played played = best(scene, stream);
    REQUIRE(played.status != StreamStatus::Blocked);
    CHECK(played.finite);
    CHECK(played.seconds <= bounds.seconds);
    CHECK(played.seconds >= played.bound - 0.2);
    CHECK(played.nearest >= bounds.nearest);
    CHECK(played.fastest <= kSpeed * 1.001);
    CHECK(played.room >= -0.01);
    for (int k = 0; k < 50; ++k) CHECK(largestMove(stream, k / 50.0, 1e-7) < 0.005);
}

}  // namespace

TEST_CASE("on open ground places go straight, all at once") {
    const Points block10 = block(10, 10);
    Task task{block10, block10, moved(block10, {40, 0}), {{0, 0}, {40, 0}}};
    Stream stream;
    CHECK(plan(stream, task.def(), open) == StreamStatus::Straight);
    Points places(100);
    for (const double q : {0.1, 0.37, 0.9}) {
        stream.at(q, places);
        for (std::size_t i = 0; i < 100; ++i)
            CHECK(distance(places[i], block10[i] + Vec2{40 * q, 0}) < 1e-12);
    }
}

TEST_CASE("a line of 60 that faces about arrives after the plain walk") {
    const Points line = block(1, 60);
    Scene scene{"about", {rect(-120, -120, 120, 120), {}}, line, line, {-40, 0}, 20.0};
    Stream stream;
    const Played played = best(scene, stream);
    CHECK(played.seconds <= 20.2);
    CHECK(played.nearest >= 0.99);
}

TEST_CASE("where the ground is as wide as the formation a stream is the rigid formation") {
    // A wall far ahead of one file keeps the march from being straight; before it nothing changes.
    const Ground ground{rect(0, 0, 120, 40), {rect(100, 23, 101, 40)}};
    const Points shape = block(4, 6);
    Task task{shape, moved(shape, {10, 20}), moved(shape, {115, 22}), {{10, 20}, {115, 22}}};
    task.way = {{10, 20}, {115, 20}};
    task.ends = moved(shape, {115, 20});
    Stream stream;
    const auto room = [&](Vec2 p) { return ground.room(p); };
    if (plan(stream, task.def(), room) == StreamStatus::Straight) {
        task.starts = moved(shape, {10, 21});
        task.ends = moved(shape, {115, 21});
        task.way = {{10, 21}, {115, 21}};
        plan(stream, task.def(), room);
    }
    REQUIRE(stream.status() == StreamStatus::Flowing);
    Points places(shape.size());
    for (int k = 0; k <= 60; ++k) {
        stream.at(k / 100.0, places);
        for (std::size_t i = 1; i < shape.size(); ++i)
            CHECK(distance(places[i] - places[0], shape[i] - shape[0]) < 1e-9);
    }
    checkEnds(task, stream);
}

TEST_CASE("marches among walls arrive in time, keep apart and stay on free ground") {
    checkScene(corner(15.6), {13.6, 0.7});
    checkScene(corner(32.2), {2.0, 0.7});
    checkScene(roundHouse(), {16.5, 0.6});
    checkScene(beside(22.2, 28.2), {26.0, 0.9});
    checkScene(beside(19, 25), {28.0, 0.65});
    checkScene(door(1), {78.0, 0.45});
    checkScene(door(2), {68.0, 0.55});
    checkScene(door(5), {60.0, 0.6});
    checkScene(street(), {142.0, 0.4});
    checkScene(gap(wedge(8)), {30.0, 0.55});
    checkScene(gap(ring(40)), {31.0, 0.45});
    checkScene(narrow(), {28.5, 0.75});
    checkScene(pillar(), {27.5, 0.95});
    checkScene(edge(), {20.3, 0.9});
    checkScene(gates(5, 2, 6, 0), {24.5, 0.6});
    checkScene(gates(5, 2, 6, 3), {28.5, 0.4});
    checkScene(gates(6, 2, 4, 0), {24.0, 0.6});
}

TEST_CASE("where the ground narrows places come as near to each other as they may, and pass sooner") {
    for (const double width : {1.0, 2.0, 5.0}) {
        Scene scene = door(width);
        scene.shape = block(10, 10);
        scene.start = moved(scene.shape, middleOf(scene.start));
        const Task task = taskOf(scene, true);
        const auto ground = [&](Vec2 p) { return scene.ground.room(p); };
        CAPTURE(width);
        Stream stream;
        StreamDef def = task.def();
        plan(stream, def, ground);
        const Played apart = play(scene.ground, task, stream);
        def.closest = 0.7;
        REQUIRE(plan(stream, def, ground) == StreamStatus::Flowing);
        const Played close = play(scene.ground, task, stream);
        CHECK(close.seconds - close.bound < 0.75 * (apart.seconds - apart.bound));
        CHECK(close.seconds >= close.bound);
        CHECK(close.nearest >= 0.7 * 0.5);
        CHECK(close.room >= -0.01);
        // More room than the formation has is none to come nearer by.
        def.closest = 2.0;
        plan(stream, def, ground);
        CHECK(play(scene.ground, task, stream).seconds == apart.seconds);
    }
}

TEST_CASE("of a march straight on and one along its way the one that arrives first is marched") {
    StreamWays ways;
    Stream on, round;
    for (const Scene& scene : {posts(5, 2.0, block(5, 12)), gates(6, 2, 4, 0), gates(5, 2, 6, 3), pillar()}) {
        CAPTURE(scene.name);
        const Task task = taskOf(scene, false);
        const auto ground = [&](Vec2 p) { return scene.ground.room(p); };
        REQUIRE(plan(ways, task.def(), ground) == StreamStatus::Flowing);
        REQUIRE(task.way.size() > 2);
        const double seconds = play(scene.ground, task, ways.best()).seconds;
        CHECK(seconds == doctest::Approx(ways.best().length() / kSpeed).epsilon(0.12));
        StreamDef def = task.def();
        def.drawn = def.measured = true;
        plan(round, def, ground);
        const Points straight{task.way.front(), task.way.back()};
        def.way = straight;
        plan(on, def, ground);
        double least = 1e9;
        for (const Stream* plan : {&on, &round})
            if (plan->status() == StreamStatus::Flowing) least = std::min(least, plan->length());
        CHECK(ways.best().length() <= 1.001 * std::max(least, distance(task.way.front(), task.way.back())));
        // In slices it comes to the same.
        ways.start(task.def());
        while (ways.advance(ground, 1000) == StreamStatus::Planning) {
        }
        CHECK(play(scene.ground, task, ways.best()).seconds == seconds);
    }
}

TEST_CASE("a drawn way is the only one, and where straight on is a wall the way is marched") {
    const Scene scene = posts(5, 2.0, block(5, 12));
    const auto ground = [&](Vec2 p) { return scene.ground.room(p); };
    Task task = taskOf(scene, true);
    task.way = {task.way.front(), {0, -15}, task.way.back()};
    StreamDef def = task.def();
    StreamWays ways;
    REQUIRE(plan(ways, def, ground) == StreamStatus::Flowing);
    CHECK(play(scene.ground, task, ways.best()).seconds < 20.0);
    def.drawn = true;
    REQUIRE(plan(ways, def, ground) == StreamStatus::Flowing);
    CHECK(play(scene.ground, task, ways.best()).seconds > 20.0);
    const Ground walled{rect(-40, -40, 40, 40), {rect(-0.5, -8, 0.5, 40)}};
    def.drawn = false;
    REQUIRE(plan(ways, def, [&](Vec2 p) { return walled.room(p); }) == StreamStatus::Flowing);
    CHECK(play(walled, task, ways.best()).seconds > 20.0);
}

TEST_CASE("a stream is the same forwards, backwards and planned again in slices") {
    const Scene scene = door(2);
    const Task task = taskOf(scene, true);
    const auto ground = [&](Vec2 p) { return scene.ground.room(p); };
    Stream whole, sliced;
    REQUIRE(plan(whole, task.def(), ground) == StreamStatus::Flowing);
    plan(sliced, taskOf(beside(19, 25), true).def(), ground);
    sliced.start(task.def());
    int slices = 0;
    while (sliced.advance(ground, 500) == StreamStatus::Planning) ++slices;
    CHECK(slices > 10);
    CHECK(sliced.operations() == whole.operations());
    Points a(task.starts.size()), b(a);
    for (int k = 0; k <= 40; ++k) {
        whole.at(k / 40.0, a);
        sliced.at(k / 40.0, b);
        CHECK(a == b);
    }
    for (int k = 40; k >= 0; --k) {
        whole.at(k / 40.0, b);
        whole.at(k / 40.0, a);
        CHECK(a == b);
    }
}

TEST_CASE("each place has its own top speed where they differ, and nine in ten keep to it") {
    const Scene scene = narrow();
    const Task task = taskOf(scene, true);
    Stream stream;
    plan(stream, task.def(), [&](Vec2 p) { return scene.ground.room(p); });
    std::vector<double> speeds(task.starts.size(), 2.0);
    for (std::size_t i = 0; i < speeds.size(); i += 5) speeds[i] = 1.0;
    Points places(task.starts.size());
    stream.at(0.0, places);
    double q = 0.0, seconds = 0.0, rate = 0.0;
    for (; q < 1.0 && seconds < 100.0; seconds += kSceneStep) {
        const Points before = places;
        q = stream.next(q, kSceneStep, speeds, places, rate);
        std::size_t faster = 0;
        for (std::size_t i = 0; i < places.size(); ++i)
            faster += distance(before[i], places[i]) > speeds[i] * kSceneStep * 1.001 ? 1 : 0;
        REQUIRE(faster <= places.size() / 10);
    }
    CHECK(q == 1.0);
    CHECK(seconds > 50.0);
}

TEST_CASE("what cannot flow is told") {
    const Points shape = block(3, 3);
    const Ground closed{rect(0, 0, 60, 20), {rect(30, 0, 31, 20)}};
    Task task{shape, moved(shape, {10, 10}), moved(shape, {50, 10}), {{10, 10}, {50, 10}}};
    Stream stream;
    CHECK(plan(stream, task.def(), [&](Vec2 p) { return closed.room(p); }) == StreamStatus::Blocked);
    task.ends.pop_back();
    CHECK(plan(stream, task.def(), open) == StreamStatus::Blocked);
    task.ends.push_back({std::nan(""), 0.0});
    CHECK(plan(stream, task.def(), open) == StreamStatus::Blocked);
    task = {{}, {}, {}, {{0, 0}, {1, 0}}};
    CHECK(plan(stream, task.def(), open) == StreamStatus::Blocked);
}

TEST_CASE("random scenes: finite, free, bounded speed, exact ends, no jumps") {
    int flowing = 0, apart = 0;
    for (std::uint64_t seed = 1; seed <= 300; ++seed) {
        const Scene scene = random(seed);
        if (scene.start.size() != scene.shape.size()) continue;
        const Task task = taskOf(scene, false);
        if (task.starts.empty() || task.starts.size() != task.offsets.size()) continue;
        Stream stream;
        if (plan(stream, task.def(), [&](Vec2 p) { return scene.ground.room(p); }) == StreamStatus::Blocked)
            continue;
        CAPTURE(seed);
        checkEnds(task, stream);
        const Played played = play(scene.ground, task, stream);
        CHECK(played.finite);
        CHECK(played.fastest <= kSpeed * 1.001);
        CHECK(played.seconds < 200.0);
        CHECK(played.room >= -0.015);
        if (stream.status() != StreamStatus::Flowing) continue;
        ++flowing;
        apart += played.nearest >= 0.5 ? 1 : 0;
        for (int k = 0; k < 20; ++k) CHECK(largestMove(stream, k / 20.0, 1e-7) < 0.01);
    }
    CHECK(flowing >= 80);
    CHECK(apart >= 0.6 * flowing);
}
