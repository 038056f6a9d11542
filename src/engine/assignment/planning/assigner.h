// The interface of assignments of characters to places (SPEC A1). No cost field and no cost matrix crosses
// it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/assignment/planning/plan_costs.h"
#include "engine/assignment/planning/plan_def.h"
#include "engine/assignment/planning/planned_ways.h"
#include "engine/assignment/transport/dense/transportation_problem.h"
#include "muster/status.h"

namespace muster {

/// Input of an assignment. Spans stay valid during the call only; start() copies what it needs.
struct PlanInput {
    std::span<const Vec2> characters;         ///< Positions of the characters [m].
    std::span<const double> supply;           ///< Units that each character supplies >= 0; empty for 1 each.
    std::span<const Vec2> places;             ///< Positions of the places [m].
    std::span<const double> demand;           ///< Units that each place demands >= 0; empty for 1 each.
    std::span<const std::uint8_t> usable;     ///< Per place, 0 for one that nobody may take; empty for all.
    std::span<const std::int32_t> incumbent;  ///< Current place of each character, -1 for none.
    PlanCosts* costs = nullptr;               ///< Costs of the step; not null; outlives the plan.
    /// Version of the ground: where static obstacles have changed, known costs are forgotten.
    std::uint32_t edits = 0;
    /// Per character, 0 where it is known to stand in another region than the places; empty for all 1.
    std::span<const std::uint8_t> connected = {};
    /// Per character, the cost of its incumbent place [m] where that is known better than by fields, else
    /// below 0; empty for none.
    std::span<const float> known = {};
    PlannedWays ways = {};  ///< Ways through passages before which many wait.
    /// Per character, the factor above 0 by which a path costs it more than others, because it is slower;
    /// empty for all 1.
    std::span<const float> slowness = {};
    /// The class of each character and of each place: among all assignments that send as many units as
    /// possible, the ones that send as many as possible within their classes come first, and then the least
    /// objective. Both empty for none.
    std::span<const std::uint8_t> characterClass = {};
    std::span<const std::uint8_t> placeClass = {};
};

/// Result of an assignment.
struct PlanResult {
    std::vector<Flow> flows;  ///< Committed flows, ordered by character.
    /// Cost of each character to its place [m]; infinite for unmatched characters.
    std::vector<double> cost;
    double objective = 0.0;  ///< Objective of the committed flows [cost^p].
    /// Upper bound of the duality gap, the objective less a proven lower bound [cost^p]: the gain that the
    /// commit threshold dropped. It is the whole objective where PlanDef::reassign is false.
    double gapBound = 0.0;
    /// True where this is a first plan by rough costs, which will soon be made again.
    bool provisional = false;
    /// True where it was made from nothing, so that its changes of places are no exchanges.
    bool first = false;
    /// Number of characters whose place (engine/assignment/planning/main_places.h) differs from the
    /// incumbent.
    std::int32_t reassigned = 0;
};

/// Assigns the characters of one group to its places. The work can be spread over several steps: start(),
/// then advance() with all shares, then finish(). Work that advance() leaves may be done by
/// workInBackground(), which another thread may call before finish().
class Assigner {
public:
    virtual ~Assigner() = default;

    /// Number of shares into which the work is cut where it may take `period` steps >= 1.
    virtual std::int32_t shares(std::int32_t period) const = 0;
    /// Freezes the input of the next assignment; a pending one is dropped. Fails with InvalidArgument,
    /// changing nothing, where sizes do not fit or a value is out of range.
    virtual Status start(const PlanDef& def, const PlanInput& input) = 0;
    /// True between start() and finish().
    virtual bool pending() const = 0;
    /// Does share `share` of `shares` of the work; shares are numbered 0, 1, ... and come in this order.
    virtual void advance(std::int32_t share, std::int32_t shares, ThreadPool& pool) = 0;
    /// Completes the pending assignment (all that is left is done now) and writes the result. Fails with
    /// InvalidArgument where none is pending.
    virtual Status finish(ThreadPool& pool, PlanResult& result) = 0;
    /// True where workInBackground() has something to do.
    virtual bool worksInBackground() const { return false; }
    /// Does the remaining work. Meanwhile other threads may call the Navigator of the same plan, and nothing
    /// else; the costs must not change.
    virtual void workInBackground() {}
};

/// Refuses the input that Assigner::start() must refuse, with InvalidArgument and the wrong value. The costs
/// are not looked at.
Status validatePlan(const PlanDef& def, const PlanInput& input);
/// Refuses a unit cost that does not fill its grid, with InvalidArgument.
Status validateUnitCost(const UnitCost& cost);

/// Copies a span into a vector, which keeps its memory.
template <class T>
void copySpan(std::span<const T> from, std::vector<T>& to) {
    to.assign(from.begin(), from.end());
}

}  // namespace muster
