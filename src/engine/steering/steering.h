// Steering: a PD controller from the planned path to the next velocity (paper section 6.2.1, SPEC A6).
#pragma once

#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "engine/ground/environment/environment.h"
#include "engine/steering/body_axes.h"
#include "engine/steering/characters.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/give_way.h"
#include "engine/steering/go_past.h"
#include "engine/steering/headway.h"
#include "engine/steering/near_rows.h"
#include "engine/steering/overtaking.h"
#include "engine/steering/right_of_way.h"
#include "muster/parameters.h"

namespace muster {

/// What each character follows, one entry per character.
struct SteeringInput {
    std::span<const Vec2> place;          ///< Position of its place [m]; its own position for the unmatched.
    std::span<const Vec2> placeVelocity;  ///< Velocity of its place [m/s].
    std::span<const Vec2> facing;         ///< Unit heading of its formation, which it takes when standing.
    std::span<const GroupClaim> groups = {};  ///< One entry per group; empty where nobody has an order.
    std::uint32_t step = 0;                   ///< Number of the step.
    std::span<const double> pace = {};        ///< Share of its top speed at which it walks; empty for all.
    std::span<const double> room = {};  ///< By how much farther it may stand from a place that others share
                                        ///< [m]; empty where none is shared.
    /// 1 for who comes to a stand at `place` without holding one; empty where nobody does.
    std::span<const std::uint8_t> stands = {};
};

/// Computes next velocities and headings from the present state only, so the order of characters cannot
/// matter.
class Steering {
public:
    /// Reads `now`, of which it writes the claims only, and writes the next velocity [m/s] and heading (one
    /// per character): of who is moved from outside the velocity that it has. The same bits with and without
    /// a pool.
    void run(const CrowdBodies& bodies, Characters& now, const SteeringInput& input,
             const Environment& environment, double dt, std::span<Vec2> velocity, std::span<Vec2> heading,
             ThreadPool* pool = nullptr);

    /// Of each character at the last run, on its ground [m/s].
    std::span<const double> topSpeeds() const { return topSpeed_; }
    /// Of those who lay, leant or were about to at the last run.
    const BodyAxes& axes() const { return axes_; }
    /// Of each character at the last run, the velocity that it aimed at [m/s].
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
    std::vector<Vec2> turned_;            // The same, turned past others [m/s].
    std::vector<double> topSpeed_;        // [m/s]
    std::vector<std::uint8_t> standing_;  // 1 for who stays where it is; empty where nobody does.
};

}  // namespace muster
