#include "engine/steering/headway.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/steering/lane.h"

namespace muster {
namespace {

// Progress from which on an agent that meets another takes its whole share.
constexpr double kFreeProgress = 0.6;
constexpr double kRightTangent = 0.25;  // Tangent by which two agents that meet pass each other on the right.
// Half the cosine from which on one of two agents that go the same way is ahead.
constexpr double kFrontCosine = 0.5;
// Distance of a velocity from a limit beyond which the limit is left out [m/s]...
constexpr double kLimitSlack = 0.3;
constexpr double kSlackTime = 1.0;               // ... for a time ahead up to this [s].
constexpr double kPenetrationShare = 0.2;        // Share of an overlap that is taken back in a step.
constexpr double kWallReach = 0.3;               // Gap beyond which walls are left out [m].
constexpr std::size_t kPairsPerCharacter = 16;   // Reserved number of pairs per character.
constexpr std::size_t kLimitsPerCharacter = 16;  // Reserved number of limits per character.
constexpr int kSweeps = 8;
constexpr double kSweepChange = 1e-3;  // Change of a limit below which a sweep is the last [m/s].

double gapSpeed(double gap, double time, double dt) {
    return gap > 0.0 ? gap / time : gap / dt * kPenetrationShare;
}

// True where no limit of two agents for `ahead` [s] is near, whatever the direction of their closing
// velocity. The result is as good as random, so there is no branch.
bool isApartFor(double ahead, double gap, Vec2 closing) {
    const double near = gap - kLimitSlack * kSlackTime;
    return (static_cast<int>(near > 0.0) &
            static_cast<int>(near * near > ahead * ahead * lengthSquared(closing))) != 0;
}

bool differ(Vec2 a, Vec2 b) {
    return dot(a, b) <= 0.0;
}

// The half-plane of closing velocities nearest to `closing` that keeps two agents clear of each other for the
// time `ahead` [s] (optimal reciprocal collision avoidance, van den Berg et al. 2011), with a bias to pass on
// the right. If `turns`, the agents keep clear by the side alone.
Tangent tangentOf(const Apart& two, Vec2 closing, double ahead, bool turns, double dt) {
    const double apart = two.distance, touching = two.touching;
    if (apart <= touching) return {two.towards, gapSpeed(apart - touching, ahead, dt)};
    const Vec2 beyond = closing - two.between / ahead;
    const double along = dot(beyond, two.between);
    if (!turns && along < 0.0 && along * along > touching * touching * lengthSquared(beyond)) {
        const Vec2 n = -normalized(beyond);
        return {n, (dot(n, two.between) - touching) / ahead};
    }
    const double tangent = std::sqrt(apart * apart - touching * touching);
    const bool left = cross(two.between, beyond) > kRightTangent * apart * length(beyond);
    return {(two.towards * touching - perpendicular(two.towards) * (left ? tangent : -tangent)) / apart, 0.0};
}

}  // namespace

// Limits the agent at the back by its headway; `queues`: both go the same way.
void Headway::follow(std::int32_t back, std::int32_t front, Vec2 towards, double gap, bool queues,
                     std::span<const Vec2> velocity) {
    const double most = gapSpeed(gap, bodies_->headway(back), dt_), ahead = dot(velocity[front], towards);
    const double limit = most + (ahead > 0.0 ? inStep_ * ahead : ahead);
    if (dot(velocity[back], towards) > limit - kLimitSlack)
        limits_.push_back({back, front, towards, most, 1.0, inStep_, queues});
}

// Adds a limit that both agents share; `ahead`: the time for which they keep clear [s].
void Headway::share(NeighbourPair pair, double own, const Tangent& tangent, double ahead,
                    std::span<const Vec2> velocity) {
    const double slack = kLimitSlack * std::min(1.0, kSlackTime / ahead);
    if (dot(velocity[pair.low] - velocity[pair.high], tangent.towards) > tangent.most - slack)
        limits_.push_back({pair.low, pair.high, tangent.towards, tangent.most, own, -1.0});
}

// The share of the first of two agents that meet: the less the agent with the right of way gets on, the more
// the other one takes.
double Headway::shareOf(NeighbourPair pair, const HeadwayInput& input) const {
    const bool lowStays = input.claims[pair.low].stays, highStays = input.claims[pair.high].stays;
    // The agent that walks goes past the one that stays.
    if (lowStays != highStays) return lowStays ? 0.0 : 1.0;
    if (input.right == nullptr) return bodies_->share(pair.low, pair.high);
    const bool lowFirst = input.right->precedes(pair.low, pair.high);
    const std::int32_t first = lowFirst ? pair.low : pair.high, other = lowFirst ? pair.high : pair.low;
    const double free = std::clamp(static_cast<double>(input.claims[first].progress) / kFreeProgress, 0.0,
                                   1.0);
    const double own = free * bodies_->share(first, other);
    return lowFirst ? own : 1.0 - own;
}

// Finds pairs that may come near a limit: they close their gap within the longest time that a law looks ahead
// or, out of step, one of them is too fast for it. Which pairs do is as good as random, so they are noted
// without a branch.
std::span<const NeighbourPair> Headway::findMeetings(const Characters& now, const NeighbourList& neighbours,
                                                     std::span<const Vec2> velocity) {
    const CrowdBodies& bodies = *bodies_;
    const std::span<const NeighbourPair> pairs = neighbours.pairs();
    const double ahead = std::max(
        {bodies.usual().foresight, bodies.longestHeadway(), bodies.longestBraking()});
    const double headway = inStep_ < 1.0 ? bodies.longestHeadway() : 0.0;
    const std::span<const Vec2> position = now.position;
    meetings_.resize(std::max({meetings_.size(), pairs.size(), kPairsPerCharacter * now.size()}));
    NeighbourPair* next = meetings_.data();
    const auto note = [&](NeighbourPair pair, double touching) {
        const Vec2 a = velocity[pair.low], b = velocity[pair.high];
        const Vec2 between = bodies.between(position[pair.low], position[pair.high]);
        const double apart = length(between), gap = apart - touching;
        const double slow = gap - kLimitSlack * headway;
        const double onto = std::max(dot(a, between), -dot(b, between));
        const bool apartForLong = static_cast<int>(isApartFor(ahead, gap, a - b)) &
                                  static_cast<int>(slow * apart >= headway * onto);
        *next = pair;
        next += apartForLong ? 0 : 1;
    };
    if (bodies.alike())
        for (const NeighbourPair pair : pairs) note(pair, 2.0 * bodies.largestRadius());
    else
        for (const NeighbourPair pair : pairs) note(pair, bodies.touching(pair.low, pair.high));
    return {meetings_.data(), next};
}

// Adds the limit of two agents that do not go the same way. One that brakes slowly looks ahead as far as it
// needs to stop, and turns aside rather than brake while both get on.
void Headway::meet(NeighbourPair pair, const Apart& two, const HeadwayInput& input,
                   std::span<const Vec2> velocity) {
    const double foresight = bodies_->usual().foresight;
    const double ahead = std::max(
        {foresight, bodies_->brakingTime(pair.low), bodies_->brakingTime(pair.high)});
    const bool turns = ahead > foresight && getsOn(input.claims[pair.low]) && getsOn(input.claims[pair.high]);
    const Vec2 closing = velocity[pair.low] - velocity[pair.high];
    share(pair, shareOf(pair, input), tangentOf(two, closing, ahead, turns, dt_), ahead, velocity);
}

// Out of step the agent behind keeps its headway in the lane of its heading, and off an agent that it
// touches.
void Headway::keepBehind(const Apart& two, std::int32_t back, std::int32_t front, Vec2 heading,
                         std::span<const Vec2> velocity) {
    if (two.gap() <= 0.0 || heading == Vec2{})
        return follow(back, front, two.towards, two.gap(), true, velocity);
    const double way = wayAhead(two.between, heading, two.touching);
    if (way < std::numeric_limits<double>::infinity())
        follow(back, front, two.towards, std::max(0.0, way) * dot(two.towards, heading), true, velocity);
}

// Adds the limits of two agents that go the same way. Out of step the one behind passes the other or keeps
// behind, and pushes nobody. In step both keep clear, but nobody pushes an agent ahead that does not get on.
void Headway::goTogether(const Characters& now, NeighbourPair pair, const Apart& two,
                         const HeadwayInput& input, std::span<const Vec2> velocity) {
    const std::int32_t a = pair.low, b = pair.high;
    const double lead = dot(two.towards, lead_[a] + lead_[b]);
    const bool inFront = std::fabs(lead) > kFrontCosine;
    const bool aFirst = inFront ? lead < 0.0 : now.cost[a] <= now.cost[b];
    const std::int32_t back = aFirst ? b : a, front = aFirst ? a : b;
    const Apart ahead = aFirst ? two.reversed() : two;
    const Claim& first = input.claims[front];
    const Vec2 closing = velocity[a] - velocity[b];
    const double headway = std::max(bodies_->headway(a), bodies_->headway(b));
    if (inStep_ < 1.0) {
        if (!isApartFor(headway, two.gap(), closing))
            share(pair, aFirst ? 0.0 : 1.0, tangentOf(two, closing, headway, false, dt_), headway, velocity);
        return keepBehind(ahead, back, front, heading_[back], velocity);
    }
    if (inFront ? !getsOn(first) : first.stuck > 0.0f)
        return follow(back, front, ahead.towards, ahead.gap(), false, velocity);
    share(pair, bodies_->share(a, b), tangentOf(two, closing, headway, false, dt_), headway, velocity);
}

void Headway::findHeadings(const HeadwayInput& input) {
    const std::size_t count = input.wanted.size();
    lead_.resize(count);
    heading_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        lead_[i] = input.wanted[i] / std::max(input.topSpeed[i], 1e-9);
        heading_[i] = inStep_ < 1.0 ? normalized(input.turned[i]) : Vec2{};
    }
}

void Headway::addPair(const Characters& now, NeighbourPair pair, const HeadwayInput& input,
                      std::span<const Vec2> velocity) {
    const CrowdBodies& bodies = *bodies_;
    const std::int32_t a = pair.low, b = pair.high;
    const bool fixedA = bodies.isFixed(a), fixedB = bodies.isFixed(b);
    if (fixedA && fixedB) return;
    const Vec2 between = bodies.between(now.position[a], now.position[b]);
    const double apart = length(between);
    const Apart two{between, apart > 1e-9 ? between / apart : Vec2{1.0, 0.0}, apart, bodies.touching(a, b)};
    if (fixedA || bodies.isFirmer(a, b)) return follow(b, a, -two.towards, two.gap(), false, velocity);
    if (fixedB || bodies.isFirmer(b, a)) return follow(a, b, two.towards, two.gap(), false, velocity);
    if (differ(input.wanted[a], input.wanted[b])) return meet(pair, two, input, velocity);
    goTogether(now, pair, two, input, velocity);
}

// Adds walls. Pieces are listed in no fixed order, so that the limits of a character are sorted.
void Headway::addWalls(const Characters& now, const Environment& environment,
                       std::span<const Vec2> velocity) {
    const CrowdBodies& bodies = *bodies_;
    nearObstacle_.resize(now.size());
    environment.markNearObstacles(now.position, bodies.largestRadius() + kWallReach, nearObstacle_);
    const Box box = environment.def().sides();
    for (std::size_t i = 0; i < now.size(); ++i) {
        if (nearObstacle_[i] == 0 || bodies.isFixed(i)) continue;
        const Vec2 here = now.position[i];
        const double radius = bodies.radius(i), reach = radius + kWallReach;
        const auto first = static_cast<std::ptrdiff_t>(limits_.size());
        const auto add = [&](Vec2 towards, double apart, Vec2 wallVelocity) {
            const double gap = apart - radius;
            const double most = dot(wallVelocity, towards) + gapSpeed(gap, dt_, dt_);
            if (dot(velocity[i], towards) > most - kLimitSlack)
                limits_.push_back({static_cast<std::int32_t>(i), -1, towards, most, 1.0, 0.0});
        };
        environment.forPiecesNear(here, reach, [&](const ObstaclePiece& piece) {
            const SurfacePoint nearest = closestSurfacePoint(piece, here);
            if (nearest.distance > reach || nearest.distance < 1e-6) return;
            add((nearest.point - here) / nearest.distance, nearest.distance, piece.velocity);
        });
        add({-1.0, 0.0}, here.x - box.min.x, {});
        add({1.0, 0.0}, box.max.x - here.x, {});
        add({0.0, -1.0}, here.y - box.min.y, {});
        add({0.0, 1.0}, box.max.y - here.y, {});
        std::sort(limits_.begin() + first, limits_.end(), [](const Limit& a, const Limit& b) {
            if (a.most != b.most) return a.most < b.most;
            return a.towards.x != b.towards.x ? a.towards.x < b.towards.x : a.towards.y < b.towards.y;
        });
    }
}

double Headway::relax(std::span<Vec2> velocity) {
    double largest = 0.0;
    for (Limit& limit : limits_) {
        Vec2& back = velocity[limit.back];
        const Vec2 n = limit.towards;
        double most = limit.most;
        const bool shared = limit.follow < 0.0;
        if (limit.front >= 0) {
            const double ahead = dot(velocity[limit.front], n);
            most += shared || ahead <= 0.0 ? ahead : limit.follow * ahead;
        }
        const double pressed = std::max(0.0, limit.pressed + dot(back, n) - most);
        const double change = pressed - limit.pressed;
        if (change == 0.0) continue;
        limit.pressed = pressed;
        largest = std::max(largest, std::fabs(change));
        back -= n * (change * limit.share);
        if (shared) velocity[limit.front] += n * (change * (1.0 - limit.share));
    }
    return largest;
}

void Headway::findQueues(std::size_t count) {
    queues_.assign(count, 0);
    for (const Limit& limit : limits_)
        if (limit.queues && limit.pressed > 0.0) queues_[limit.back] = 1;
}

void Headway::run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                  const NeighbourList& neighbours, const HeadwayInput& input, std::span<Vec2> velocity) {
    bodies_ = &bodies;
    dt_ = input.dt;
    inStep_ = bodies.usual().inStep;
    limits_.clear();
    limits_.reserve(kLimitsPerCharacter * now.size());
    findHeadings(input);
    for (const NeighbourPair pair : findMeetings(now, neighbours, velocity))
        addPair(now, pair, input, velocity);
    addWalls(now, environment, velocity);
    for (int sweep = 0; sweep < kSweeps; ++sweep)
        if (relax(velocity) < kSweepChange) break;
    findQueues(now.size());
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!bodies.isFixed(i)) velocity[i] = clampLength(velocity[i], input.topSpeed[i]);
}

}  // namespace muster
