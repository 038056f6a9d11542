// The fields of all areas to which people go: solved when they are first needed, and again when ground or
// area have changed. A cache.
#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <span>
#include <vector>

#include "engine/assignment/planning/plan_costs.h"
#include "engine/state/world_state.h"
#include "engine/systems/goals/goal_field.h"

namespace muster {

/// Adds the classes of ground of a group's members to a list that ascends. `classes` are those of all
/// characters.
void addClasses(const Group& group, std::span<const std::int32_t> classes, std::vector<std::int32_t>& used);

/// Fields by area and class of ground.
class GoalFields {
public:
    /// Forgets all; call when the state has become another.
    void reset() { entries_.clear(); }
    /// Takes the ground and the areas of this step, and drops the fields of areas that are no more.
    void begin(const WorldState& state, PlanCosts& costs);
    /// The field to an area. It holds until the next begin().
    const GoalField& toArea(const Area& area, std::int32_t groundClass);
    /// The field to the line in which people queue before an exit.
    const GoalField& toQueue(const Area& area, std::int32_t groundClass);
    /// The field of people who walk on towards a heading [rad].
    const GoalField& towards(double heading, std::int32_t groundClass);
    /// The field of toArea(), if it was asked for in this step; calls may come from several threads.
    const GoalField& solvedArea(const Area& area, std::int32_t groundClass) const {
        return solved({Kind::Area, area.id.value, 0.0, groundClass});
    }
    const GoalField& solvedQueue(const Area& area, std::int32_t groundClass) const {
        return solved({Kind::Queue, area.id.value, 0.0, groundClass});
    }
    const GoalField& solvedHeading(double heading, std::int32_t groundClass) const {
        return solved({Kind::Heading, 0, heading, groundClass});
    }
    /// The ground of a class.
    const StaticGround& ground(std::int32_t groundClass) {
        return costs_->ofClass(groundClass).staticGround();
    }
    /// The unit cost of a class's ground. It holds until the next begin().
    const UnitCost& unitCost(std::int32_t groundClass);

private:
    enum class Kind : std::uint8_t { Area, Queue, Heading };
    struct Key {
        Kind kind = Kind::Area;
        std::uint32_t area = 0;
        double heading = 0.0;
        std::int32_t groundClass = 0;
        friend bool operator==(const Key&, const Key&) = default;
    };
    struct Entry {
        Key key;
        std::vector<Vec2> shape;    // Shape for which the field was solved.
        std::uint32_t version = 0;  // Version of the ground.
        std::unique_ptr<GoalField> field;
    };
    template <class Solve>
    const GoalField& find(const Key& key, const std::vector<Vec2>& shape, const Solve& solve);
    const GoalField& solved(const Key& key) const;

    const WorldState* state_ = nullptr;
    PlanCosts* costs_ = nullptr;
    std::vector<Entry> entries_;
    std::map<std::int32_t, UnitCost> unitCosts_;  // Unit costs of this step.
    EikonalSolver solver_;
};

}  // namespace muster
