// The ways of one group, as its plan reads them.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/assignment/planning/planned_ways.h"
#include "engine/state/world_state.h"
#include "engine/systems/passages/way_fields.h"

namespace muster {

/// Tables for PlannedWays.
class GroupWays {
public:
    /// Forgets all ways.
    void clear() { any_ = false; }
    /// Takes the chosen ways of a group. `reach` holds for each character of the world the cost of its walk
    /// to its passage [m].
    void prepare(const WorldState& state, const WayFields& fields, const Group& group,
                 std::span<const float> reach, ThreadPool& pool);
    /// The tables; valid until the next prepare().
    PlannedWays planned() const { return any_ ? PlannedWays{way_, reach_, onward_} : PlannedWays{}; }

private:
    void readChosen(const WorldState& state, const Group& group, std::span<const float> reach);

    std::vector<std::int32_t> way_;
    std::vector<float> reach_;
    std::vector<float> onward_;
    std::vector<std::uint8_t> used_;  // By way: 1 if a member takes it.
    bool any_ = false;
};

}  // namespace muster
