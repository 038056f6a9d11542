#include "engine/steering/contacts.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace muster {
namespace {

constexpr double kConverged = 1e-4;      // Share of a diameter below which corrections end the iteration.
constexpr double kPairSkin = 0.2;        // Skin of the pair list, as a share of the diameter.
constexpr double kReported = 0.1;        // Share of the diameter above which overlaps are counted.
constexpr double kDeepest = 0.09;        // Share of the diameter above which overlaps are taken back.
constexpr double kFreeTolerance = 1e-3;  // Depth in an obstacle down to which a character is free [m].
// Factor of the reach up to which sliding along an obstacle may go.
constexpr double kReachTolerance = 1.005;
constexpr double kWedgeSlack = 0.9e-3;  // Length by which a body is thinner in a gap as wide as itself [m].
constexpr double kWedgeReach = 0.02;   // Distance to a body within which walls on either side make a gap [m].
constexpr double kWedgeCosine = -0.5;  // Cosine below which two walls lie on different sides of a body.
constexpr double kRounding = 1e-6;     // Upper bound of the rounding of sums of positions [m].
constexpr std::size_t kClosePerCharacter = 4;  // Reserved number of pairs that may touch, per character.
constexpr int kReachRounds = 4;                // Number of projections between obstacle and reach.
constexpr std::size_t kMarkedPerTask = 1024;   // Number of characters per task.

}  // namespace

// The position, or the point where the line to it from the beginning of the step leaves the reach.
Vec2 Contacts::withinReach(std::size_t character, Vec2 position) const {
    if (bounds_.reach.empty()) return position;
    const Vec2 from = bounds_.from[character];
    const double reach = bounds_.reach[character];
    const Vec2 way = position - from;
    return lengthSquared(way) <= reach * reach ? position : from + clampLength(way, reach);
}

template <bool kAlike>
double Contacts::separatePairs(std::span<Vec2> positions) {
    double worst = 0.0;
    for (const NeighbourPair pair : close_) {
        const double touching = kAlike ? diameter_ : bodies_->touching(pair.low, pair.high);
        Vec2& a = positions[pair.low];
        Vec2& b = positions[pair.high];
        const Vec2 between = bodies_->between(a, b);
        const double d2 = lengthSquared(between);
        if (d2 >= touching * touching) continue;
        const double d = std::sqrt(d2);
        const double depth = touching - d;
        // Coincident characters separate along an axis that follows from their indices.
        const Vec2 away = d > 1e-9 ? between / d
                                   : (((pair.low + pair.high) & 1) != 0 ? Vec2{1.0, 0.0} : Vec2{0.0, 1.0});
        const double shareA = kAlike ? 0.5 : bodies_->share(pair.low, pair.high);
        const double shareB = kAlike ? 0.5 : bodies_->share(pair.high, pair.low);
        if (shareA > 0.0) a = withinReach(pair.low, a - away * (shareA * depth));
        if (shareB > 0.0) b = withinReach(pair.high, b + away * (shareB * depth));
        if (shareA + shareB == 0.0) continue;
        worst = std::max(worst, kAlike ? depth : depth * (diameter_ / touching));
        corrected_ = true;
    }
    return worst;
}

// Bodies that lie keep apart by their length.
double Contacts::separateAxes(std::span<Vec2> positions) {
    if (axes_ == nullptr) return 0.0;
    return axes_->forOverlaps(positions, [&](std::int32_t a, Vec2 moveA, std::int32_t b, Vec2 moveB) {
        const bool fixedA = bodies_->isFixed(a), fixedB = bodies_->isFixed(b);
        if (!fixedA) positions[a] = withinReach(a, positions[a] + moveA - (fixedB ? moveB : Vec2{}));
        if (!fixedB) positions[b] = withinReach(b, positions[b] + moveB - (fixedA ? moveA : Vec2{}));
        corrected_ = true;
    });
}

double Contacts::leaveObstacles(const Environment& environment, std::span<Vec2> positions) {
    double worst = 0.0;
    for (ObstacleCandidate& candidate : obstacleCandidates_) {
        Vec2& p = positions[candidate.index];
        if (p == candidate.free) continue;
        const double radius = bodies_->radius(candidate.index);
        Vec2 free = environment.projectToFreeSpace(p, radius);
        if (free != p && isWedged(environment, candidate.index))
            free = environment.projectToFreeSpace(p, radius - kWedgeSlack);
        if (free == p) {
            candidate.free = p;
            continue;
        }
        worst = std::max(worst, distance(p, free));
        p = withinReach(candidate.index, free);
        corrected_ = true;
    }
    return worst;
}

// True where the character began the step in a gap about as wide as itself. Routes lead through gaps that are
// narrower by a hair, because they run along walls.
bool Contacts::isWedged(const Environment& environment, std::int32_t character) const {
    if (bounds_.from.empty()) return false;
    const double radius = bodies_->radius(character);
    const Vec2 from = bounds_.from[character];
    Vec2 first;
    bool wedged = false;
    environment.forPiecesNear(from, radius + kWedgeReach, [&](const ObstaclePiece& piece) {
        const SurfacePoint nearest = closestSurfacePoint(piece, from);
        if (piece.moving || nearest.distance > radius + kWedgeReach) return;
        const Vec2 towards = normalized(nearest.point - from);
        wedged = wedged || dot(first, towards) < kWedgeCosine;
        if (first == Vec2{}) first = towards;
    });
    return wedged;
}

// The end of the step of a character whose nearest free point is `free`. A character walks out of an obstacle
// that was put on it; a moving obstacle pushes it. Where no free point is within reach it stays where it
// began.
Vec2 Contacts::walkOut(double radius, const Environment& environment, std::size_t character,
                       Vec2 free) const {
    Vec2 end = withinReach(character, free);
    if (end == free) return free;
    const Vec2 from = bounds_.from[character];
    bool wasFree = true, pushed = false;
    environment.forPiecesNear(from, radius, [&](const ObstaclePiece& piece) {
        if (piece.signedDistance(from) >= radius - kFreeTolerance) return;
        wasFree = false;
        pushed = pushed || piece.moving;
    });
    if (pushed) return free;
    if (!wasFree) return end;
    const double most = kReachTolerance * bounds_.reach[character];
    for (int round = 0; round < kReachRounds; ++round) {
        free = environment.projectToFreeSpace(end, radius);
        if (distance(free, from) <= most) return free;
        end = withinReach(character, free);
    }
    return from;
}

// Takes characters out of obstacles, which have priority over the corrections of pairs.
void Contacts::leaveObstaclesFinally(const Environment& environment, std::span<Vec2> positions) {
    for (const ObstacleCandidate& candidate : obstacleCandidates_) {
        Vec2& p = positions[candidate.index];
        if (p == candidate.free) continue;
        const double radius = bodies_->radius(candidate.index);
        const Box inside = environment.def().sides().grown(-radius);
        if (inside.contains(p) && !(environment.distanceToObstacle(p, radius) < radius)) continue;
        const bool wedged = isWedged(environment, candidate.index);
        const double width = wedged ? radius - kWedgeSlack : radius;
        p = walkOut(width, environment, candidate.index, environment.projectToFreeSpace(p, width));
        corrected_ = true;
    }
}

// Puts a character back where it began the step; false where it is there already, or where an obstacle is.
bool Contacts::takeBackOne(const Environment& environment, std::int32_t character,
                           std::span<Vec2> positions) {
    const double radius = bodies_->radius(character);
    const Vec2 from = bounds_.from[character];
    Vec2& p = positions[character];
    if (p == from || environment.distanceToObstacle(from, radius) < radius - kFreeTolerance) return false;
    p = from;
    corrected_ = true;
    return true;
}

// The iteration does not always converge in a dense crowd, but no pair was too deep when the step began. Of a
// pair that has become too deep, the character that has come nearer is put back, then the other one, and so
// on with characters that came after them. A character that gets out of the knot goes on.
void Contacts::takeBack(const Environment& environment, std::span<Vec2> positions) {
    for (bool changed = true; changed;) {
        changed = false;
        if (outdatedByCorrections(positions)) findPairs(positions);
        for (const NeighbourPair pair : close_) {
            const double least = (1.0 - kDeepest) * bodies_->touching(pair.low, pair.high);
            const double d2 = lengthSquared(bodies_->between(positions[pair.low], positions[pair.high]));
            const Vec2 between = bodies_->between(bounds_.from[pair.low], bounds_.from[pair.high]);
            if (d2 >= least * least || d2 >= lengthSquared(between)) continue;
            const double low = dot(positions[pair.low] - bounds_.from[pair.low], between);
            const double high = dot(bounds_.from[pair.high] - positions[pair.high], between);
            const auto [nearer, other] = low >= high ? std::pair(pair.low, pair.high)
                                                     : std::pair(pair.high, pair.low);
            changed = takeBackOne(environment, nearer, positions) ||
                      takeBackOne(environment, other, positions) || changed;
        }
    }
}

// Finds pairs again, if corrections may have brought together characters that were far apart before.
ContactReport Contacts::report(std::span<const Vec2> positions) {
    ContactReport result;
    if (outdatedByCorrections(positions)) findPairs(positions);
    for (const NeighbourPair pair : close_) {
        const double touching = bodies_->touching(pair.low, pair.high);
        const double d2 = lengthSquared(bodies_->between(positions[pair.low], positions[pair.high]));
        if (d2 >= touching * touching) continue;
        const double share = (touching - std::sqrt(d2)) / touching;
        result.worstPenetration = std::max(result.worstPenetration, share);
        if (share > kReported) ++result.overlapPairs;
    }
    return result;
}

void Contacts::findPairs(std::span<const Vec2> positions) {
    ownPairs_.build(positions, diameter_, kPairSkin, bodies_->ring());
    bodies_->shorten(positions, ownPairs_);
    pairs_ = &ownPairs_;
    findClose(positions);
}

// Keeps pairs that may touch: within their reach most pairs cannot.
void Contacts::findClose(std::span<const Vec2> positions) {
    const std::span<const NeighbourPair> pairs = pairs_->pairs();
    if (bounds_.from.empty()) {
        farthest_ = std::numeric_limits<double>::infinity();
        close_.assign(pairs.begin(), pairs.end());
        return;
    }
    double reach = 0.0, moved = 0.0;
    for (std::size_t i = 0; i < positions.size(); ++i) {
        reach = std::max(reach, bounds_.reach[i]);
        moved = std::max(moved, lengthSquared(positions[i] - bounds_.from[i]));
    }
    farthest_ = std::max(reach * kReachTolerance, std::sqrt(moved)) + kRounding;
    close_.clear();
    close_.reserve(kClosePerCharacter * positions.size());
    for (const NeighbourPair pair : pairs) {
        const double most = bodies_->touching(pair.low, pair.high) + 2.0 * farthest_;
        if (lengthSquared(bodies_->between(bounds_.from[pair.low], bounds_.from[pair.high])) < most * most)
            close_.push_back(pair);
    }
}

// Adds pairs of characters that an obstacle has pushed farther than the reach of others.
void Contacts::findCloseToPushed(std::span<const Vec2> positions) {
    const bool pushed = std::any_of(
        obstacleCandidates_.begin(), obstacleCandidates_.end(), [&](const ObstacleCandidate& candidate) {
            return distance(positions[candidate.index], bounds_.from[candidate.index]) > farthest_;
        });
    if (pushed) findClose(positions);
}

// Candidates are near enough to an obstacle or the edge of the world that no other character reaches one
// while the pairs are valid.
void Contacts::findObstacleCandidates(const Environment& environment, std::span<const Vec2> positions,
                                      ThreadPool* pool) {
    nearObstacle_.resize(positions.size());
    forChunks(pool, (positions.size() + kMarkedPerTask - 1) / kMarkedPerTask, 1, [&](std::size_t chunk) {
        const std::size_t first = chunk * kMarkedPerTask,
                          count = std::min(kMarkedPerTask, positions.size() - first);
        environment.markNearObstacles(positions.subspan(first, count), 1.5 * diameter_,
                                      std::span(nearObstacle_).subspan(first, count));
    });
    obstacleCandidates_.clear();
    obstacleCandidates_.reserve(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i)
        if (nearObstacle_[i] != 0 && !bodies_->isFixed(i))
            obstacleCandidates_.push_back({static_cast<std::int32_t>(i)});
}

// Distance from where the pairs were found that a character may have [m]: half the skin, and less than would
// miss an obstacle candidate.
double Contacts::slack() const {
    return std::clamp(0.5 * (pairs_->listedReach() - diameter_), 0.0, 0.5 * diameter_);
}

// True where corrections have moved a character far enough that pairs may be missing.
bool Contacts::outdatedByCorrections(std::span<const Vec2> positions) {
    if (!std::exchange(corrected_, false)) return false;
    const double most = slack();
    if (2 * pairs_->pairs().size() + obstacleCandidates_.size() > positions.size())
        return !pairs_->holdsFor(positions, most);
    for (const NeighbourPair pair : pairs_->pairs())
        if (!pairs_->holdsFor(positions, pair.low, most) || !pairs_->holdsFor(positions, pair.high, most))
            return true;
    for (const ObstacleCandidate& candidate : obstacleCandidates_)
        if (!pairs_->holdsFor(positions, candidate.index, most)) return true;
    return false;
}

ContactReport Contacts::resolve(const Parameters::Contact& def, const Parameters::Character& usual,
                                const Environment& environment, std::span<Vec2> positions,
                                const NeighbourList* neighbours, ThreadPool* pool,
                                const ContactBounds& bounds, const CrowdBodies* bodies,
                                const BodyAxes* axes) {
    alike_.reset(usual);
    bodies_ = bodies != nullptr ? bodies : &alike_;
    axes_ = axes != nullptr && !axes->none() ? axes : nullptr;
    diameter_ = 2.0 * bodies_->largestRadius();
    bounds_ = bounds;
    pairs_ = neighbours;
    if (pairs_ == nullptr || !pairs_->holdsFor(positions, slack()))
        findPairs(positions);
    else
        findClose(positions);
    corrected_ = false;
    findObstacleCandidates(environment, positions, pool);
    const bool alike = bodies_->alike();
    for (std::int32_t iteration = 0; iteration < def.iterations; ++iteration) {
        const double axesDepth = separateAxes(positions);
        const double pairs = alike ? separatePairs<true>(positions) : separatePairs<false>(positions);
        const double walls = leaveObstacles(environment, positions);
        const bool outdated = outdatedByCorrections(positions);
        if (!outdated && std::max({axesDepth, pairs, walls}) < kConverged * diameter_) break;
        if (!outdated) continue;
        findPairs(positions);
        findObstacleCandidates(environment, positions, pool);
    }
    leaveObstaclesFinally(environment, positions);
    if (!bounds.from.empty()) {
        findCloseToPushed(positions);
        takeBack(environment, positions);
    }
    return report(positions);
}

}  // namespace muster
