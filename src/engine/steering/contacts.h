// Contacts: no character enters another or an obstacle (SPEC A6). Positions are corrected by projection, as
// in position-based dynamics (Müller et al. 2007).
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/body_axes.h"
#include "engine/steering/crowd_bodies.h"
#include "muster/generated/characters.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Positions at the beginning of the step and the reach in it, one entry per character; empty for no bounds.
struct ContactBounds {
    std::span<const Vec2> from;     ///< [m]
    std::span<const double> reach;  ///< [m]
};

/// Corrects positions in place: in each iteration first pairs, in the order of the neighbour list
/// (Gauss-Seidel), then obstacles. Two characters share a correction by their inverse masses, equal ones by
/// halves.
class Contacts {
public:
    /// Moves `positions` apart and out of obstacles and reports the overlaps that remain. No character leaves
    /// the reach of `bounds`, except where a moving obstacle pushes it. No pair gets deeper than 9 % of its
    /// mean diameter that was not before, except where an obstacle came over one of the two, or one is fixed.
    /// `neighbours`, if given, is used as long as it is valid, which saves a search; it must list pairs
    /// nearer than the largest diameter or farther. `bodies`, if given, are those of all characters, which
    /// are all equal to `usual` otherwise: a fixed character is not moved, not even by obstacles. `axes`, if
    /// given, keep bodies that lie apart as well, as far as the rest allows.
    ContactReport resolve(const Parameters::Contact& def, const Parameters::Character& usual,
                          const Environment& environment, std::span<Vec2> positions,
                          const NeighbourList* neighbours = nullptr, ThreadPool* pool = nullptr,
                          const ContactBounds& bounds = {}, const CrowdBodies* bodies = nullptr,
                          const BodyAxes* axes = nullptr);

private:
    // A character near an obstacle or the edge of the world.
    struct ObstacleCandidate {
        std::int32_t index;
        // A position that is known to be free; NaN where none is known.
        Vec2 free{std::numeric_limits<double>::quiet_NaN(), 0.0};
    };

    template <bool kAlike>
    double separatePairs(std::span<Vec2> positions);
    double separateAxes(std::span<Vec2> positions);
    double leaveObstacles(const Environment& environment, std::span<Vec2> positions);
    void leaveObstaclesFinally(const Environment& environment, std::span<Vec2> positions);
    void takeBack(const Environment& environment, std::span<Vec2> positions);
    bool takeBackOne(const Environment& environment, std::int32_t character, std::span<Vec2> positions);
    Vec2 withinReach(std::size_t character, Vec2 position) const;
    bool isWedged(const Environment& environment, std::int32_t character) const;
    Vec2 walkOut(double radius, const Environment& environment, std::size_t character, Vec2 free) const;
    ContactReport report(std::span<const Vec2> positions);
    void findPairs(std::span<const Vec2> positions);
    void findClose(std::span<const Vec2> positions);
    void findCloseToPushed(std::span<const Vec2> positions);
    void findObstacleCandidates(const Environment& environment, std::span<const Vec2> positions,
                                ThreadPool* pool);
    double slack() const;
    bool outdatedByCorrections(std::span<const Vec2> positions);

    // Inputs of the present call.
    ContactBounds bounds_;
    CrowdBodies alike_;
    const CrowdBodies* bodies_ = nullptr;  // Bodies given by the caller, or alike_.
    const BodyAxes* axes_ = nullptr;       // Axes given by the caller; null where no body lies.
    double diameter_ = 0.0;                // Largest diameter [m].

    NeighbourList ownPairs_;
    const NeighbourList* pairs_ = nullptr;  // Pairs given by the caller, or ownPairs_.
    std::vector<NeighbourPair> close_;      // Pairs that may touch in this step, in the order of pairs_.
    // Distance from the beginning of the step that no character of close_ exceeds [m].
    double farthest_ = 0.0;
    bool corrected_ = false;  // True if a position was corrected since pairs_ was last checked.
    std::vector<ObstacleCandidate> obstacleCandidates_;
    std::vector<std::uint8_t> nearObstacle_;  // Per character, 1 for candidates.
};

}  // namespace muster
