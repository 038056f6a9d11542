// The stage of steering: from the guidance of plans to the next velocities (SPEC A6).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/assignment/planning/plan_costs.h"
#include "engine/state/shared_places.h"
#include "engine/state/world_state.h"
#include "engine/steering/cohesion.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/steering.h"
#include "engine/systems/passages/way_stage.h"
#include "engine/systems/steering/continuum_stage.h"
#include "engine/systems/steering/go_round.h"
#include "engine/systems/steering/member_arrays.h"
#include "engine/systems/steering/own_routes.h"

namespace muster {

/// Where every character would be after the step without contacts. One entry per character.
struct NextMotion {
    std::vector<Vec2> position;  ///< [m]
    std::vector<Vec2> velocity;  ///< [m/s]
    std::vector<Vec2> heading;   ///< Unit vector that it faces.
};

/// Steers the characters of all groups.
class SteeringStage {
public:
    /// Takes a new or restored state; call before its first step.
    void reset() { continuum_.reset(); }
    /// Writes directions and costs of characters, and the next motion after `dt` [s].
    void run(WorldState& state, PlanCosts& costs, const WayStage& ways, double dt, ThreadPool& pool);
    /// Writes the next motion after another `dt` [s], by the same directions.
    void move(WorldState& state, double dt, ThreadPool& pool);

    const CrowdBodies& bodies() const { return bodies_; }  ///< Of the last run.
    NextMotion& next() { return next_; }                   ///< By the last run; contacts correct it.
    std::span<const double> topSpeeds() const { return steering_.topSpeeds(); }  ///< Of the last run [m/s].
    const NeighbourList& neighbours() const { return steering_.neighbours(); }   ///< Of the last run.
    const BodyAxes& axes() const { return steering_.axes(); }                    ///< Of the last run.

private:
    void guide(WorldState& state, std::size_t index, PlanCosts& costs, const WayStage& ways,
               ThreadPool& pool);
    void gather(WorldState& state, const Group& group, Gathering& gathering);
    void directUnmatched(const WorldState& state, const Group& group);
    void resolveBodies(const WorldState& state);
    void setPaces(const WorldState& state);

    Steering steering_;
    SharedPlaces shared_;
    OwnRoutes ownRoutes_;
    ContinuumStage continuum_;
    GoRound goRound_;
    CrowdBodies bodies_;
    std::vector<std::uint8_t> firmness_;  // Of all groups.
    std::vector<double> pace_;            // Of all characters, as shares; empty for all 1.
    Cohesion cohesion_;
    MemberArrays members_;
    std::vector<Vec2> directions_;  // Of one group's members.
    std::vector<double> costs_;
    std::vector<Vec2> placePosition_;  // Of all characters.
    std::vector<Vec2> placeVelocity_;
    std::vector<Vec2> facing_;
    NextMotion next_;
};

}  // namespace muster
