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
#include "engine/systems/goals/goal_stage.h"
#include "engine/systems/passages/way_stage.h"
#include "engine/systems/steering/continuum_stage.h"
#include "engine/systems/steering/go_round.h"
#include "engine/systems/steering/group_members.h"
#include "engine/systems/steering/own_routes.h"

namespace muster {

/// Where every character would be after the step without contacts. One entry per character.
struct NextMotion {
    std::vector<Vec2> position;  ///< [m]
    std::vector<Vec2> velocity;  ///< [m/s]
    std::vector<Vec2> heading;   ///< Unit vector that it faces.
};

/// Steers the characters of all groups. Its functions are called in this order: once in each step, and those
/// from steer() on once in each move, into which a long step is divided.
class SteeringStage {
public:
    /// Takes a new or restored state; call before its first step.
    void reset() {
        continuum_.reset();
        goals_.reset();
    }

    /// Resolves what everybody is: radius, speed, mass, and how firmly it stands.
    void resolveBodies(const WorldState& state);
    /// Writes directions, costs and goals of characters without places: they go down a field to their target.
    void descendFields(WorldState& state, PlanCosts& costs, ThreadPool& pool);
    /// Writes directions and costs of characters by the plans of their groups.
    void guide(WorldState& state, PlanCosts& costs, const GroupMembers& members, ThreadPool& pool);
    /// Directs those to their passage who have to go through one.
    void guideToPassages(WorldState& state, const WayStage& ways);
    /// Directs those by a route of their own who have not got on for a while.
    void followOwnRoutes(WorldState& state) { ownRoutes_.run(state, goRound_.barred()); }
    /// Writes at which share of their speed members of groups walk that keep together.
    void setPaces(const WorldState& state);
    /// Turns directions round those who hold their ground.
    void goRound(WorldState& state) { goRound_.run(state, bodies_, placePosition_); }
    /// Writes the next motion after `dt` [s], without contacts.
    void steer(WorldState& state, double dt, ThreadPool& pool);
    /// Looks for those who share a place.
    void findSharedPlaces(const WorldState& state) { shared_.find(state); }

    const CrowdBodies& bodies() const { return bodies_; }  ///< Of this step.
    NextMotion& next() { return next_; }                   ///< By the last steer(); contacts correct it.
    std::span<const double> topSpeeds() const {
        return steering_.topSpeeds();
    }  ///< Of the last steer() [m/s].
    const NeighbourList& neighbours() const { return steering_.neighbours(); }  ///< Of the last steer().
    const BodyAxes& axes() const { return steering_.axes(); }                   ///< Of the last steer().

private:
    void directUnmatched(const WorldState& state, const Group& group, const MemberArrays& members);

    Steering steering_;
    SharedPlaces shared_;
    OwnRoutes ownRoutes_;
    ContinuumStage continuum_;
    GoalStage goals_;
    GoRound goRound_;
    CrowdBodies bodies_;
    std::vector<std::uint8_t> firmness_;  // Of all groups.
    std::vector<double> pace_;            // Of all characters, as shares; empty for all 1.
    Cohesion cohesion_;
    std::vector<std::int32_t>
        towards_;                   // Of one group's members: the place to which each is guided, -1 for none.
    std::vector<Vec2> directions_;  // Of one group's members.
    std::vector<double> costs_;
    std::vector<Vec2> placePosition_;  // Of all characters.
    std::vector<Vec2> placeVelocity_;
    std::vector<Vec2> facing_;
    std::vector<GroupClaim> claims_;  // Of all groups.
    NextMotion next_;
};

}  // namespace muster
