// Ordered headway: the one rule by which characters keep clear of each other and of obstacles
// (docs/method/right-of-way.md). Two share what keeps them clear: of two who meet, the one with the right of
// way takes the less of it the less it gets on; behind one ahead that does not get on the other one keeps its
// headway (Tordeux et al. 2016).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/characters.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/right_of_way.h"

namespace muster {

/// What all characters want in one step, one entry per character.
struct HeadwayInput {
    std::span<const Vec2> wanted;       ///< Velocity along the own way that each wants [m/s].
    std::span<const Vec2> turned;       ///< The same, turned to overtake [m/s].
    std::span<const double> topSpeed;   ///< On its ground [m/s].
    std::span<const Claim> claims;      ///< How each gets on.
    const RightOfWay* right = nullptr;  ///< Null where nobody is blocked.
    double dt = 1.0 / 60.0;             ///< Length of the step [s].
};

/// How two stand to each other.
struct Apart {
    Vec2 between, towards;  ///< From the first to the other [m], and as a unit vector.
    double distance;        ///< Of their centres [m].
    double touching;        ///< The same where they touch [m].

    double gap() const { return distance - touching; }  ///< Between their bodies [m].
    /// The same from the other to the first.
    Apart reversed() const { return {-between, -towards, distance, touching}; }
};

/// A limit on the closing velocity of two: n.v <= most.
struct Tangent {
    Vec2 towards;       ///< The unit vector n.
    double most = 0.0;  ///< [m/s]
};

/// Finds the velocities nearest to given ones that keep everybody's headway: projected Gauss-Seidel over
/// linear constraints, in the order of pairs.
class Headway {
public:
    /// Changes `velocity` [m/s], which is what each would do alone.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, const HeadwayInput& input, std::span<Vec2> velocity);
    /// Of the last run: 1 for who kept behind somebody who goes the same way, out of step.
    std::span<const std::uint8_t> queues() const { return queues_; }

private:
    // One constraint on velocities: of `back` alone, or shared with `front`.
    struct Limit {
        std::int32_t back, front;  // front is -1 for a wall.
        Vec2 towards;              // Unit vector from back to front.
        double most;               // Of the closing speed [m/s].
        double share;              // Of `back` in a shared one; 1 where it takes all.
        double follow;             // Share of the speed of the one ahead that adds to `most`.
        bool queues = false;       // Both go the same way, out of step.
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

    // One sweep; the largest change of a multiplier [m/s].
    double relax(std::span<Vec2> velocity);
    void findQueues(std::size_t count);

    const CrowdBodies* bodies_ = nullptr;  // Of the present run.
    double dt_ = 0.0;                      // The same [s].
    double inStep_ = 1.0;                  // Share of the speed ahead.
    std::vector<Vec2> lead_;               // Of each, the velocity wanted as a share of its top speed.
    std::vector<Vec2> heading_;            // Of each, the unit vector that it wants to walk along, turned.
    std::vector<NeighbourPair> meetings_;  // Who may come near a limit; room that only grows.
    std::vector<Limit> limits_;
    std::vector<std::uint8_t> nearObstacle_;
    std::vector<std::uint8_t> queues_;
};

}  // namespace muster
