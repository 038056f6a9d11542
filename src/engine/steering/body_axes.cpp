#include "engine/steering/body_axes.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kAxisDistance = 0.28;  // Least distance between axes side by side [m].
constexpr double kEnd = 0.06;           // Length by which an axis ends before hips and head [m].
// Gap between bodies one behind the other, beyond the least distance [m].
constexpr double kFollowingGap = 0.03;
constexpr double kFileWidth = 0.32;    // Sideways distance beyond which a body is not ahead [m].
constexpr double kClosingTime = 0.25;  // Time in which a gap is closed [s].
// Cosine of the largest angle between two bodies that go the same way.
constexpr double kSameWayCosine = 0.5;
constexpr double kPatchAhead = 0.6;     // Distance to a patch below which a character is about to lie [m].
constexpr double kSettledReach = 0.35;  // Distance to its place below which a character has settled [m].
constexpr double kPairReach = 1.5;      // Distance beyond which two bodies do not matter to each other [m].
// Distance along the heading below which neither of two bodies is behind [m].
constexpr double kAbreastDistance = 0.3;
// Inverse of the share of a transition after which a body lies at full length.
constexpr double kLieDownFactor = 1.6;
constexpr double kParallelCosine = 0.95;  // Cosine of the largest angle between two parallel axes.
constexpr double kStandingSpeed = 0.15;   // Speed below which a character stands [m/s].
constexpr double kPassSpeed = 0.14;       // Sideways speed at which a character passes one that stands [m/s].

BodyReach reachOf(const ClipFacts& clip, double share) {
    return {clip.reachAhead * share, clip.reachBehind * share};
}

bool isUpright(const BodyReach& reach) {
    return reach.ahead + reach.behind <= 0.0;
}

// The share of its length at which a body lies now: transitions lie down and stand up evenly.
double lyingShare(const ClipFacts& clip, MotionPhase phase, double time) {
    if (phase != MotionPhase::Entering && phase != MotionPhase::Leaving) return 1.0;
    const double share = clip.transitionTime > 0.0 ? std::min(1.0, time / clip.transitionTime) : 1.0;
    return std::min(1.0, kLieDownFactor * (phase == MotionPhase::Entering ? share : 1.0 - share));
}

// The vector between the nearest points of two segments, from the first segment to the second.
Vec2 nearestBetween(Vec2 a, Vec2 aEnd, Vec2 b, Vec2 bEnd) {
    const Vec2 da = aEnd - a, db = bEnd - b;
    const double crossing = cross(da, db);
    if (std::fabs(crossing) > 1e-12) {
        const double s = cross(b - a, db) / crossing, t = cross(b - a, da) / crossing;
        if (s >= 0.0 && s <= 1.0 && t >= 0.0 && t <= 1.0) return {};
    }
    const auto onto = [](Vec2 p, Vec2 from, Vec2 along) {
        const double l2 = lengthSquared(along);
        const double t = l2 > 0.0 ? std::clamp(dot(p - from, along) / l2, 0.0, 1.0) : 0.0;
        return from + along * t;
    };
    Vec2 nearest = onto(a, b, db) - a;
    const auto consider = [&nearest](Vec2 other) {
        if (lengthSquared(other) < lengthSquared(nearest)) nearest = other;
    };
    consider(onto(aEnd, b, db) - aEnd);
    consider(b - onto(b, a, da));
    consider(bEnd - onto(bEnd, a, da));
    return nearest;
}

// Position of a body relative to another one that goes the same way, one behind the other.
struct File {
    Vec2 along;          // Common heading of both, a unit vector.
    double aside = 0.0;  // Distance of the body ahead to the left [m].
    double gap = 0.0;    // Distance from the head behind to the hips ahead [m].
};

File fileOf(Vec2 rear, Vec2 front, Vec2 along, double rearAhead, double frontBehind) {
    const Vec2 between = front - rear;
    const double ends = std::max(0.0, rearAhead + frontBehind - 2.0 * kEnd);
    return {along, cross(along, between), dot(along, between) - ends};
}

}  // namespace

void BodyAxes::resolve(const Environment& environment, const Characters& now, std::span<const Vec2> place,
                       std::span<const Vec2> placeVelocity) {
    members_.clear();
    positions_.clear();
    pairs_.clear();
    if (environment.patchIds().empty()) return;
    members_.reserve(now.size());
    positions_.reserve(now.size());
    const std::vector<ClipFacts>& clips = environment.def().clips;
    for (std::size_t i = 0; i < now.size(); ++i) {
        const ClipFacts& clip = clips[now.motion[i]];
        Member member;
        member.character = static_cast<std::int32_t>(i);
        member.heading = now.heading[i];
        member.reach = reachOf(clip, lyingShare(clip, now.phase[i], now.motionTime[i]));
        member.lying = now.phase[i] == MotionPhase::Leaving ? member.reach : reachOf(clip, 1.0);
        if (isUpright(member.lying) && now.direction[i] != Vec2{}) {
            const GroundSample ahead = environment.ground(now.position[i] + now.direction[i] * kPatchAhead);
            member.lying = reachOf(clips[ahead.motion], 1.0);
        }
        if (isUpright(member.lying)) continue;
        if (now.phase[i] == MotionPhase::Locked)
            member.onward = now.direction[i] != Vec2{} ? now.direction[i] : now.heading[i];
        member.settled = now.place[i] >= 0 && length(placeVelocity[i]) < kStandingSpeed &&
                         distance(now.position[i], place[i]) < kSettledReach;
        members_.push_back(member);
        positions_.push_back(now.position[i]);
    }
    if (!members_.empty()) pairs_.build(positions_, kPairReach);
}

void BodyAxes::keepDistance(const CrowdBodies& bodies, const Characters& now,
                            std::span<Vec2> preferred) const {
    for (const NeighbourPair pair : pairs_.pairs()) {
        const Member *rear = &members_[pair.low], *front = &members_[pair.high];
        if (dot(rear->heading, front->heading) < kSameWayCosine) continue;
        const Vec2 along = normalized(rear->heading + front->heading, rear->heading);
        if (dot(now.position[front->character] - now.position[rear->character], along) < 0.0)
            std::swap(rear, front);
        const std::int32_t r = rear->character, f = front->character;
        if (bodies.isFixed(r) || (rear->settled && front->settled)) continue;
        const File file = fileOf(now.position[r], now.position[f], along, rear->lying.ahead,
                                 front->reach.behind);
        if (std::fabs(file.aside) > kFileWidth) continue;
        const double least = std::sqrt(
                                 std::max(0.0, kAxisDistance * kAxisDistance - file.aside * file.aside)) +
                             kFollowingGap;
        const double ahead = std::max(0.0, dot(now.velocity[f], along));
        const double most = std::max(0.0, ahead + (file.gap - least) / kClosingTime);
        const double tooFast = dot(preferred[r], along) - most;
        if (tooFast <= 0.0) continue;
        preferred[r] -= along * tooFast;
        if (ahead < kStandingSpeed)
            preferred[r] += perpendicular(along) *
                            (std::min(tooFast, kPassSpeed) * (file.aside > 0.0 ? -1.0 : 1.0));
    }
}

// A character in a single-step motion may be pushed aside, but not back, where the motion would begin again;
// the other character makes room instead.
BodyAxes::Correction BodyAxes::correctionOf(NeighbourPair pair, std::span<const Vec2> positions) const {
    const Member &a = members_[pair.low], &b = members_[pair.high];
    if (isUpright(a.reach) || isUpright(b.reach) || (a.settled && b.settled)) return {};
    const Overlap overlap = axesOverlap(a, b, positions);
    const double backA = std::max(0.0, dot(overlap.away, a.onward));
    const double backB = std::max(0.0, -dot(overlap.away, b.onward));
    const double shareA = overlap.share, shareB = 1.0 - shareA;
    const double leftA = shareA * backA * backA, leftB = shareB * backB * backB;
    return {overlap.depth, (overlap.away - a.onward * backA) * (-overlap.depth * (shareA + leftB)),
            (overlap.away + b.onward * backB) * (overlap.depth * (shareB + leftA))};
}

// The overlap of `a` and `b`, which both lie.
BodyAxes::Overlap BodyAxes::axesOverlap(const Member& a, const Member& b,
                                        std::span<const Vec2> positions) const {
    const Vec2 p = positions[a.character], q = positions[b.character];
    const double cosine = dot(a.heading, b.heading);
    const Vec2 along = cosine > kSameWayCosine ? normalized(a.heading + b.heading, a.heading) : Vec2{};
    if (cosine < kParallelCosine) {
        const auto end = [](const Member& m, Vec2 at, double reach) {
            return at + m.heading * (reach > 0.0 ? std::max(0.0, reach - kEnd) : std::min(0.0, reach + kEnd));
        };
        const Vec2 nearest = nearestBetween(end(a, p, -a.reach.behind), end(a, p, a.reach.ahead),
                                            end(b, q, -b.reach.behind), end(b, q, b.reach.ahead));
        const double apart = length(nearest), ahead = dot(q - p, along);
        if (apart >= kAxisDistance) return {};
        const double share = std::fabs(ahead) <= kAbreastDistance ? 0.5 : ahead > 0.0 ? 1.0 : 0.0;
        return {apart > 1e-9 ? nearest / apart : normalized(q - p, {1.0, 0.0}), kAxisDistance - apart, share};
    }
    const bool aBehind = dot(q - p, along) >= 0.0;
    const File file = aBehind ? fileOf(p, q, along, a.reach.ahead, b.reach.behind)
                              : fileOf(q, p, along, b.reach.ahead, a.reach.behind);
    const double aside = std::fabs(file.aside), gap = std::max(0.0, file.gap);
    if (aside * aside + gap * gap >= kAxisDistance * kAxisDistance) return {};
    const double back = std::sqrt(kAxisDistance * kAxisDistance - aside * aside) - file.gap;
    const double sideways = std::sqrt(kAxisDistance * kAxisDistance - gap * gap) - aside;
    // The body behind falls back; where neither is behind, both go aside.
    if (back <= sideways || std::fabs(dot(q - p, along)) > kAbreastDistance)
        return {aBehind ? along : along * -1.0, back, aBehind ? 1.0 : 0.0};
    const bool left = (file.aside >= 0.0) == aBehind;
    return {left ? perpendicular(along) : perpendicular(along) * -1.0, sideways, 0.5};
}

}  // namespace muster
