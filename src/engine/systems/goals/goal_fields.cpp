#include "engine/systems/goals/goal_fields.h"

#include <algorithm>

#include "base/maths.h"
#include "engine/fields/cost/ground_level.h"

namespace muster {

void addClasses(const Group& group, std::span<const std::int32_t> classes, std::vector<std::int32_t>& used) {
    for (const std::int32_t i : group.members) {
        const auto at = std::lower_bound(used.begin(), used.end(), classes[i]);
        if (at == used.end() || *at != classes[i]) used.insert(at, classes[i]);
    }
}

void GoalFields::begin(const WorldState& state, PlanCosts& costs) {
    state_ = &state;
    costs_ = &costs;
    unitCosts_.clear();
    std::erase_if(entries_, [&](const Entry& entry) {
        return entry.key.kind != Kind::Heading && state.findArea(AreaId{entry.key.area}) == nullptr;
    });
}

const UnitCost& GoalFields::unitCost(std::int32_t groundClass) {
    auto at = unitCosts_.find(groundClass);
    if (at == unitCosts_.end())
        at = unitCosts_.emplace(groundClass, ground(groundClass).fineLevel().unitCost()).first;
    return at->second;
}

template <class Solve>
const GoalField& GoalFields::find(const Key& key, const std::vector<Vec2>& shape, const Solve& solve) {
    const std::uint32_t version = ground(key.groundClass).version();
    auto at = std::find_if(entries_.begin(), entries_.end(),
                           [&](const Entry& entry) { return entry.key == key; });
    if (at != entries_.end() && at->version == version && at->shape == shape) return *at->field;
    if (at == entries_.end()) {
        entries_.push_back({key, {}, 0, std::make_unique<GoalField>()});
        at = entries_.end() - 1;
    }
    at->shape = shape;
    at->version = version;
    solve(*at->field);
    return *at->field;
}

const GoalField& GoalFields::solved(const Key& key) const {
    return *std::find_if(entries_.begin(), entries_.end(), [&](const Entry& entry) {
                return entry.key == key;
            })->field;
}

const GoalField& GoalFields::toArea(const Area& area, std::int32_t groundClass) {
    const std::vector<Vec2>& polygon = area.def.polygon;
    const Key key{Kind::Area, area.id.value, 0.0, groundClass};
    return find(key, polygon, [&](GoalField& field) {
        field.solve(ground(groundClass), unitCost(groundClass), polygon, solver_);
    });
}

const GoalField& GoalFields::toQueue(const Area& area, std::int32_t groundClass) {
    const std::vector<Vec2>& line = area.def.queue;
    const Key key{Kind::Queue, area.id.value, 0.0, groundClass};
    return find(key, line, [&](GoalField& field) {
        field.solveToLine(ground(groundClass), unitCost(groundClass), line, solver_);
    });
}

const GoalField& GoalFields::towards(double heading, std::int32_t groundClass) {
    const Key key{Kind::Heading, 0, heading, groundClass};
    return find(key, {}, [&](GoalField& field) {
        field.solveHeading(ground(groundClass), unitCost(groundClass), {cosine(heading), sine(heading)},
                           state_->environment.def().ring, solver_);
    });
}

}  // namespace muster
