#include "engine/steering/right_of_way.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "muster/assert.h"

namespace muster {
namespace {

constexpr double kRestReach = 0.15;  // Distance to its place below which a character rests [m].
constexpr float kSettleTime = 1.0f;  // Time without coming nearer after which a character settles [s].
// Distance to its place above which a resting character was moved aside [m].
constexpr double kMovedAsideDistance = 0.3;
constexpr double kPlaceMoved = 0.5;  // Distance that a place moves before it counts as another one [m].
constexpr double
    // Speed below which a place stands; a mesh in a door may tremble by a millimetre [m/s].
    kPlaceSpeed = 0.1;
constexpr double kSmoothingTime = 0.3;   // Time over which progress is smoothed [s].
constexpr double kFileCosine = 0.7;      // Cosine from which on one agent follows another.
constexpr double kFileGap = 1.0;         // Gap within which a file follows its head [m].
constexpr double kAskGap = 0.6;          // Gap within which an agent in the way is asked [m].
constexpr float kAskResting = 0.2f;      // Time without getting on after which a resting agent is asked [s],
constexpr float kAskWalkingTime = 3.0f;  // and after which a walking agent is asked [s].
// Time of asking in vain after which an agent becomes the last, for the same time [s].
constexpr float kHandOnTime = 5.0f;
constexpr float kLendTime = 0.6f;        // Time for which a walking agent lends its way [s],
constexpr float kLendTimeAtRest = 1.5f;  // and for which a resting agent does [s].
constexpr double kPassDistance = 0.05;   // Distance kept beside an agent that passes [m].

// Classes by rank. An agent that stays is first, since it takes no share of the change that keeps others
// clear of it.
enum : std::uint8_t { kStays, kLeaves, kWalks, kFollows, kMoved, kRests, kLast, kClasses };

}  // namespace

// Reserves memory, so that nothing is allocated where an agent is blocked for the first time.
void RightOfWay::reserve(std::size_t count) {
    for (auto* array : {&byAge_, &order_, &files_, &rank_, &stack_}) array->reserve(count);
    for (auto* array : {&class_, &done_, &open_}) array->reserve(count);
    own_.reserve(count);
    lender_.reserve(count);
}

bool RightOfWay::count(const ClaimInput& input, const Characters& characters, std::span<Claim> claims) {
    const auto time = static_cast<float>(input.dt);
    const auto share = static_cast<float>(std::min(1.0, input.dt / kSmoothingTime));
    MUSTER_ASSERT(claims.size() == characters.size());
    reserve(characters.size());
    bool any = false;
    for (std::size_t i = 0; i < characters.size(); ++i) {
        Claim& claim = claims[i];
        claim.lends = std::max(0.0f, claim.lends - time);
        claim.last = std::max(0.0f, claim.last - time);
        const double left = distance(characters.position[i], input.place[i]);
        const double reach = kArrivedReach + (input.room.empty() ? 0.0 : input.room[i]);
        const bool stands = lengthSquared(input.placeVelocity[i]) < kPlaceSpeed * kPlaceSpeed;
        if (claim.rests && (!stands || distance(input.place[i], claim.spot) > kPlaceMoved)) {
            claim.rests = claim.settled = false;
            claim.since = input.groups.empty() ? input.step : input.groups[characters.group[i]].since;
        }
        claim.stays = !characters.hasSetOut(i, input.step);
        claim.follows = !input.groups.empty() && input.groups[characters.group[i]].follows;
        // An agent that was moved aside and cannot return walks again; one that asks in vain hands its turn
        // on.
        claim.settled = claim.settled && left <= reach;
        if (claim.rests && !claim.settled && left > kMovedAsideDistance && claim.stuck > kHandOnTime &&
            claim.lends == 0.0f) {
            claim.rests = false;
            claim.since = input.step;
            claim.stuck = 0.0f;
        }
        if (claim.asks && claim.stuck > kHandOnTime) {
            claim.since = input.step;
            claim.stuck = 0.0f;
            claim.last = kHandOnTime;
        }
        claim.asks = false;
        if (!claim.rests && stands && left < kRestReach) {
            claim.rests = true;
            claim.spot = input.place[i];
        }
        // An agent within reach of its place that comes no nearer has arrived.
        if (stands && left < reach && claim.stuck > kSettleTime) {
            claim.rests = claim.settled = true;
            claim.spot = input.place[i];
        }
        const Vec2 along = normalized(input.wanted[i]);
        const auto now = static_cast<float>(dot(characters.velocity[i], along) /
                                            std::max(input.bodies.crowdedSpeed(i, input.topSpeed[i]), 1e-9));
        claim.progress += (now - claim.progress) * share;
        const bool waits = !getsOn(claim) && !claim.queues && left >= kRestReach && claim.lends == 0.0f &&
                           claim.last == 0.0f && !(along == Vec2{});
        claim.stuck = waits ? claim.stuck + time : 0.0f;
        any = any || waits || claim.lends > 0.0f;
    }
    return any;
}

void RightOfWay::sort(const CrowdBodies& bodies, const Characters& now, std::span<const Vec2> leaving,
                      std::span<const Claim> claims) {
    const std::size_t count = now.size();
    class_.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        const Claim& claim = claims[i];
        const bool aside = now.place[i] >= 0 && !claim.settled &&
                           distance(claim.spot, now.position[i]) > kMovedAsideDistance;
        const bool leaves = !leaving.empty() && !(leaving[i] == Vec2{});
        class_[i] = leaves              ? kLeaves
                    : claim.stays       ? kStays
                    : claim.last > 0.0f ? kLast
                    : !claim.rests      ? (claim.follows ? kFollows : kWalks)
                    : aside             ? kMoved
                                        : kRests;
    }
    sortByAge(bodies, claims);
    // Sorts by class, and within a class by age.
    std::array<std::int32_t, kClasses + 1> first{};
    for (const std::uint8_t c : class_) ++first[c + 1];
    for (std::size_t c = 1; c < first.size(); ++c) first[c] += first[c - 1];
    order_.resize(count);
    for (const std::int32_t i : byAge_) order_[first[class_[i]]++] = i;
}

// Sorts by size, the larger first, then by age, the elder first, then by index. The order is unique, and the
// last one is near to it.
void RightOfWay::sortByAge(const CrowdBodies& bodies, std::span<const Claim> claims) {
    const auto before = [&](std::int32_t a, std::int32_t b) {
        if (bodies.radius(a) != bodies.radius(b)) return bodies.radius(a) > bodies.radius(b);
        if (claims[a].since != claims[b].since) return claims[a].since < claims[b].since;
        return a < b;
    };
    if (byAge_.size() != claims.size()) {
        byAge_.resize(claims.size());
        std::iota(byAge_.begin(), byAge_.end(), 0);
    }
    if (!std::is_sorted(byAge_.begin(), byAge_.end(), before))
        std::sort(byAge_.begin(), byAge_.end(), before);
}

// An agent that follows close behind another, the same way, comes right after it in rank: a file passes as
// one.
void RightOfWay::joinFiles(const Characters& now, const NearRows& rows, std::span<const Vec2> own) {
    open_.assign(class_.begin(), class_.end());
    files_.clear();
    for (const std::int32_t head : order_) {
        if (open_[head] == kClasses) continue;
        open_[head] = kClasses;
        files_.push_back(head);
        const std::uint8_t joining = class_[head];
        if (joining < kWalks || joining > kFollows) continue;
        for (std::size_t at = files_.size() - 1; at < files_.size(); ++at) {
            const std::int32_t a = files_[at];
            const Vec2 ahead = normalized(own[a]);
            for (const std::int32_t b : rows.of(a)) {
                if (open_[b] != joining || dot(own[a], own[b]) <= kFileCosine) continue;
                const Near near = rows.near(a, b);
                if (near.gap > kFileGap || dot(near.towards, ahead) >= -0.5) continue;
                open_[b] = kClasses;
                files_.push_back(b);
            }
        }
    }
    rank_.resize(now.size());
    for (std::size_t k = 0; k < files_.size(); ++k) rank_[files_[k]] = static_cast<std::int32_t>(k);
}

// The asked agent goes aside where there is room, else along the direction of the asking one.
void RightOfWay::lend(std::int32_t asker, const Near& near, Vec2 along, const CrowdBodies& bodies,
                      const Environment& environment, const NearRows& rows, double topSpeed,
                      const Characters& characters, Vec2& wanted) {
    const std::int32_t b = near.other;
    const double apart = near.gap + bodies.touching(asker, b);
    const double beside = cross(along, near.towards) * apart;
    const Vec2 side = perpendicular(along);
    Vec2 best = along;
    double least = 1.2, speed = 1.0;
    lender_[b] = {asker, kAskGap};
    for (const double sign : {-1.0, 1.0}) {
        const double need = std::max(0.0, bodies.touching(asker, b) + kPassDistance - sign * beside);
        const Vec2 here = characters.position[b], spot = here + side * (sign * need);
        const double radius = bodies.radius(b);
        if (!environment.def().sides().grown(-radius).contains(spot) ||
            environment.distanceToObstacle(spot, radius) < radius ||
            environment.distanceToObstacle(lerp(here, spot, 0.5), radius) < radius - 0.02)
            continue;
        double cost = need;
        for (const std::int32_t other : rows.of(b)) {
            if (other == asker) continue;
            const double touching = bodies.touching(b, other);
            if (lengthSquared(bodies.between(spot, characters.position[other])) < touching * touching)
                cost += done_[other] ? 1.0 : 0.3;
        }
        if (cost >= least) continue;
        least = cost;
        best = normalized(side * (sign * 0.9) + along * 0.4);
        speed = std::min(1.0, 5.0 * need / topSpeed);
        lender_[b].need = need + kPassDistance;
    }
    wanted = best * (speed * topSpeed);
}

void RightOfWay::askFrom(std::int32_t first, const CrowdBodies& bodies, const Environment& environment,
                         const NearRows& rows, std::span<const double> topSpeed, const Characters& characters,
                         std::span<Claim> claims, std::span<Vec2> wanted) {
    stack_.assign(1, first);
    while (!stack_.empty()) {
        const std::int32_t a = stack_.back();
        stack_.pop_back();
        const Vec2 along = normalized(wanted[a]);
        // An agent that leaves a lane is made room for by giving way, and asks nobody.
        if (along == Vec2{} || class_[a] == kLeaves) continue;
        Claim& claim = claims[a];
        const bool lends = lender_[a].to >= 0;
        if (!lends && claim.stuck <= kAskResting) continue;
        for (const std::int32_t b : rows.of(a)) {
            if (done_[b] || class_[b] < kWalks || bodies.isFixed(b) || bodies.isFirmer(b, a)) continue;
            const Near near = rows.near(a, b);
            if (near.gap > (lends ? lender_[a].need : kAskGap)) continue;
            const double apart = near.gap + bodies.touching(a, b);
            if (dot(near.towards, along) <= 0.0 ||
                std::fabs(cross(along, near.towards)) * apart > bodies.touching(a, b) + 0.03)
                continue;
            const bool resting = claims[b].rests;
            const bool lower = resting || class_[b] > class_[a];
            const float patience = !claims[a].rests && lower ? kAskResting : kAskWalkingTime;
            if (!lends && claim.stuck <= patience) continue;
            const bool same = !resting && !lends && class_[a] == class_[b] &&
                              (characters.group[a] == characters.group[b] ||
                               dot(normalized(own_[b]), along) > 0.5);
            // An agent beside or behind that blocks one of its own direction, as in an arch, steps back; an
            // agent ahead takes over the rank only. Without places the front is where all agents want to be.
            const bool behind = dot(near.towards, own_[a] + own_[b]) <= 0.0 && characters.place[a] >= 0;
            if (same && !behind) {
                if (!getsOn(claim)) {
                    done_[b] = 1;
                    stack_.push_back(b);
                }
                continue;
            }
            lend(a, near, along, bodies, environment, rows, topSpeed[b], characters, wanted[b]);
            if (same) wanted[b] = along * -topSpeed[b];
            claims[b].lends = resting ? kLendTimeAtRest : kLendTime;
            done_[b] = 1;
            claim.asks = true;
            stack_.push_back(b);
        }
    }
}

void RightOfWay::run(const CrowdBodies& bodies, const Environment& environment, const NearRows& rows,
                     std::span<const double> topSpeed, std::span<const Vec2> leaving,
                     const Characters& characters, std::span<Claim> claims, std::span<Vec2> wanted) {
    const std::size_t count = characters.size();
    own_.resize(count);
    for (std::size_t i = 0; i < count; ++i) own_[i] = topSpeed[i] > 0.0 ? wanted[i] / topSpeed[i] : Vec2{};
    sort(bodies, characters, leaving, claims);
    joinFiles(characters, rows, own_);
    lender_.assign(count, {});
    done_.assign(count, 0);
    for (const std::int32_t top : files_) {
        if (done_[top]) continue;
        done_[top] = 1;
        if (claims[top].lends > 0.0f && class_[top] != kLeaves)
            wanted[top] = {};  // It was asked a moment ago, and is not asked now: it waits.
        if (claims[top].stuck > kAskResting)
            askFrom(top, bodies, environment, rows, topSpeed, characters, claims, wanted);
    }
}

}  // namespace muster
