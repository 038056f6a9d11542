#include "crowd/contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {
namespace {

constexpr double kSettled = 1e-4;     // Corrections below this share of a diameter end the rounds.
constexpr double kPairMargin = 0.2;   // Pairs this much farther apart than a diameter may still meet.
constexpr double kReported = 0.1;     // Overlap that counts, as a share of the diameter.
constexpr std::size_t kChunk = 1024;  // Characters a task looks round.

}  // namespace

double Contacts::separatePairs(double diameter, std::span<Vec2> positions) {
    double worst = 0.0;
    const double touching = diameter * diameter;
    for (const NearPair pair : pairs_.pairs) {
        Vec2& a = positions[pair.a];
        Vec2& b = positions[pair.b];
        const Vec2 between = b - a;
        const double d2 = lengthSquared(between);
        if (d2 >= touching) continue;
        const double d = std::sqrt(d2);
        const double depth = diameter - d;
        // Two in one spot part along a direction that their numbers choose.
        const Vec2 away = d > 1e-9 ? between / d
                                   : (((pair.a + pair.b) & 1) != 0 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0});
        a -= away * (0.5 * depth);
        b += away * (0.5 * depth);
        worst = std::max(worst, depth);
        moved_ = true;
    }
    return worst;
}

double Contacts::leaveObstacles(double radius, const Environment& environment, std::span<Vec2> positions) {
    double worst = 0.0;
    for (NearObstacle& near : nearObstacle_) {
        Vec2& p = positions[near.index];
        if (p == near.free) continue;
        const Vec2 free = environment.projectToFreeSpace(p, radius);
        if (free == p) {
            near.free = p;
            continue;
        }
        worst = std::max(worst, distance(p, free));
        p = free;
        moved_ = true;
    }
    return worst;
}

// Pairs may have pushed somebody since: obstacles and the world's edge have the last word.
void Contacts::leaveForGood(double radius, const Environment& environment, std::span<Vec2> positions) {
    const Box inside = environment.def().box.grown(-radius);
    for (const NearObstacle& near : nearObstacle_) {
        Vec2& p = positions[near.index];
        if (p == near.free) continue;
        if (inside.contains(p) && !(environment.distanceToObstacle(p, radius) < radius)) continue;
        p = environment.projectToFreeSpace(p, radius);
        moved_ = true;
    }
}

// Looks for pairs anew where corrections may have brought together who was far apart before.
ContactReport Contacts::report(double diameter, std::span<const Vec2> positions) {
    ContactReport result;
    if (outdatedSince(diameter, positions)) look(diameter, positions);
    for (const NearPair pair : pairs_.pairs) {
        const double d2 = lengthSquared(positions[pair.a] - positions[pair.b]);
        if (d2 >= diameter * diameter) continue;
        const double share = (diameter - std::sqrt(d2)) / diameter;
        result.worstPenetration = std::max(result.worstPenetration, share);
        if (share > kReported) ++result.overlapPairs;
    }
    return result;
}

// Notes who is near whom, and where.
void Contacts::look(double diameter, std::span<const Vec2> positions) {
    const double reach = diameter * (1.0 + kPairMargin);
    neighbours_.findPairs(positions, reach, found_);
    foundAt_.assign(positions.begin(), positions.end());
    pairs_ = {found_, foundAt_, reach};
}

// Notes who is near an obstacle or the edge of the world: so near that nobody else comes to one while pairs
// hold.
void Contacts::watchObstacles(double radius, const Environment& environment, std::span<const Vec2> positions,
                              ThreadPool* pool) {
    watched_.resize(positions.size());
    forChunks(pool, (positions.size() + kChunk - 1) / kChunk, 1, [&](std::size_t chunk) {
        const std::size_t first = chunk * kChunk, count = std::min(kChunk, positions.size() - first);
        environment.markNearObstacles(positions.subspan(first, count), 3.0 * radius,
                              std::span(watched_).subspan(first, count));
    });
    nearObstacle_.clear();
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (watched_[i] != 0) nearObstacle_.push_back({static_cast<std::int32_t>(i)});
}

// How far somebody may go from where pairs were found before others than those noted may be near, squared.
double Contacts::roomSquared(double diameter) const {
    const double most = std::clamp(0.5 * (pairs_.reach - diameter), 0.0, 0.5 * diameter);
    return most * most;
}

// True where somebody moved so far that others than those noted may be near.
bool Contacts::outdated(double diameter, std::span<const Vec2> positions) const {
    if (pairs_.at.size() != positions.size()) return true;
    const double most = roomSquared(diameter);
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (!(lengthSquared(positions[i] - pairs_.at[i]) <= most)) return true;
    return false;
}

// As outdated(), where it was false before and only corrections moved anybody since.
bool Contacts::outdatedSince(double diameter, std::span<const Vec2> positions) {
    if (!std::exchange(moved_, false)) return false;
    if (2 * pairs_.pairs.size() + nearObstacle_.size() > positions.size())
        return outdated(diameter, positions);
    const double most = roomSquared(diameter);
    const auto left = [&](std::int32_t index) {
        const auto i = static_cast<std::size_t>(index);
        return !(lengthSquared(positions[i] - pairs_.at[i]) <= most);
    };
    for (const NearPair pair : pairs_.pairs)
        if (left(pair.a) || left(pair.b)) return true;
    for (const NearObstacle& near : nearObstacle_)
        if (left(near.index)) return true;
    return false;
}

ContactReport Contacts::resolve(const ContactDef& def, const Environment& environment,
                                std::span<Vec2> positions, const KnownPairs& known, ThreadPool* pool) {
    const double diameter = 2.0 * def.radius;
    pairs_ = known;
    if (outdated(diameter, positions)) look(diameter, positions);
    moved_ = false;
    watchObstacles(def.radius, environment, positions, pool);
    for (std::int32_t round = 0; round < def.iterations; ++round) {
        const double pairs = separatePairs(diameter, positions);
        const double walls = leaveObstacles(def.radius, environment, positions);
        const bool anew = outdatedSince(diameter, positions);
        if (!anew && std::max(pairs, walls) < kSettled * diameter) break;
        if (!anew) continue;
        look(diameter, positions);
        watchObstacles(def.radius, environment, positions, pool);
    }
    leaveForGood(def.radius, environment, positions);
    const ContactReport left = report(diameter, positions);
    pairs_ = {};
    return left;
}

}  // namespace muster
