#include "crowd/contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {
namespace {

constexpr double kConverged = 1e-4;           // Corrections below this share of a diameter end the iteration.
constexpr double kPairSkin = 0.2;             // Skin of the pair list, as a share of the diameter.
constexpr double kReported = 0.1;             // Overlaps above this share of the diameter are counted.
constexpr std::size_t kMarkedPerTask = 1024;  // Characters per task.

}  // namespace

double Contacts::separatePairs(double diameter, std::span<Vec2> positions) {
    double worst = 0.0;
    const double touching = diameter * diameter;
    for (const NeighbourPair pair : pairs_->pairs()) {
        Vec2& a = positions[pair.low];
        Vec2& b = positions[pair.high];
        const Vec2 between = b - a;
        const double d2 = lengthSquared(between);
        if (d2 >= touching) continue;
        const double d = std::sqrt(d2);
        const double depth = diameter - d;
        // Coincident characters separate along an axis that their indices choose.
        const Vec2 away = d > 1e-9 ? between / d
                                   : (((pair.low + pair.high) & 1) != 0 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0});
        a -= away * (0.5 * depth);
        b += away * (0.5 * depth);
        worst = std::max(worst, depth);
        corrected_ = true;
    }
    return worst;
}

double Contacts::leaveObstacles(double radius, const Environment& environment, std::span<Vec2> positions) {
    double worst = 0.0;
    for (ObstacleCandidate& candidate : obstacleCandidates_) {
        Vec2& p = positions[candidate.index];
        if (p == candidate.free) continue;
        const Vec2 free = environment.projectToFreeSpace(p, radius);
        if (free == p) {
            candidate.free = p;
            continue;
        }
        worst = std::max(worst, distance(p, free));
        p = free;
        corrected_ = true;
    }
    return worst;
}

// Corrections of pairs may have moved characters into obstacles, which have priority.
void Contacts::leaveObstaclesFinally(double radius, const Environment& environment,
                                     std::span<Vec2> positions) {
    const Box inside = environment.def().box.grown(-radius);
    for (const ObstacleCandidate& candidate : obstacleCandidates_) {
        Vec2& p = positions[candidate.index];
        if (p == candidate.free) continue;
        if (inside.contains(p) && !(environment.distanceToObstacle(p, radius) < radius)) continue;
        p = environment.projectToFreeSpace(p, radius);
        corrected_ = true;
    }
}

// Finds pairs again where corrections may have brought together characters that were far apart before.
ContactReport Contacts::report(double diameter, std::span<const Vec2> positions) {
    ContactReport result;
    if (outdatedByCorrections(diameter, positions)) findPairs(diameter, positions);
    for (const NeighbourPair pair : pairs_->pairs()) {
        const double d2 = lengthSquared(positions[pair.low] - positions[pair.high]);
        if (d2 >= diameter * diameter) continue;
        const double share = (diameter - std::sqrt(d2)) / diameter;
        result.worstPenetration = std::max(result.worstPenetration, share);
        if (share > kReported) ++result.overlapPairs;
    }
    return result;
}

void Contacts::findPairs(double diameter, std::span<const Vec2> positions) {
    ownPairs_.build(positions, diameter, kPairSkin);
    pairs_ = &ownPairs_;
}

// Candidates are so near an obstacle or the edge of the world that nobody else reaches one while the pairs
// are valid.
void Contacts::findObstacleCandidates(double radius, const Environment& environment,
                                      std::span<const Vec2> positions, ThreadPool* pool) {
    nearObstacle_.resize(positions.size());
    forChunks(pool, (positions.size() + kMarkedPerTask - 1) / kMarkedPerTask, 1, [&](std::size_t chunk) {
        const std::size_t first = chunk * kMarkedPerTask,
                          count = std::min(kMarkedPerTask, positions.size() - first);
        environment.markNearObstacles(positions.subspan(first, count), 3.0 * radius,
                                      std::span(nearObstacle_).subspan(first, count));
    });
    obstacleCandidates_.clear();
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (nearObstacle_[i] != 0) obstacleCandidates_.push_back({static_cast<std::int32_t>(i)});
}

// How far a character may be from where the pairs were found [m]: half the skin, and not so far that an
// obstacle candidate is missed.
double Contacts::slack(double diameter) const {
    return std::clamp(0.5 * (pairs_->listedReach() - diameter), 0.0, 0.5 * diameter);
}

// True where a character has been corrected so far that pairs may be missing; only corrections count.
bool Contacts::outdatedByCorrections(double diameter, std::span<const Vec2> positions) {
    if (!std::exchange(corrected_, false)) return false;
    const double most = slack(diameter);
    if (2 * pairs_->pairs().size() + obstacleCandidates_.size() > positions.size())
        return !pairs_->holdsFor(positions, most);
    for (const NeighbourPair pair : pairs_->pairs())
        if (!pairs_->holdsFor(positions, pair.low, most) || !pairs_->holdsFor(positions, pair.high, most))
            return true;
    for (const ObstacleCandidate& candidate : obstacleCandidates_)
        if (!pairs_->holdsFor(positions, candidate.index, most)) return true;
    return false;
}

ContactReport Contacts::resolve(const ContactDef& def, const Environment& environment,
                                std::span<Vec2> positions, const NeighbourList* neighbours,
                                ThreadPool* pool) {
    const double diameter = 2.0 * def.radius;
    pairs_ = neighbours;
    if (pairs_ == nullptr || !pairs_->holdsFor(positions, slack(diameter))) findPairs(diameter, positions);
    corrected_ = false;
    findObstacleCandidates(def.radius, environment, positions, pool);
    for (std::int32_t iteration = 0; iteration < def.iterations; ++iteration) {
        const double pairs = separatePairs(diameter, positions);
        const double walls = leaveObstacles(def.radius, environment, positions);
        const bool outdated = outdatedByCorrections(diameter, positions);
        if (!outdated && std::max(pairs, walls) < kConverged * diameter) break;
        if (!outdated) continue;
        findPairs(diameter, positions);
        findObstacleCandidates(def.radius, environment, positions, pool);
    }
    leaveObstaclesFinally(def.radius, environment, positions);
    return report(diameter, positions);
}

}  // namespace muster
