// Steering: a PD controller from the planned path to the next velocity (paper section 6.2.1, SPEC A6).
#pragma once

#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/body_axes.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/give_way.h"
#include "engine/steering/go_past.h"
#include "engine/steering/headway.h"
#include "engine/steering/near_rows.h"
#include "engine/steering/overtaking.h"
#include "engine/steering/right_of_way.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Goals of all characters, one entry per character.
struct SteeringInput {
    std::span<const Vec2> place;  ///< Position of its place [m]; its own position for unmatched characters.
    std::span<const Vec2> placeVelocity;  ///< Velocity of its place [m/s].
    std::span<const Vec2> facing;         ///< Unit heading of its formation, which it takes when standing.
    std::span<const GroupClaim> groups = {};  ///< One entry per group; empty where no group has an order.
    std::uint32_t step = 0;                   ///< Number of the step.
    std::span<const double> pace = {};  ///< Share of its top speed at which it walks; empty for all of it.
    /// Additional distance at which it may stand from a place that others share [m]; empty where none is
    /// shared.
    std::span<const double> room = {};
    /// 1 for a character that comes to a stand at `place` without holding one; empty where none does.
    std::span<const std::uint8_t> stands = {};
};

/// Computes next velocities and headings from the present state only, so that the order of characters does
/// not matter.
class Steering {
public:
    /// Reads `now`, of which it writes the claims only, and writes the next velocity [m/s] and heading of
    /// each character; a character that is moved from outside keeps its velocity. The same bits with and
    /// without a pool.
    void run(const CrowdBodies& bodies, Characters& now, const SteeringInput& input,
             const Environment& environment, double dt, std::span<Vec2> velocity, std::span<Vec2> heading,
             ThreadPool* pool = nullptr);

    /// Top speeds of the characters at the last run, on their ground [m/s].
    std::span<const double> topSpeeds() const { return topSpeed_; }
    /// Axes of the characters that lay, leant or were about to at the last run.
    const BodyAxes& axes() const { return axes_; }
    /// Velocities that the characters aimed at in the last run [m/s].
    std::span<const Vec2> preferred() const { return preferred_; }
    /// Close pairs of the last run, at its positions.
    const NeighbourList& neighbours() const { return neighbours_; }

private:
    void aim(const CrowdBodies& bodies, const Characters& now, const SteeringInput& input,
             const GroundSample& ground, std::size_t i);
    void standStill(std::span<const Claim> claims);

    GiveWay giveWay_;
    NearRows rows_;
    RightOfWay right_;
    GoPast goPast_;
    Overtaking overtaking_;
    Headway headway_;
    BodyAxes axes_;
    NeighbourList neighbours_;
    std::vector<Vec2> preferred_;         // Preferred velocities [m/s].
    std::vector<Vec2> turned_;            // Preferred velocities, turned past others [m/s].
    std::vector<double> topSpeed_;        // Top speeds [m/s].
    std::vector<std::uint8_t> standing_;  // By character: 1 if it stays where it is; empty where none does.
};

}  // namespace muster
