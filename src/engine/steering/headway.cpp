#include "engine/steering/headway.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kHeadway = 0.3;  // Time that the one behind keeps from the one ahead [s].
constexpr double kInStep = 1.0;   // Share of the speed ahead that the one behind may have on top: 1 in step.
constexpr double kContactTime = 0.1;  // Time within which two who meet share what closes their gap [s].
constexpr double kToTheRight = 0.25;  // Tangent by which who meet pass each other on the right.
constexpr double kBeside = 0.1;       // Two who go the same way are side by side below this lead.
constexpr double kSlack = 1.0;        // A limit this far from being reached is left out [m/s].
constexpr double kPenetration = 0.2;  // Share of an overlap that is taken back in a step.
constexpr double kWallReach = 0.3;    // Walls beyond this gap are left out [m].
constexpr int kSweeps = 8;

double gapSpeed(double gap, double time, double dt) {
    return gap > 0.0 ? gap / time : gap / dt * kPenetration;
}

bool differ(Vec2 a, Vec2 b) {
    return dot(a, b) <= 0.0;
}

}  // namespace

bool Headway::meets(const NeighbourList& neighbours, std::span<const Vec2> wanted) {
    for (const NeighbourPair pair : neighbours.pairs()) {
        const Vec2 a = wanted[pair.low], b = wanted[pair.high];
        if (differ(a, b) && !(a == Vec2{} && b == Vec2{})) return true;
    }
    return false;
}

void Headway::addPair(const CrowdBodies& bodies, const Characters& now, NeighbourPair pair,
                      const HeadwayInput& input, std::span<const Vec2> velocity) {
    const std::int32_t a = pair.low, b = pair.high;
    const Vec2 between = now.position[b] - now.position[a];
    const double apart = length(between);
    const double gap = apart - bodies.touching(a, b);
    const Vec2 towards = apart > 1e-9 ? between / apart : Vec2{1.0, 0.0};
    const bool fixedA = bodies.isFixed(a), fixedB = bodies.isFixed(b);
    if (fixedA && fixedB) return;
    const auto add = [&](std::int32_t back, std::int32_t front, Vec2 n) {
        const double most = gapSpeed(gap, kHeadway, input.dt), ahead = dot(velocity[front], n);
        const double limit = most + (ahead > 0.0 ? kInStep * ahead : ahead);
        if (dot(velocity[back], n) > limit - kSlack) limits_.push_back({back, front, n, most, 1.0, kInStep});
    };
    if (fixedA || bodies.isFirmer(a, b)) return add(b, a, -towards);
    if (fixedB || bodies.isFirmer(b, a)) return add(a, b, towards);
    if (!differ(input.wanted[a], input.wanted[b])) {
        const double topA = std::max(input.topSpeed[a], 1e-9), topB = std::max(input.topSpeed[b], 1e-9);
        const double lead = dot(towards, input.wanted[a] / topA + input.wanted[b] / topB);
        const bool bAhead = std::fabs(lead) > kBeside    ? lead > 0.0
                            : now.cost[a] != now.cost[b] ? now.cost[b] < now.cost[a]
                                                         : false;
        return bAhead ? add(a, b, towards) : add(b, a, -towards);
    }
    if (input.right == nullptr) return;
    const Vec2 tilted = gap > 0.02 ? normalized(towards + perpendicular(towards) * kToTheRight) : towards;
    input.right->precedes(a, b) ? add(b, a, -tilted) : add(a, b, tilted);
    const double most = gapSpeed(gap, kContactTime, input.dt);
    if (dot(velocity[a] - velocity[b], towards) > most - kSlack)
        limits_.push_back({a, b, towards, most, bodies.share(a, b), -1.0});
}

void Headway::addWall(std::int32_t character, Vec2 towards, double gap, Vec2 wallVelocity, double dt,
                      Vec2 velocity) {
    const double most = dot(wallVelocity, towards) + (gap > 0.0 ? gap / dt : gap / dt * kPenetration);
    if (dot(velocity, towards) > most - kSlack) limits_.push_back({character, -1, towards, most, 1.0, 0.0});
}

void Headway::addWalls(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                       const HeadwayInput& input, std::span<const Vec2> velocity) {
    nearObstacle_.resize(now.size());
    environment.markNearObstacles(now.position, bodies.largestRadius() + kWallReach, nearObstacle_);
    const Box box = environment.def().box;
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (nearObstacle_[i] == 0 || bodies.isFixed(i)) continue;
        const auto character = static_cast<std::int32_t>(i);
        const Vec2 here = now.position[i];
        const double radius = bodies.radius(i), reach = radius + kWallReach;
        environment.forPiecesNear(here, reach, [&](const ObstaclePiece& piece) {
            const SurfacePoint nearest = closestSurfacePoint(piece, here);
            if (nearest.distance > reach || nearest.distance < 1e-6) return;
            const Vec2 towards = (nearest.point - here) / nearest.distance;
            addWall(character, towards, nearest.distance - radius, piece.velocity, input.dt, velocity[i]);
        });
        addWall(character, {-1.0, 0.0}, here.x - box.min.x - radius, {}, input.dt, velocity[i]);
        addWall(character, {1.0, 0.0}, box.max.x - here.x - radius, {}, input.dt, velocity[i]);
        addWall(character, {0.0, -1.0}, here.y - box.min.y - radius, {}, input.dt, velocity[i]);
        addWall(character, {0.0, 1.0}, box.max.y - here.y - radius, {}, input.dt, velocity[i]);
    }
}

void Headway::run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                  const NeighbourList& neighbours, const HeadwayInput& input, std::span<Vec2> velocity) {
    limits_.clear();
    for (const NeighbourPair pair : neighbours.pairs()) addPair(bodies, now, pair, input, velocity);
    addWalls(bodies, now, environment, input, velocity);
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
        for (Limit& limit : limits_) {
            Vec2& back = velocity[limit.back];
            const Vec2 n = limit.towards;
            double most = limit.most, overshoot = dot(back, n);
            const bool shared = limit.follow < 0.0;
            if (limit.front >= 0) {
                const double ahead = dot(velocity[limit.front], n);
                most += shared ? ahead : ahead > 0.0 ? limit.follow * ahead : ahead;
            }
            overshoot -= most;
            const double pressed = std::max(0.0, limit.pressed + overshoot);
            const double change = pressed - limit.pressed;
            limit.pressed = pressed;
            back -= n * (change * limit.share);
            if (shared) velocity[limit.front] += n * (change * (1.0 - limit.share));
        }
    }
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!bodies.isFixed(i)) velocity[i] = clampLength(velocity[i], input.topSpeed[i]);
}

}  // namespace muster
