// Ordered headway: the one rule by which characters keep clear of each other and of obstacles
// (docs/method/right-of-way.md). Two characters share the change of velocity that keeps them clear: where
// they meet, the one with the right of way takes the less of it the less it gets on; behind a character that
// does not get on the other one keeps its headway (Tordeux et al. 2016).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/right_of_way.h"

namespace muster {

/// Velocities and claims of all characters in one step, one entry per character.
struct HeadwayInput {
    std::span<const Vec2> wanted;       ///< Velocity that each wants along its own path [m/s].
    std::span<const Vec2> turned;       ///< Wanted velocity, turned to overtake [m/s].
    std::span<const double> topSpeed;   ///< Top speed on its ground [m/s].
    std::span<const Claim> claims;      ///< Claim of each character.
    const RightOfWay* right = nullptr;  ///< Right of way; null where no character is blocked.
    double dt = 1.0 / 60.0;             ///< Length of the step [s].
};

/// Geometry of two characters.
struct Apart {
    Vec2 between, towards;  ///< Vector from the first to the other [m], and as a unit vector.
    double distance;        ///< Distance of their centres [m].
    double touching;        ///< Distance of their centres where they touch [m].

    double gap() const { return distance - touching; }  ///< Gap between their bodies [m].
    /// The geometry from the other to the first.
    Apart reversed() const { return {-between, -towards, distance, touching}; }
};

/// A limit on the closing velocity of two characters: n.v <= most.
struct Tangent {
    Vec2 towards;       ///< The unit vector n.
    double most = 0.0;  ///< [m/s]
};

/// Finds the velocities nearest to given ones that keep all headways: projected Gauss-Seidel over linear
/// constraints, in the order of pairs.
class Headway {
public:
    /// Changes `velocity` [m/s], which each character would have alone.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, const HeadwayInput& input, std::span<Vec2> velocity);
    /// Flags of the last run: 1 if a character kept behind one that goes the same way, out of step.
    std::span<const std::uint8_t> queues() const { return queues_; }

private:
    // One constraint on velocities: on `back` alone, or shared with `front`.
    struct Limit {
        std::int32_t back, front;  // front is -1 for a wall.
        Vec2 towards;              // Unit vector from back to front.
        double most;               // Limit of the closing speed [m/s].
        double share;              // Share of `back` in a shared constraint; 1 where it takes all.
        double follow;             // Share of the speed of `front` that adds to `most`.
        bool queues = false;       // True if both go the same way, out of step.
        double pressed = 0.0;      // Multiplier [m/s].
    };

    std::span<const NeighbourPair> findMeetings(const Characters& now, const NeighbourList& neighbours,
                                                std::span<const Vec2> velocity);
    void follow(std::int32_t back, std::int32_t front, Vec2 towards, double gap, bool queues,
                std::span<const Vec2> velocity);
    void share(NeighbourPair pair, double own, const Tangent& tangent, double ahead,
               std::span<const Vec2> velocity);
    double shareOf(NeighbourPair pair, const HeadwayInput& input) const;
    void meet(NeighbourPair pair, const Apart& two, const HeadwayInput& input,
              std::span<const Vec2> velocity);
    void keepBehind(const Apart& two, std::int32_t back, std::int32_t front, Vec2 heading,
                    std::span<const Vec2> velocity);
    void goTogether(const Characters& now, NeighbourPair pair, const Apart& two, const HeadwayInput& input,
                    std::span<const Vec2> velocity);
    void findHeadings(const HeadwayInput& input);
    void addPair(const Characters& now, NeighbourPair pair, const HeadwayInput& input,
                 std::span<const Vec2> velocity);
    void addWalls(const Characters& now, const Environment& environment, std::span<const Vec2> velocity);

    // Makes one sweep; returns the largest change of a multiplier [m/s].
    double relax(std::span<Vec2> velocity);
    void findQueues(std::size_t count);

    const CrowdBodies* bodies_ = nullptr;  // Bodies of the present run.
    double dt_ = 0.0;                      // Length of the step [s].
    double inStep_ = 1.0;                  // Share of the speed ahead.
    std::vector<Vec2> lead_;               // By character: wanted velocity as a share of its top speed.
    std::vector<Vec2> heading_;            // By character: unit vector of its wanted velocity, turned.
    std::vector<NeighbourPair> meetings_;  // Pairs that may come near a limit; the memory only grows.
    std::vector<Limit> limits_;
    std::vector<std::uint8_t> nearObstacle_;
    std::vector<std::uint8_t> queues_;
};

}  // namespace muster
