// Nobody enters another or an obstacle (SPEC A6): positions are corrected by projection.
#pragma once

#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "crowd/neighbours.h"
#include "environment/environment.h"
#include "muster/characters.h"

namespace muster {

/// How contacts are resolved.
struct ContactDef {
    double radius = 0.25;  ///< Of a character [m] > 0.
    /// Rounds over all contacts >= 1; ends early once nothing is left to correct.
    std::int32_t iterations = 8;
};

/// Corrects positions in place: pairs by halves in a fixed order, then obstacles, which have the last word.
class Contacts {
public:
    /// Moves `positions` apart and out of obstacles and reports what is left. `known` pairs save a search as
    /// long as nobody is farther from where they were found than they leave room for.
    ContactReport resolve(const ContactDef& def, const Environment& environment, std::span<Vec2> positions,
                          const KnownPairs& known = {}, ThreadPool* pool = nullptr);

private:
    // Somebody near an obstacle or the edge of the world.
    struct NearObstacle {
        std::int32_t index;
        // Known to be left where it is here; nowhere at first.
        Vec2 free{std::numeric_limits<double>::quiet_NaN(), 0.0};
    };

    double separatePairs(double diameter, std::span<Vec2> positions);
    double leaveObstacles(double radius, const Environment& environment, std::span<Vec2> positions);
    void leaveForGood(double radius, const Environment& environment, std::span<Vec2> positions);
    ContactReport report(double diameter, std::span<const Vec2> positions);
    void look(double diameter, std::span<const Vec2> positions);
    void watchObstacles(double radius, const Environment& environment, std::span<const Vec2> positions,
                        ThreadPool* pool);
    double roomSquared(double diameter) const;
    bool outdated(double diameter, std::span<const Vec2> positions) const;
    bool outdatedSince(double diameter, std::span<const Vec2> positions);

    NeighbourGrid neighbours_;
    std::vector<NearPair> found_;
    std::vector<Vec2> foundAt_;
    KnownPairs pairs_;    // Found here, or known before.
    bool moved_ = false;  // Somebody was moved since pairs were last held against positions.
    std::vector<NearObstacle> nearObstacle_;
    std::vector<std::uint8_t> watched_;  // Per character: near one.
};

}  // namespace muster
