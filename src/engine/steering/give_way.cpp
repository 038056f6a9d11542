#include "engine/steering/give_way.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/ground/environment/obstacle_piece.h"
#include "engine/steering/character_arrays.h"

namespace muster {
namespace {

constexpr double kLeastObstacleSpeed = 0.05;  // Speed below which obstacles are left to contacts [m/s].
constexpr double kSweptMargin = 0.3;          // Distance to the swept ground [m].
constexpr double kLaneHorizon = 4.0;          // Time for which lanes reach ahead [s].
constexpr double kReactionTime = 1.0;         // Time that people keep in hand when they leave a lane [s],
constexpr double kEffortFactor = 2.0;         // and factor of the time alone that they expect to take.
constexpr double kCrossingTime = 0.6;         // Time that people keep in hand when they cross [s].
constexpr double kStoppingTime = 0.3;         // Time in which a person stops that must not enter [s].
constexpr double kFollowGap = 0.15;           // Distance behind an obstacle [m].
constexpr double kPressGap = 0.12;  // Distance to a person that leaves below which others make room [m].
constexpr double kPressCosine = 0.35;
constexpr int kPasses = 16;  // Number of people through which making room is passed on.

}  // namespace

GiveWay::Lane GiveWay::laneOf(const ObstaclePiece& piece, double radius) {
    Lane lane;
    lane.speed = length(piece.velocity);
    lane.centre = piece.centre;
    lane.along = piece.velocity / lane.speed;
    lane.across = perpendicular(lane.along);
    lane.rear = lane.right = -piece.radius;
    lane.front = lane.left = piece.radius;
    if (!piece.corners.empty()) {
        lane.rear = lane.right = std::numeric_limits<double>::infinity();
        lane.front = lane.left = -lane.rear;
        for (const Vec2 corner : piece.corners) {
            const double along = dot(corner - piece.centre, lane.along);
            const double across = dot(corner - piece.centre, lane.across);
            lane.rear = std::min(lane.rear, along);
            lane.front = std::max(lane.front, along);
            lane.right = std::min(lane.right, across);
            lane.left = std::max(lane.left, across);
        }
    }
    lane.right -= radius + kSweptMargin;
    lane.left += radius + kSweptMargin;
    return lane;
}

// The lane for a body whose radius is `by` [m] larger than the usual one.
GiveWay::Lane GiveWay::widened(Lane lane, double by) {
    lane.right -= by;
    lane.left += by;
    return lane;
}

// Leaves a lane by the side that takes less time, or straight on if that is in time. A side behind a wall is
// the last choice.
void GiveWay::leave(const Lane& lane, const Environment& environment, Vec2 position, double topSpeed,
                    double radius, std::size_t character, double timeLeft, Vec2 preferred) {
    const double across = dot(position - lane.centre, lane.across);
    const double toLeft = lane.left - across, toRight = across - lane.right;
    const double drift = dot(preferred, lane.across);
    const double onward = drift > 0.0 ? toLeft : toRight;
    const bool crosses = std::fabs(drift) > 0.5 * topSpeed &&
                         onward / std::fabs(drift) + kCrossingTime < timeLeft;
    if (crosses) return;
    const double least = std::min(toLeft, toRight) / topSpeed;
    if (timeLeft > kEffortFactor * least + kReactionTime) return;
    bool left = toLeft < toRight;
    const auto isClear = [&](bool side) {
        const Vec2 out = position + lane.across * (side ? toLeft : -toRight);
        return environment.clearLine(position, out, 0.98 * radius);
    };
    if (!isClear(left) && isClear(!left)) left = !left;
    const double slack = timeLeft - (left ? toLeft : toRight) / topSpeed;
    if (!(leaving_[character] == Vec2{}) && slack_[character] <= slack) return;
    leaving_[character] = lane.across * (left ? topSpeed : -topSpeed);
    slack_[character] = slack;
}

// Follows the obstacle without running into it. `along` and `across` are those of the character's front.
void GiveWay::follow(const Lane& lane, double along, double across, Vec2& preferred) {
    if (across < lane.right || across > lane.left) return;
    const double closing = dot(preferred, lane.along) - lane.speed;
    const double most = (lane.rear - kFollowGap - along) / kStoppingTime;
    if (closing > most) preferred -= lane.along * (closing - most);
}

void GiveWay::giveWay(const Lane& lane, const Environment& environment, Vec2 position, double topSpeed,
                      double radius, std::size_t character, Vec2& preferred) {
    const double along = dot(position - lane.centre, lane.along);
    const double timeLeft = std::max(0.0, along - lane.front - radius) / lane.speed;
    const double across = dot(position - lane.centre, lane.across);
    if (along < lane.rear - radius) return follow(lane, along + radius, across, preferred);
    if (timeLeft > kLaneHorizon) return;
    if (across > lane.right && across < lane.left)
        return leave(lane, environment, position, topSpeed, radius, character, timeLeft, preferred);
    // A character beside the lane enters only if there is time to cross.
    const double gap = across >= lane.left ? across - lane.left : lane.right - across;
    const Vec2 inward = across >= lane.left ? -lane.across : lane.across;
    const double entering = dot(preferred, inward);
    if (entering * kStoppingTime <= gap) return;
    if ((gap + lane.left - lane.right) / entering + kCrossingTime < timeLeft) return;
    preferred -= inward * (entering - gap / kStoppingTime);
}

// A character that touches one that leaves goes the same direction, and so on.
void GiveWay::passOn(const CrowdBodies& bodies, const Characters& now, const NeighbourList& neighbours) {
    leaves_.resize(leaving_.size());
    for (std::size_t i = 0; i < leaving_.size(); ++i) leaves_[i] = leaving_[i] == Vec2{} ? 0 : 1;
    bool changed = true;
    const auto press = [&](std::int32_t from, std::int32_t to, Vec2 between) {
        const double pressed = dot(leaving_[from], between);
        if (pressed <= kPressCosine * length(between) * length(leaving_[from])) return;
        leaving_[to] = leaving_[from];
        leaves_[to] = 1;
        changed = true;
    };
    for (int pass = 0; pass < kPasses && changed; ++pass) {
        changed = false;
        for (const NeighbourPair pair : neighbours.pairs()) {
            if (leaves_[pair.low] == leaves_[pair.high]) continue;
            const Vec2 between = bodies.between(now.position[pair.low], now.position[pair.high]);
            const double reach = bodies.touching(pair.low, pair.high) + kPressGap;
            if (lengthSquared(between) > reach * reach) continue;
            if (leaves_[pair.low] != 0)
                press(pair.low, pair.high, between);
            else
                press(pair.high, pair.low, -between);
        }
    }
}

void GiveWay::run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                  const NeighbourList& neighbours, std::span<const double> topSpeed,
                  std::span<Vec2> preferred) {
    const Parameters::Character& def = bodies.usual();
    lanes_.clear();
    for (const ObstaclePiece& piece : environment.pieces())
        if (piece.moving && lengthSquared(piece.velocity) > kLeastObstacleSpeed * kLeastObstacleSpeed)
            lanes_.push_back(laneOf(piece, def.radius));
    leaving_.assign(now.size(), {});
    slack_.assign(now.size(), 0.0);
    leaves_.reserve(now.size());
    bool any = false;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const double radius = bodies.radius(i), wider = radius - def.radius;
        for (const Lane& lane : lanes_)
            giveWay(wider == 0.0 ? lane : widened(lane, wider), environment, now.position[i], topSpeed[i],
                    radius, i, preferred[i]);
        any = any || !(leaving_[i] == Vec2{});
    }
    if (!any) leaving_.clear();
    if (!any) return;
    passOn(bodies, now, neighbours);
    for (std::size_t i = 0; i < now.size(); ++i)
        if (!(leaving_[i] == Vec2{})) preferred[i] = leaving_[i];
}

}  // namespace muster
