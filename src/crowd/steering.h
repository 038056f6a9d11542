// Steering: a PD controller from the planned path to the next velocity (paper section 6.2.1, SPEC A6).
#pragma once

#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "crowd/characters.h"
#include "environment/environment.h"

namespace muster {

/// Gains and bounds of movement.
struct SteeringDef {
    double radius = 0.25;        ///< Of a character [m], above 0.
    double maxSpeed = 2.0;       ///< In the open [m/s], above 0; multiplied by the ground's travel speed.
    double acceleration = 10.0;  ///< Bound on the change of velocity [m/s^2], above 0.
    double velocityGain = 12.0;  ///< Derivative gain of the PD controller [1/s], above 0.
    double positionGain = 3.0;   ///< Proportional gain near the place [1/s], above 0.
    double
        directReach = 1.5;  ///< Within this distance of its place a character heads for the place itself [m].
    double separationGain = 1.0;  ///< Separation velocity per metre of gap that is missing [1/s], 0 or more.
    double separationReach = 0.15;  ///< Gap between two bodies below which they separate [m], 0 or more.
};

/// What each character follows, one entry per character.
struct SteeringInput {
    std::span<const Vec2> place;          ///< Position of its place [m]; its own position for the unmatched.
    std::span<const Vec2> placeVelocity;  ///< Velocity of its place [m/s].
    std::span<const Vec2> facing;         ///< Unit heading of its formation, which it takes when standing.
};

/// Computes next velocities and headings from the present state only, so the order of characters cannot
/// matter.
class Steering {
public:
    /// Reads `now`, writes the next velocity [m/s] and heading (one per character). The same bits with and
    /// without a pool.
    void run(const SteeringDef& def, const Characters& now, const SteeringInput& input,
             const Environment& environment, double dt, std::span<Vec2> velocity, std::span<Vec2> heading,
             ThreadPool* pool = nullptr);

    /// Close pairs of the last run, at its positions.
    const NeighbourList& neighbours() const { return neighbours_; }

private:
    void addSeparationSteering(const SteeringDef& def, const Characters& now);
    void yieldToBlocked(const SteeringDef& def, const Characters& now);

    NeighbourList neighbours_;
    std::vector<Vec2> preferred_;   // Preferred velocities [m/s].
    std::vector<double> topSpeed_;  // [m/s]
};

}  // namespace muster
