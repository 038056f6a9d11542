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

/// Positions, velocities and headings after the step without contacts. One entry per character.
struct NextMotion {
    std::vector<Vec2> position;  ///< [m]
    std::vector<Vec2> velocity;  ///< [m/s]
    std::vector<Vec2> heading;   ///< Unit vector that the character faces.
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

    /// Resolves bodies: radius, speed, mass, and how firmly each character stands.
    void resolveBodies(const WorldState& state);
    /// Writes directions, costs and goals of characters without places, which go down a field to their
    /// target.
    void descendFields(WorldState& state, PlanCosts& costs, ThreadPool& pool);
    /// Writes directions and costs of characters by the plans of their groups.
    void guide(WorldState& state, PlanCosts& costs, const GroupMembers& members, ThreadPool& pool);
    /// Directs characters that have to go through a passage to it.
    void guideToPassages(WorldState& state, const WayStage& ways);
    /// Directs characters that have not got on for a while by their own routes.
    void followOwnRoutes(WorldState& state) { ownRoutes_.run(state, goRound_.barred()); }
    /// Writes the share of their speed at which members of groups that keep together walk.
    void setPaces(const WorldState& state);
    /// Turns directions round agents that hold their ground.
    void goRound(WorldState& state) { goRound_.run(state, bodies_, placePosition_); }
    /// Writes the next motion after `dt` [s], without contacts.
    void steer(WorldState& state, double dt, ThreadPool& pool);
    /// Finds characters that share a place.
    void findSharedPlaces(const WorldState& state) { shared_.find(state); }

    const CrowdBodies& bodies() const { return bodies_; }  ///< The bodies of this step.
    NextMotion& next() { return next_; }  ///< The result of the last steer(); contacts correct it.
    /// The top speeds of the last steer() [m/s].
    std::span<const double> topSpeeds() const { return steering_.topSpeeds(); }
    /// The neighbours of the last steer().
    const NeighbourList& neighbours() const { return steering_.neighbours(); }
    const BodyAxes& axes() const { return steering_.axes(); }  ///< The axes of the last steer().

private:
    void directUnmatched(const WorldState& state, const Group& group, const MemberArrays& members);

    Steering steering_;
    SharedPlaces shared_;
    OwnRoutes ownRoutes_;
    ContinuumStage continuum_;
    GoalStage goals_;
    GoRound goRound_;
    CrowdBodies bodies_;
    std::vector<std::uint8_t> firmness_;  // Firmness of each group.
    std::vector<double> pace_;            // By character, as shares; empty for all 1.
    Cohesion cohesion_;
    // By member of one group: the place to which it is guided, -1 for none.
    std::vector<std::int32_t> towards_;
    std::vector<Vec2> directions_;  // By member of one group.
    std::vector<double> costs_;
    std::vector<Vec2> placePosition_;  // By character.
    std::vector<Vec2> placeVelocity_;
    std::vector<Vec2> facing_;
    std::vector<GroupClaim> claims_;  // By group.
    NextMotion next_;
};

}  // namespace muster
