// Contacts: nobody enters another or an obstacle (SPEC A6). Positions are corrected by projection, as in
// position-based dynamics (Müller et al. 2007).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "environment/environment.h"
#include "muster/characters.h"
#include "muster/parameters.h"

namespace muster {

/// How contacts are resolved.
struct ContactDef {
    /// Of a character [m], above 0.
    double radius = Parameters::Character{}.radius;
    /// Most Gauss-Seidel iterations over all contacts, 1 or more.
    std::int32_t iterations = Parameters::Contact{}.iterations;
};

/// Where the step began, and how far characters can walk in it, one entry per character; empty for no bounds.
struct ContactBounds {
    std::span<const Vec2> from;     ///< [m]
    std::span<const double> reach;  ///< [m]
};

/// Corrects positions in place: in each iteration first pairs, by halves and in the order of the neighbour
/// list (Gauss-Seidel), then obstacles.
class Contacts {
public:
    /// Moves `positions` apart and out of obstacles and reports what overlaps remain. Nobody gets out of the
    /// reach of `bounds`, except who is pushed by a moving obstacle, and no pair gets deeper than 9 % of a
    /// diameter that was not before, except where an obstacle came over one of the two. `neighbours`, if
    /// given, is used as long as it is valid, which saves a search; it must list pairs nearer than a diameter
    /// or farther.
    ContactReport resolve(const ContactDef& def, const Environment& environment, std::span<Vec2> positions,
                          const NeighbourList* neighbours = nullptr, ThreadPool* pool = nullptr,
                          const ContactBounds& bounds = {});

private:
    // A character near an obstacle or the edge of the world.
    struct ObstacleCandidate {
        std::int32_t index;
        // A position that is known to be free; NaN where none is.
        Vec2 free{std::numeric_limits<double>::quiet_NaN(), 0.0};
    };

    double separatePairs(double diameter, std::span<Vec2> positions);
    double leaveObstacles(double radius, const Environment& environment, std::span<Vec2> positions);
    void leaveObstaclesFinally(double radius, const Environment& environment, std::span<Vec2> positions);
    void takeBack(double radius, const Environment& environment, std::span<Vec2> positions);
    bool takeBackOne(double radius, const Environment& environment, std::int32_t character,
                     std::span<Vec2> positions);
    Vec2 withinReach(std::size_t character, Vec2 position) const;
    bool isWedged(double radius, const Environment& environment, std::int32_t character) const;
    Vec2 walkOut(double radius, const Environment& environment, std::size_t character, Vec2 free) const;
    ContactReport report(double diameter, std::span<const Vec2> positions);
    void findPairs(double diameter, std::span<const Vec2> positions);
    void findObstacleCandidates(double radius, const Environment& environment,
                                std::span<const Vec2> positions, ThreadPool* pool);
    double slack(double diameter) const;
    bool outdatedByCorrections(double diameter, std::span<const Vec2> positions);

    ContactBounds bounds_;  // Of the present call.
    NeighbourList ownPairs_;
    const NeighbourList* pairs_ = nullptr;  // Given by the caller, or ownPairs_.
    bool corrected_ = false;  // True where a position was corrected since pairs_ was last checked.
    std::vector<ObstacleCandidate> obstacleCandidates_;
    std::vector<std::uint8_t> nearObstacle_;  // Per character, 1 for candidates.
};

}  // namespace muster
