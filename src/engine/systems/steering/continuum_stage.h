// Characters without a place go down one cost field per target (Treuille, Cooper and Popovic 2006).
#pragma once

#include <cstdint>
#include <vector>

#include "base/cell_list.h"
#include "engine/assignment/planning/plan_costs.h"
#include "engine/fields/eikonal/eikonal_solver.h"
#include "engine/state/world_state.h"

namespace muster {

/// Distance from which on members of a group of `count` count as near a target without obstacles [m]:
/// slightly more than the radius of the disc that they fill when they stand close together.
double gatheringReach(std::size_t count, double radius);

/// Leads the members of gatherings. Fields are caches: they follow from the frozen costs in the state.
class ContinuumStage {
public:
    /// Forgets all fields; call when the state has become another.
    void reset() { fields_.clear(); }
    /// Freezes the costs again where that is due. Call once per step, before guide().
    void begin(WorldState& state, PlanCosts& costs);
    /// Writes directions and costs of the members of a group without places, and which of them have arrived.
    void guide(WorldState& state, const Group& group, Gathering& gathering);

private:
    struct Field {
        std::int32_t groundClass = 0;
        Vec2 target;
        bool used = false;   // True if it was read since costs were frozen.
        bool stale = false;  // True if it was solved from older costs.
        CostField field;
    };
    const CostField& fieldOf(const WorldState& state, std::int32_t groundClass, Vec2 target);
    void findArrived(const WorldState& state, const Group& group, Gathering& gathering);

    EikonalSolver solver_;
    std::vector<Field> fields_;
    std::vector<Vec2> standing_;  // Positions of members that have arrived [m].
    CellList cells_;
};

}  // namespace muster
