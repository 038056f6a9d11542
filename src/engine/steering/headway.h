// Ordered headway: the one rule by which characters keep clear of each other and of obstacles
// (docs/method/movement.md). Of two who go the same way the one behind keeps its headway to the one ahead
// (Tordeux et al. 2016); of two who do not, the one without the right of way is the one behind.
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
    std::span<const Vec2> wanted;       ///< Velocity that each wants [m/s].
    std::span<const double> topSpeed;   ///< On its ground [m/s].
    const RightOfWay* right = nullptr;  ///< Not null where two meet who do not go the same way.
    double dt = 1.0 / 60.0;             ///< Length of the step [s].
};

/// Finds the velocities nearest to given ones that keep everybody's headway: projected Gauss-Seidel over
/// linear constraints, in the order of pairs.
class Headway {
public:
    /// True where any pair wants to go different ways.
    static bool meets(const NeighbourList& neighbours, std::span<const Vec2> wanted);
    /// Changes `velocity` [m/s], which is what each would do alone.
    void run(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
             const NeighbourList& neighbours, const HeadwayInput& input, std::span<Vec2> velocity);

private:
    // One constraint on velocities: of `back` alone, or shared with `front`.
    struct Limit {
        std::int32_t back, front;  // front is -1 for a wall.
        Vec2 towards;              // Unit vector from back to front.
        double most;               // Of the closing speed [m/s].
        double share;              // Of `back` in a shared one; 1 where it takes all.
        double follow;             // Share of the speed of the one ahead that adds to `most`.
        double pressed = 0.0;      // Multiplier [m/s].
    };

    void addPair(const CrowdBodies& bodies, const Characters& now, NeighbourPair pair,
                 const HeadwayInput& input, std::span<const Vec2> velocity);
    void addWalls(const CrowdBodies& bodies, const Characters& now, const Environment& environment,
                  const HeadwayInput& input, std::span<const Vec2> velocity);
    void addWall(std::int32_t character, Vec2 towards, double gap, Vec2 wallVelocity, double dt,
                 Vec2 velocity);

    std::vector<Limit> limits_;
    std::vector<std::uint8_t> nearObstacle_;
};

}  // namespace muster
