#include "engine/steering/hand_over.h"

#include <algorithm>
#include <cmath>

#include "engine/steering/characters.h"

namespace muster {
namespace {

constexpr double kGotOn = 0.25;      // Who has moved so far from its anchor has got on [m].
constexpr double kArrived = 0.35;    // Cost below which a character is at its place [m].
constexpr double kStanding = 0.3;    // Who is slower at its place stands [m/s].
constexpr float kPatience = 1.0f;    // Time without getting on after which a way counts as barred [s].
constexpr double kAhead = 0.25;      // Cosine from which one is in the way of another.
constexpr float kForgetting = 0.1f;  // Rate at which the cost of a barred place falls [m/s].
constexpr float kCostliest = 10.0f;  // Highest cost of a barred place [m].

bool stands(const Characters& now, std::int32_t i) {
    return now.place[i] >= 0 && now.cost[i] < 2.0 * kArrived &&
           lengthSquared(now.velocity[i]) < kStanding * kStanding;
}

// True where `other` stands in the way of `i`. Those who share a place do not bar each other's way.
bool bars(const Characters& now, std::int32_t other, std::int32_t i, Vec2 between) {
    return now.group[other] == now.group[i] && now.place[other] != now.place[i] && stands(now, other) &&
           now.cost[other] < now.cost[i] && dot(between, now.direction[i]) > kAhead * length(between);
}

bool isUnderWay(const HandOverDef& def, const Characters& now, std::int32_t i) {
    return now.place[i] >= 0 && !now.claim[i].settled &&
           now.cost[i] > kArrived + (def.room.empty() ? 0.0 : def.room[i]);
}

// True where the character has been on its way for a while without getting on.
bool isKept(const HandOverDef& def, const Characters& now, const PlaceWait& wait, std::int32_t i) {
    return wait.stood >= kPatience && isUnderWay(def, now, i);
}

void follow(const HandOverDef& def, const Characters& now, std::int32_t i, float dt, PlaceWait& wait) {
    const bool gotOn = lengthSquared(now.position[i] - wait.anchor) > kGotOn * kGotOn;
    if (gotOn || !isUnderWay(def, now, i)) {
        wait.anchor = now.position[i];
        wait.stood = 0.0f;
    } else {
        wait.stood += dt;
    }
    wait.cost = std::max(0.0f, wait.cost - kForgetting * dt);
    if (wait.cost == 0.0f) wait.place = -1;
}

}  // namespace

void updateWaits(const HandOverDef& def, const Characters& now, const CrowdBodies& bodies,
                 const NeighbourList& neighbours, double dt, std::span<PlaceWait> waits) {
    const auto step = static_cast<float>(dt);
    const auto count = static_cast<std::int32_t>(now.size());
    for (std::int32_t i = 0; i < count; ++i) follow(def, now, i, step, waits[i]);
    const auto rise = static_cast<float>(def.topSpeed) * step;
    const auto wait = [&](std::int32_t i, std::int32_t other, Vec2 between) {
        PlaceWait& own = waits[i];
        if (!isKept(def, now, own, i) || !bars(now, other, i, between)) return;
        if (own.place != now.place[i]) own.cost = 0.0f;
        own.place = now.place[i];
        own.cost = std::min(kCostliest, own.cost + rise);
    };
    for (const NeighbourPair pair : neighbours.pairs()) {
        const Vec2 between = now.position[pair.high] - now.position[pair.low];
        const double reach = bodies.touching(pair.low, pair.high) + def.gap;
        if (lengthSquared(between) > reach * reach) continue;
        wait(pair.low, pair.high, between);
        wait(pair.high, pair.low, -between);
    }
}

}  // namespace muster
