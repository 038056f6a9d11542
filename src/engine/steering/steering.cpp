#include "engine/steering/steering.h"

#include <algorithm>
#include <cmath>

#include "engine/steering/stairs.h"

namespace muster {
namespace {

// Greatest deviation of a character within a single-step motion from its heading: 20 degrees (cosine and
// sine).
constexpr Rotation kLockedDeviation{0.93969262078590838405, 0.34202014332566873304};
constexpr double kLockEnd = 0.6;      // Distance to its place below which the heading is not locked [m].
constexpr double kHeadingRate = 8.0;  // Gain of the heading [1/s].
constexpr double kLyingRate = 2.0;    // Gain of the heading of a body that leans or lies [1/s].
// Speed below which a character stands and faces with the formation [m/s].
constexpr double kWalkingSpeed = 0.15;

// The direction, or the nearest one that a locked heading allows.
Vec2 limitDeviation(Vec2 direction, Vec2 heading) {
    if (dot(direction, heading) >= kLockedDeviation.c) return direction;
    return cross(heading, direction) >= 0.0 ? kLockedDeviation.apply(heading)
                                            : kLockedDeviation.applyInverse(heading);
}

Vec2 rotateTowards(Vec2 heading, Vec2 towards, double share) {
    // Between opposite headings the interpolation is undefined: rotate to the left.
    if (dot(heading, towards) < -0.999) towards = perpendicular(heading);
    return normalized(heading + (towards - heading) * share, heading);
}

// The velocity towards the place: along the planned path, or straight where the place is near.
Vec2 preferredVelocity(const Parameters::Character& def, const Characters& now, const SteeringInput& input,
                       std::size_t i, double topSpeed, double brakes) {
    const Vec2 direction = now.direction[i];
    const bool placed = now.place[i] >= 0 || (!input.stands.empty() && input.stands[i] != 0);
    if (!placed && direction == Vec2{}) return {};
    const Vec2 toPlace = input.place[i] - now.position[i];
    const double left = length(toPlace);
    const bool crossing = now.phase[i] == MotionPhase::Locked && left > kLockEnd &&
                          lengthSquared(now.velocity[i]) > 0.01;
    if (crossing) return limitDeviation(direction, now.heading[i]) * topSpeed;
    if (placed && left < 1e-6) return clampLength(input.placeVelocity[i], topSpeed);
    // A character comes to its place by its own brakes; from afar, and where they are weak, also while the
    // place brakes.
    const double stops = 2.0 * kBrakingShare * brakes * left;
    const bool weak = topSpeed > 2.0 * def.foresight * brakes;
    if (placed && left < def.directReach && dot(direction, toPlace) > 0.999 * left) {
        const double ahead = weak ? std::max(0.0, dot(input.placeVelocity[i], toPlace) / left) : 0.0;
        const double closing = std::sqrt(ahead * ahead + stops) - ahead;
        return clampLength(input.placeVelocity[i] + toPlace * std::min(def.positionGain, closing / left),
                           topSpeed);
    }
    if (!placed) return direction * topSpeed;
    const double along = std::max(0.0, dot(input.placeVelocity[i], direction));
    return direction * std::min(topSpeed, std::sqrt(along * along + stops));
}

// Gains for one time step, the same for all characters.
struct StepGains {
    double velocityShare;  // Share of the velocity error that is corrected.
    double headingShare;   // Share of the heading error that is corrected.
    double lyingShare;     // Share of the heading error that is corrected of a body that leans or lies.
};

// The velocity after a step; `most` bounds its change [m/s].
Vec2 nextVelocity(double share, double most, Vec2 velocity, Vec2 preferred, double topSpeed) {
    const Vec2 desired = clampLength(preferred, topSpeed);
    const Vec2 change = clampLength((desired - velocity) * share, most);
    return clampLength(velocity + change, topSpeed);
}

}  // namespace

// A character that stays until its premovement time is over leaves its spot only for an obstacle that moves
// towards it.
void Steering::standStill(std::span<const Claim> claims) {
    standing_.reserve(claims.size());
    standing_.clear();
    if (std::none_of(claims.begin(), claims.end(), [](const Claim& claim) { return claim.stays; })) return;
    const std::span<const Vec2> leaving = giveWay_.leaving();
    for (std::size_t i = 0; i < claims.size(); ++i) {
        const bool stands = claims[i].stays && (leaving.empty() || leaving[i] == Vec2{});
        standing_.push_back(stands ? 1 : 0);
        if (stands) preferred_[i] = {};
    }
}

// Finds the top speed of a character on its ground and the velocity that it would have alone.
void Steering::aim(const CrowdBodies& bodies, const Characters& now, const SteeringInput& input,
                   const GroundSample& ground, std::size_t i) {
    const auto aimAt = [&](double travelSpeed) {
        topSpeed_[i] = bodies.maxSpeed(i) * travelSpeed;
        if (!input.pace.empty()) topSpeed_[i] *= input.pace[i];
        preferred_[i] = preferredVelocity(bodies.usual(), now, input, i, topSpeed_[i],
                                          bodies.acceleration(i));
    };
    aimAt(ground.travelSpeed);
    if (ground.isStairs()) aimAt(travelSpeedOf(ground, now.body[i], normalized(preferred_[i])));
    if (!now.hasSetOut(i, input.step)) preferred_[i] = {};
}

void Steering::run(const CrowdBodies& bodies, Characters& now, const SteeringInput& input,
                   const Environment& environment, double dt, std::span<Vec2> velocity,
                   std::span<Vec2> heading, ThreadPool* pool) {
    const std::size_t count = now.size();
    const Parameters::Character& def = bodies.usual();
    preferred_.resize(count);
    topSpeed_.resize(count);
    const bool patches = !environment.patchIds().empty();
    forChunks(pool, count, kPerTask, [&](std::size_t i) {
        aim(bodies, now, input, patches ? environment.ground(now.position[i]) : GroundSample{}, i);
    });
    const bool blocked = right_.count({bodies, topSpeed_, preferred_, input.place, input.placeVelocity,
                                       input.room, input.groups, input.step, dt},
                                      now, now.claim);
    for (std::size_t i = 0; i < count; ++i)
        if (now.claim[i].settled) preferred_[i] = {};
    neighbours_.build(now.position, 2.0 * bodies.largestRadius() + bodies.farthestGap(), 0.0, bodies.ring());
    bodies.shorten(now.position, neighbours_);
    axes_.resolve(environment, now, input.place, input.placeVelocity);
    axes_.keepDistance(bodies, now, preferred_);
    giveWay_.run(bodies, now, environment, neighbours_, topSpeed_, preferred_);
    const bool outOfStep = def.inStep < 1.0;
    if (blocked || outOfStep) rows_.build(bodies, now.position, neighbours_.pairs());
    if (blocked) {
        right_.run(bodies, environment, rows_, topSpeed_, giveWay_.leaving(), now, now.claim, preferred_);
    }
    standStill(now.claim);
    turned_.assign(preferred_.begin(), preferred_.end());
    if (outOfStep) overtaking_.run(bodies, environment, rows_, topSpeed_, input.step, dt, now, turned_);
    if (!standing_.empty())
        goPast_.run(bodies, now, environment, neighbours_, standing_, input.place, turned_);
    const StepGains gains{std::min(1.0, def.velocityGain * dt), std::min(1.0, kHeadingRate * dt),
                          std::min(1.0, kLyingRate * dt)};
    const std::vector<ClipFacts>& clips = environment.def().clips;
    forChunks(pool, count, kPerTask, [&, gains](std::size_t i) {
        velocity[i] = bodies.isFixed(i) ? now.velocity[i]
                                        : nextVelocity(gains.velocityShare, bodies.acceleration(i) * dt,
                                                       now.velocity[i], turned_[i], topSpeed_[i]);
    });
    const HeadwayInput headway{preferred_, turned_, topSpeed_, now.claim, blocked ? &right_ : nullptr, dt};
    headway_.run(bodies, now, environment, neighbours_, headway, velocity);
    for (std::size_t i = 0; i < standing_.size(); ++i)
        if (standing_[i] != 0)
            velocity[i] = nextVelocity(gains.velocityShare, bodies.acceleration(i) * dt, now.velocity[i], {},
                                       topSpeed_[i]);
    for (std::size_t i = 0; i < count; ++i) now.claim[i].queues = headway_.queues()[i] != 0;
    forChunks(pool, count, kPerTask, [&, gains, patches](std::size_t i) {
        const double turn = patches && clips[now.motion[i]].reachAhead > 0.0 ? gains.lyingShare
                                                                             : gains.headingShare;
        const Vec2 next = velocity[i];
        const double speed = length(next);
        const Vec2 towards = speed > kWalkingSpeed ? next / speed : input.facing[i];
        const bool kept = now.phase[i] == MotionPhase::Locked || (!standing_.empty() && standing_[i] != 0);
        heading[i] = kept ? now.heading[i] : rotateTowards(now.heading[i], towards, turn);
    });
}

}  // namespace muster
