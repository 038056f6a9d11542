// Leads the members of groups that have no formation: to exits, to waiting areas, or on towards a heading
// (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/systems/goals/exit_choice.h"
#include "engine/systems/goals/exit_lines.h"
#include "engine/systems/goals/goal_fields.h"
#include "engine/systems/goals/waiting_spots.h"
#include "muster/event.h"

namespace muster {

/// Writes the exit that each person has chosen, directions and costs. Its fields are caches.
class GoalStage {
public:
    /// Forgets all fields; call when the state has become another.
    void reset() {
        fields_.reset();
        choice_.reset();
    }
    /// One step; writes the point for which each member of these groups heads to `heads` [m], by character.
    void run(WorldState& state, PlanCosts& costs, std::span<Vec2> heads, ThreadPool& pool);
    /// Raises which groups have members without a route, and when all have one again.
    static void raiseWays(WorldState& state, std::vector<Event>& events);
    /// By character: 1 if it is to stand at a given point; empty where none is.
    std::span<const std::uint8_t> standing() const { return standing_; }

private:
    bool listGroups(WorldState& state);
    void findClasses(const WorldState& state, ThreadPool& pool);
    std::span<const std::int32_t> classesOf(const Group& group);
    void standAll(WorldState& state, const Group& group, std::span<Vec2> heads);
    void leave(WorldState& state, std::span<Vec2> heads, ThreadPool& pool);
    void wait(WorldState& state, Group& group, Gathering& gathering, std::span<Vec2> heads, ThreadPool& pool);
    void walk(WorldState& state, const Group& group, double heading, std::span<Vec2> heads, ThreadPool& pool);
    void follow(WorldState& state, std::size_t i, const GoalWay& way, std::span<Vec2> heads) const;
    void followField(WorldState& state, std::size_t i, GoalWay way, const GoalField& field,
                     std::span<Vec2> heads) const;
    void goTo(WorldState& state, std::size_t i, Vec2 spot, double cost, std::span<Vec2> heads);

    GoalFields fields_;
    ExitChooser choice_;
    ExitLines lines_;
    WaitingSpots spots_;
    std::vector<Leavers> leavers_;
    std::vector<Group*> waiting_, walking_, idle_;
    std::vector<std::int32_t> classes_;  // Class of ground of each character.
    std::vector<std::int32_t> used_;     // Classes in the group at hand.
    std::vector<std::uint8_t> standing_;
};

}  // namespace muster
