// Worlds turned and mirrored: what holds on some ground must hold however it lies.
#pragma once

#include <algorithm>
#include <cmath>

#include "muster/world.h"

namespace muster::testing {

/// How ground lies: mirrored in the x axis or not, then turned about the origin.
struct Lie {
    double angle = 0.0;  ///< [rad]
    bool mirrored = false;

    Vec2 operator()(Vec2 p) const {
        const Vec2 q{p.x, mirrored ? -p.y : p.y};
        const double c = std::cos(angle), s = std::sin(angle);
        return {c * q.x - s * q.y, s * q.x + c * q.y};
    }
    /// Where a point of this ground would lie if it were neither turned nor mirrored.
    Vec2 back(Vec2 p) const {
        const double c = std::cos(angle), s = std::sin(angle);
        const Vec2 q{c * p.x + s * p.y, c * p.y - s * p.x};
        return {q.x, mirrored ? -q.y : q.y};
    }
    double heading(double a) const { return (mirrored ? -a : a) + angle; }
};

/// As it lies, turned by a right angle, and mirrored and turned by an odd one.
inline constexpr Lie kLies[] = {{}, {1.5707963267948966, false}, {0.37, true}};

/// A world as it would lie; walls keep people in what was its box.
inline WorldDef turned(WorldDef def, const Lie& lie) {
    const auto turnAll = [&](std::vector<Vec2>& points) {
        for (Vec2& p : points) p = lie(p);
        if (lie.mirrored) std::reverse(points.begin(), points.end());
    };
    const auto turnPath = [&](TimedPath& path) {
        for (Waypoint& waypoint : path.waypoints) {
            waypoint.position = lie(waypoint.position);
            if (lie.mirrored) waypoint.angle = -waypoint.angle;
        }
    };
    const auto [x0, y0] = def.box.min;
    const auto [x1, y1] = def.box.max;
    for (const Polygon& edge : {Polygon{{x0 - 1, y0 - 1}, {x1 + 1, y0 - 1}, {x1 + 1, y0}, {x0 - 1, y0}},
                                Polygon{{x0 - 1, y1}, {x1 + 1, y1}, {x1 + 1, y1 + 1}, {x0 - 1, y1 + 1}},
                                Polygon{{x0 - 1, y0}, {x0, y0}, {x0, y1}, {x0 - 1, y1}},
                                Polygon{{x1, y0}, {x1 + 1, y0}, {x1 + 1, y1}, {x1, y1}}})
        def.obstacles.push_back({.polygon = edge});
    for (ObstacleDef& obstacle : def.obstacles) {
        turnAll(obstacle.polygon);
        obstacle.centre = lie(obstacle.centre);
        turnPath(obstacle.path);
    }
    for (PatchDef& patch : def.patches) {
        turnAll(patch.polygon);
        turnPath(patch.path);
    }
    for (GroupDef& group : def.groups) {
        group.position = lie(group.position);
        group.angle = lie.heading(group.angle);
        for (Vec2& start : group.starts) start = lie(start);
        for (Vec2& p : group.formation.points) p.y = lie.mirrored ? -p.y : p.y;
        for (Order& order : group.orders) {
            order.target = lie(order.target);
            if (order.facing) order.facing = lie.heading(*order.facing);
        }
    }
    Box box{lie({x0 - 1, y0 - 1}), lie({x0 - 1, y0 - 1})};
    for (const Vec2 corner : {Vec2{x1 + 1, y0 - 1}, Vec2{x0 - 1, y1 + 1}, Vec2{x1 + 1, y1 + 1}}) {
        const Vec2 p = lie(corner);
        box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
        box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
    }
    def.box = box;
    return def;
}

}  // namespace muster::testing
