#include "engine/formation/control/control_points.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

// Drops every second checkpoint; the newest point stays the last.
void thin(std::vector<Checkpoint>& trajectory) {
    std::size_t count = 0;
    for (std::size_t k = 1; k < trajectory.size(); k += 2) trajectory[count++] = trajectory[k];
    if (trajectory.size() % 2 == 1) trajectory[count++] = trajectory.back();
    trajectory.resize(count);
}

// The share of the segment from `from` to `to` at which the distance to `anchor` reaches `spacing`. `from` is
// nearer than that, `to` is not.
double shareAtDistance(Vec2 anchor, Vec2 from, Vec2 to, double spacing) {
    const Vec2 start = from - anchor;
    const Vec2 segment = to - from;
    const double a = lengthSquared(segment);
    if (!(a > 0.0)) return 1.0;
    const double b = dot(start, segment);
    const double c = lengthSquared(start) - spacing * spacing;
    const double discriminant = std::sqrt(std::max(0.0, b * b - a * c));
    return std::clamp((discriminant - b) / a, 0.0, 1.0);
}

}  // namespace

void extendTrajectory(ControlPoint& point, Vec2 position, double time, double spacing) {
    std::vector<Checkpoint>& trajectory = point.trajectory;
    if (trajectory.empty()) trajectory.push_back({point.position, time});
    time = std::max(time, trajectory.back().time);
    Checkpoint last = trajectory.back();
    Vec2 anchor = trajectory.size() >= 2 ? trajectory[trajectory.size() - 2].position : point.position;
    trajectory.pop_back();
    // A finger that jumps far in one message must not fill the trajectory, so the step grows.
    const double step = std::max(spacing, distance(last.position, position) / 256.0);
    while (distance(anchor, position) >= step) {
        const double share = distance(anchor, last.position) >= step
                                 ? 0.0
                                 : shareAtDistance(anchor, last.position, position, step);
        last = {lerp(last.position, position, share), last.time + (time - last.time) * share};
        trajectory.push_back(last);
        anchor = last.position;
        if (share >= 1.0) break;
    }
    trajectory.push_back({position, time});
    if (trajectory.size() > kMaxCheckpoints) thin(trajectory);
}

double latestReachable(const ControlPoint& point, double clock, double until, double reach) {
    Vec2 position = point.position;
    for (const Checkpoint& next : point.trajectory) {
        const double span = std::max(0.0, next.time - clock);
        const double length = distance(position, next.position);
        const double share = next.time > until ? (until - clock) / span : 1.0;
        if (length * share > reach) return std::min(until, clock + span * (reach / length));
        if (next.time > until) return until;
        reach -= length;
        position = next.position;
        clock = std::max(clock, next.time);
    }
    return until;
}

void followTrajectory(ControlPoint& point, double clock, double until, double reach) {
    std::size_t passed = 0;
    for (const Checkpoint& next : point.trajectory) {
        const double length = distance(point.position, next.position);
        if (next.time > until) {
            const double share = std::clamp((until - clock) / (next.time - clock), 0.0, 1.0);
            const double allowed = length > 0.0 ? std::min(share, reach / length) : share;
            point.position = lerp(point.position, next.position, allowed);
            break;
        }
        if (length > reach * (1.0 + 1e-12)) {
            point.position = lerp(point.position, next.position, reach / length);
            break;
        }
        reach = std::max(0.0, reach - length);
        point.position = next.position;
        clock = std::max(clock, next.time);
        ++passed;
    }
    point.trajectory.erase(point.trajectory.begin(),
                           point.trajectory.begin() + static_cast<std::ptrdiff_t>(passed));
}

}  // namespace muster
