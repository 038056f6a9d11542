// Scenes of jams: a crowd is drawn through a wall with several passages.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/random.h"
#include "muster/world.h"

namespace muster::testing {

/// A gap in the wall, from one side of it to the other [m].
struct JamPassage {
    Vec2 a, b;

    double width() const { return distance(a, b); }
};

/// A scene, the commands that draw its crowd, and what a bound has to know.
struct JamScene {
    WorldDef def;
    std::vector<Command> commands;
    std::vector<JamPassage> passages;  ///< Across the middle of the wall.
    Vec2 shift;                        ///< From where the crowd stands to its goals [m].
    double start = 0.675;              ///< When the fingers first move [s].
};

inline constexpr double kPlug = 0.3;  ///< Thickness of what walls a passage up [m].

/// The plan of a wall along the y axis, before it is turned.
struct WallPlan {
    double thickness = 1.0;                           // [m]
    std::vector<std::pair<double, double>> openings;  // From and to y [m], ascending.
    Vec2 crowd;                                       // Centre of the crowd [m]; x below 0.
    Vec2 goal;                                        // Centre of its goals [m]; x above 0.
    std::int32_t count = 100;
    Box box;
    bool turned = false;  // Exchanges x and y.
};

inline Vec2 turnedBy(const WallPlan& plan, Vec2 p) {
    return plan.turned ? Vec2{p.y, p.x} : p;
}

inline ObstacleDef wallPart(const WallPlan& plan, double from, double to) {
    const double x = 0.5 * plan.thickness;
    ObstacleDef part{.polygon = {{-x, from}, {x, from}, {x, to}, {-x, to}}};
    for (Vec2& p : part.polygon) p = turnedBy(plan, p);
    if (plan.turned) std::reverse(part.polygon.begin(), part.polygon.end());
    return part;
}

/// Four fingers near the corners of a square of half side `half` draw it within 3 s, as people do.
inline std::vector<Command> drawnBy(const WallPlan& plan, double half, double stepTime) {
    constexpr int kMoves = 40;
    std::vector<Command> commands;
    std::uint32_t sequence = 0;
    const auto give = [&](double time, CommandBody body) {
        const auto step = static_cast<std::uint32_t>(time / stepTime + 1e-9);
        commands.push_back({step, 1, sequence++, std::move(body)});
    };
    const Vec2 corners[] = {{-half, -half}, {half, -half}, {half, half}, {-half, half}};
    const auto at = [&](int finger, int move) {
        return turnedBy(plan,
                        lerp(plan.crowd, plan.goal, static_cast<double>(move) / kMoves) + corners[finger]);
    };
    for (int f = 0; f < 4; ++f)
        give(0.5 + 0.02 * f,
             Touch{TouchPhase::Down, static_cast<std::uint32_t>(f + 1), at(f, 0), 0.5 + 0.02 * f, {}});
    for (int move = 1; move <= kMoves; ++move)
        for (int f = 0; f < 4; ++f) {
            const double time = 0.6 + 0.075 * move + 0.001 * f;
            give(time, Touch{TouchPhase::Move, static_cast<std::uint32_t>(f + 1), at(f, move), time, {}});
        }
    for (int f = 0; f < 4; ++f)
        give(3.8 + 0.001 * f,
             Touch{TouchPhase::Up, static_cast<std::uint32_t>(f + 1), {}, 3.8 + 0.001 * f, {}});
    return commands;
}

/// The scene of a plan. Speeds of mesh and places are those of a fast hand; all else is the default.
inline JamScene sceneOf(const WallPlan& plan) {
    JamScene scene{.def = {.box = {turnedBy(plan, plan.box.min), turnedBy(plan, plan.box.max)}}};
    double from = plan.box.min.y;
    for (const auto& [low, high] : plan.openings) {
        scene.def.obstacles.push_back(wallPart(plan, from, low));
        scene.passages.push_back({turnedBy(plan, {0.0, low}), turnedBy(plan, {0.0, high})});
        from = high;
    }
    scene.def.obstacles.push_back(wallPart(plan, from, plan.box.max.y));
    scene.def.groups = {{.count = plan.count, .position = turnedBy(plan, plan.crowd)}};
    scene.def.parameters.control.speed = scene.def.parameters.place.speed = 8.0;
    scene.def.parameters.opposing.gain = 0.0;
    scene.shift = turnedBy(plan, plan.goal) - turnedBy(plan, plan.crowd);
    const double half = 0.5 * (std::ceil(std::sqrt(static_cast<double>(plan.count))) - 1.0) - 0.1;
    scene.commands = drawnBy(plan, half, scene.def.parameters.stepTime);
    return scene;
}

/// The scene with one passage walled up.
inline JamScene withoutPassage(JamScene scene, std::size_t closed) {
    const JamPassage gap = scene.passages[closed];
    const double half = 0.5 * kPlug;
    const Vec2 across = perpendicular(normalized(gap.b - gap.a)) * half;
    scene.def.obstacles.push_back(
        {.polygon = {gap.a + across, gap.a - across, gap.b - across, gap.b + across}});
    scene.passages.erase(scene.passages.begin() + static_cast<std::ptrdiff_t>(closed));
    return scene;
}

/// A plan with two to four openings of 0.8 to 4 m for 60 to 400 people, one opening about before them.
inline WallPlan randomWallPlan(Random& random) {
    WallPlan plan;
    plan.count = static_cast<std::int32_t>(60 + random.below(341));
    plan.thickness = random.uniform(0.4, 2.0);
    plan.turned = random.below(2) == 1;
    const double side = std::ceil(std::sqrt(static_cast<double>(plan.count)));
    const double near = 0.5 * plan.thickness + 0.5 * side;
    plan.crowd = {-near - random.uniform(3.0, 8.0), random.uniform(-3.0, 3.0)};
    plan.goal = {near + random.uniform(3.0, 8.0), random.uniform(-3.0, 3.0)};
    const std::uint32_t openings = 2 + random.below(3);
    const double width = random.uniform(0.8, 4.0);
    const double middle = plan.crowd.y + random.uniform(-0.3, 0.3) * side;
    plan.openings.push_back({middle - 0.5 * width, middle + 0.5 * width});
    for (std::uint32_t k = 1; k < openings; ++k) {
        const double wide = random.uniform(0.8, 4.0), away = random.uniform(3.0, 10.0);
        if (random.below(2) == 0)
            plan.openings.push_back(
                {plan.openings.back().second + away, plan.openings.back().second + away + wide});
        else
            plan.openings.insert(plan.openings.begin(), {plan.openings.front().first - away - wide,
                                                         plan.openings.front().first - away});
    }
    const double reach = near + 8.0 + 0.5 * side + 3.0;
    plan.box = {{-reach, std::min(plan.openings.front().first, -0.5 * side - 3.0) - 3.0},
                {reach, std::max(plan.openings.back().second, 0.5 * side + 3.0) + 3.0}};
    return plan;
}

}  // namespace muster::testing
