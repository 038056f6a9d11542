// From the way planned to the next velocity (SPEC A6).
#pragma once

#include <span>
#include <vector>

#include "base/parallel.h"
#include "crowd/characters.h"
#include "crowd/neighbours.h"
#include "environment/environment.h"

namespace muster {

/// Gains and bounds of movement.
struct SteeringDef {
    double radius = 0.25;        ///< Of a character [m] > 0.
    double maxSpeed = 2.0;       ///< In the open [m/s] > 0; times the ground's travel speed elsewhere.
    double acceleration = 10.0;  ///< Bound on the change of velocity [m/s^2] > 0.
    double velocityGain = 12.0;  ///< Derivative gain of the PD controller [1/s] > 0.
    double positionGain = 3.0;   ///< Proportional gain near the place [1/s] > 0.
    /// Within it of the place the PD controller aims at the place itself [m].
    double directReach = 1.5;
    double separationGain = 1.0;    ///< Sidestep before contact [m/s] >= 0.
    double separationReach = 0.15;  ///< Gap between two bodies below which they sidestep [m] >= 0.
};

/// What each character is to follow, one entry per character.
struct SteeringInput {
    std::span<const Vec2> place;          ///< Position of its place [m] (its own position for the unmatched).
    std::span<const Vec2> placeVelocity;  ///< [m/s]
    std::span<const Vec2> facing;         ///< Unit heading of its formation, taken up when standing.
};

/// Computes next velocities and headings from the frozen present.
class Steering {
public:
    /// Reads `now`, writes next velocity and heading (one per character). The same bits with and without a
    /// pool.
    void run(const SteeringDef& def, const Characters& now, const SteeringInput& input,
             const Environment& environment, double dt, std::span<Vec2> velocity, std::span<Vec2> heading,
             ThreadPool* pool = nullptr);

    /// Pairs nearer than reach() in the last run, at its positions.
    std::span<const NearPair> pairs() const { return pairs_; }
    /// How near they are [m].
    double reach() const { return reach_; }

private:
    void addSidesteps(const SteeringDef& def, const Characters& now);
    void holdBack(const SteeringDef& def, const Characters& now);

    NeighbourGrid neighbours_;
    std::vector<NearPair> pairs_;
    double reach_ = 0.0;
    std::vector<Vec2> preferred_;
    std::vector<double> topSpeed_;
};

}  // namespace muster
