#include "formation/control/trajectory.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Halves a path that has grown too long; the newest point stays the last.
void thin(std::vector<Checkpoint>& path) {
    std::size_t kept = 0;
    for (std::size_t k = 1; k < path.size(); k += 2) path[kept++] = path[k];
    if (path.size() % 2 == 1) path[kept++] = path.back();
    path.resize(kept);
}

// The share of the way from `from` to `to` at which the distance to `anchor` reaches `spacing`;
// `from` is nearer than that, `to` is not.
double shareAtDistance(Vec2 anchor, Vec2 from, Vec2 to, double spacing) {
    const Vec2 start = from - anchor;
    const Vec2 way = to - from;
    const double a = lengthSquared(way);
    if (!(a > 0.0)) return 1.0;
    const double b = dot(start, way);
    const double c = lengthSquared(start) - spacing * spacing;
    const double root = std::sqrt(std::max(0.0, b * b - a * c));
    return std::clamp((root - b) / a, 0.0, 1.0);
}

}  // namespace

void extendPath(ControlPoint& point, Vec2 position, double time, double spacing) {
    std::vector<Checkpoint>& path = point.trajectory;
    if (path.empty()) path.push_back({point.position, time});
    time = std::max(time, path.back().time);
    Checkpoint last = path.back();
    Vec2 anchor = path.size() >= 2 ? path[path.size() - 2].position : point.position;
    path.pop_back();
    // A finger that jumps far in one message must not fill the path: the step grows instead.
    const double step = std::max(spacing, distance(last.position, position) / 256.0);
    while (distance(anchor, position) >= step) {
        const double share = distance(anchor, last.position) >= step
                                 ? 0.0
                                 : shareAtDistance(anchor, last.position, position, step);
        last = {lerp(last.position, position, share), last.time + (time - last.time) * share};
        path.push_back(last);
        anchor = last.position;
        if (share >= 1.0) break;
    }
    path.push_back({position, time});
    if (path.size() > kMaxCheckpoints) thin(path);
}

double clockWithin(const ControlPoint& point, double clock, double until, double reach) {
    Vec2 position = point.position;
    for (const Checkpoint& next : point.trajectory) {
        const double span = std::max(0.0, next.time - clock);
        const double way = distance(position, next.position);
        const double share = next.time > until ? (until - clock) / span : 1.0;
        if (way * share > reach) return std::min(until, clock + span * (reach / way));
        if (next.time > until) return until;
        reach -= way;
        position = next.position;
        clock = std::max(clock, next.time);
    }
    return until;
}

void followPath(ControlPoint& point, double clock, double until, double reach) {
    std::size_t passed = 0;
    for (const Checkpoint& next : point.trajectory) {
        const double way = distance(point.position, next.position);
        if (next.time > until) {
            const double share = std::clamp((until - clock) / (next.time - clock), 0.0, 1.0);
            const double allowed = way > 0.0 ? std::min(share, reach / way) : share;
            point.position = lerp(point.position, next.position, allowed);
            break;
        }
        if (way > reach * (1.0 + 1e-12)) {
            point.position = lerp(point.position, next.position, reach / way);
            break;
        }
        reach = std::max(0.0, reach - way);
        point.position = next.position;
        clock = std::max(clock, next.time);
        ++passed;
    }
    point.trajectory.erase(point.trajectory.begin(),
                           point.trajectory.begin() + static_cast<std::ptrdiff_t>(passed));
}

}  // namespace muster
