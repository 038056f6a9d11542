#include "muster/crowd/contacts.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr double kSettled = 1e-4;       // Corrections below this share of a diameter end the rounds.
constexpr double kPairMargin = 0.2;     // Pairs this much farther apart than a diameter may still meet.
constexpr double kReported = 0.1;       // Overlap that counts, as a share of the diameter.

}  // namespace

double Contacts::separatePairs(double diameter, std::span<Vec2> positions) const {
    double worst = 0.0;
    const double touching = diameter * diameter;
    for (const NearPair pair : pairs_) {
        Vec2& a = positions[static_cast<std::size_t>(pair.a)];
        Vec2& b = positions[static_cast<std::size_t>(pair.b)];
        const Vec2 between = b - a;
        const double d2 = lengthSquared(between);
        if (d2 >= touching) continue;
        const double d = std::sqrt(d2);
        const double depth = diameter - d;
        // Two in one spot part along a direction that their numbers choose.
        const Vec2 away = d > 1e-9 ? between / d : (((pair.a + pair.b) & 1) != 0 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0});
        a -= away * (0.5 * depth);
        b += away * (0.5 * depth);
        worst = std::max(worst, depth);
    }
    return worst;
}

double Contacts::leaveObstacles(double radius, const Environment& environment, std::span<Vec2> positions) const {
    double worst = 0.0;
    for (const std::int32_t index : nearObstacle_) {
        Vec2& p = positions[static_cast<std::size_t>(index)];
        const Vec2 free = environment.pushOut(p, radius);
        if (free == p) continue;
        worst = std::max(worst, distance(p, free));
        p = free;
    }
    return worst;
}

// Pairs may have pushed somebody farther than the rounds watch: obstacles and the world's edge have the last word.
void Contacts::leaveForGood(double radius, const Environment& environment, std::span<Vec2> positions) const {
    const Box inside = environment.def().box.grown(-radius);
    for (Vec2& p : positions)
        if (!inside.contains(p) || environment.distanceToObstacle(p, radius) < radius) p = environment.pushOut(p, radius);
}

// Pairs are found anew: corrections may have brought together who was far apart before.
ContactReport Contacts::report(double diameter, std::span<const Vec2> positions) {
    ContactReport result;
    neighbours_.findPairs(positions, diameter, pairs_);
    for (const NearPair pair : pairs_) {
        const double d = distance(positions[static_cast<std::size_t>(pair.a)], positions[static_cast<std::size_t>(pair.b)]);
        const double share = (diameter - d) / diameter;
        result.worstPenetration = std::max(result.worstPenetration, share);
        if (share > kReported) ++result.overlapPairs;
    }
    return result;
}

// Notes who is near whom and near an obstacle, and where they are.
void Contacts::look(double radius, const Environment& environment, std::span<const Vec2> positions) {
    const double diameter = 2.0 * radius;
    neighbours_.findPairs(positions, diameter * (1.0 + kPairMargin), pairs_);
    nearObstacle_.clear();
    const double watch = radius + diameter;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (environment.distanceToObstacle(positions[i], watch) < watch)
            nearObstacle_.push_back(static_cast<std::int32_t>(i));
    seenAt_.assign(positions.begin(), positions.end());
}

// True where somebody was pushed so far that others than those noted may be near.
bool Contacts::outdated(double diameter, std::span<const Vec2> positions) const {
    const double most = 0.5 * kPairMargin * diameter;
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (lengthSquared(positions[i] - seenAt_[i]) > most * most) return true;
    return false;
}

ContactReport Contacts::resolve(const ContactDef& def, const Environment& environment, std::span<Vec2> positions) {
    const double diameter = 2.0 * def.radius;
    look(def.radius, environment, positions);
    for (std::int32_t round = 0; round < def.iterations; ++round) {
        const double pairs = separatePairs(diameter, positions);
        const double walls = leaveObstacles(def.radius, environment, positions);
        const bool anew = outdated(diameter, positions);
        if (!anew && std::max(pairs, walls) < kSettled * diameter) break;
        if (anew) look(def.radius, environment, positions);
    }
    leaveForGood(def.radius, environment, positions);
    return report(diameter, positions);
}

}  // namespace muster
