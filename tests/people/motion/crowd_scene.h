// Worlds for tests of motion, and one way to run them.
#pragma once

#include <doctest.h>

#include <functional>

#include "muster/motion.h"
#include "muster/world.h"
#include "people/motion/motion_report.h"

namespace muster::testing {

/// A wide floor with one square crowd at the origin.
inline WorldDef field(std::int32_t count) {
    return {.box = {{-16, -16}, {30, 16}}, .groups = {{.name = "crowd", .count = count, .jitter = 0.1}}};
}

/// A finger that takes the crowd by one point and carries it over, beginning at the world's time.
inline void carry(World& world, Vec2 from, Vec2 to) {
    std::uint32_t sequence = 1000;
    const auto submit = [&](CommandBody body, std::uint32_t step) {
        Command command{.step = step, .sequence = ++sequence, .body = std::move(body)};
        const Status status = world.submit(command);
        MUSTER_ASSERT(status.ok());
    };
    const std::uint32_t start = world.stepCount() + 60;
    const double dt = world.parameters().stepTime;
    submit(Touch{TouchPhase::Down, 1, from, start * dt, {}}, start);
    const int moves = static_cast<int>(distance(from, to) / 0.04);
    for (int k = 1; k <= moves; ++k)
        submit(
            Touch{TouchPhase::Move, 1, lerp(from, to, static_cast<double>(k) / moves), (start + k) * dt, {}},
            start + static_cast<std::uint32_t>(k));
    submit(Touch{TouchPhase::Up, 1, {}, (start + moves + 10) * dt, {}},
           start + static_cast<std::uint32_t>(moves) + 10);
}

/// Steps world and motion for some time [s], observed.
inline void run(World& world, CrowdMotion& motion, MotionReport& report, double seconds,
                const std::function<void()>& look = {}) {
    const double end = world.time() + seconds;
    while (world.time() < end - 1e-9) {
        world.step();
        motion.update(world);
        report.observe(world, motion);
        if (look) look();
    }
}

/// Feet stand still where they touch, knees turn smoothly, and nothing is in the floor.
inline void checkFeet(const MotionFigures& f) {
    CHECK(f.slideMedian <= 0.005);
    CHECK(f.slide95 <= 0.02);
    CHECK(f.knee999 <= 20.0);
    CHECK(f.kneeMax < 20.05);
    CHECK(f.penetration <= 0.01);
    MESSAGE("measured: slide median ", 100 * f.slideMedian, " cm, 95 in 100 ", 100 * f.slide95, " cm, knee ",
            f.knee999, " rad/s, depth ", 100 * f.penetration, " cm");
}

}  // namespace muster::testing
