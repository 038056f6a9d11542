// Interface of plans: the assignment of characters to places, and the guidance towards them (SPEC A1-A3, A6).
// No cost field and no cost matrix crosses this interface.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "assignment/dense/transportation_problem.h"
#include "base/archive.h"
#include "base/parallel.h"
#include "cost/dynamic_cost.h"
#include "cost/static_ground.h"
#include "cost/unit_cost.h"
#include "environment/environment.h"
#include "muster/parameters.h"

namespace muster {

/// The objective of a plan, and which exchanges are committed.
struct PlanDef {
    /// Exponent p of the objective sum c^p f, in [1, 16].
    double exponent = Parameters::Plan{}.exponent;
    /// An exchange (a cycle or a path of moves) is committed only where it lowers the objective by more than
    /// this [cost^p] >= 0.
    double commitThreshold = Parameters::Plan{}.threshold;
    /// The gain of an exchange must also exceed this share of the objective of the characters that it moves
    /// >= 0.
    double commitThresholdShare = Parameters::Plan{}.thresholdShare;
    /// Lexicographic objective: the least bottleneck (cost of the costliest pair) comes first, then the sum
    /// above among the matchings that attain it.
    bool bottleneck = false;
    /// True for geodesic costs; false for straight-line distances (paths still follow the cost field).
    bool geodesic = Parameters::Plan{}.geodesic;
    /// False keeps every incumbent place that is usable (assigned once, fixed places): only paths are
    /// planned.
    bool reassign = true;

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(exponent, commitThreshold, commitThresholdShare, bottleneck, geodesic, reassign);
    }
};

/// What a plan reads. Spans stay valid during the call only; start() copies what the plan needs.
struct PlanInput {
    std::span<const Vec2> characters;          ///< Positions [m].
    std::span<const double> supply;            ///< Units that each character supplies >= 0; empty for 1 each.
    std::span<const Vec2> places;              ///< Positions [m].
    std::span<const double> demand;            ///< Units that each place demands >= 0; empty for 1 each.
    std::span<const std::uint8_t> usable;      ///< Per place, 0 for one that nobody may take; empty for all.
    std::span<const std::int32_t> incumbent;   ///< Current place of each character, -1 for none.
    const UnitCost* unitCost = nullptr;        ///< For plans with Plan::readsUnitCost(), else null.
    const StaticGround* ground = nullptr;      ///< For the other plans; outlives the plan.
    const DynamicCost* dynamicCost = nullptr;  ///< For the other plans; outlives the plan.
    /// Per character, 0 where it is known to stand in another region than the places; empty for all 1.
    std::span<const std::uint8_t> connected = {};
};

/// What the guidance of a step reads. Spans stay valid during the call only.
struct GuidanceInput {
    std::span<const Vec2> characters;          ///< Positions [m].
    std::span<const std::int32_t> place;       ///< Place of each character, -1 for the unmatched.
    std::span<const Vec2> places;              ///< Current positions [m].
    const Environment* environment = nullptr;  ///< Not null.
    /// Up to this distance a clear straight line to the place is followed instead of the cost field [m] >= 0.
    double directReach = 0.0;
    const StaticGround* ground = nullptr;      ///< As in PlanInput.
    const DynamicCost* dynamicCost = nullptr;  ///< As in PlanInput.
};

/// What a plan returns.
struct PlanResult {
    std::vector<Flow> flows;   ///< Committed flows, ordered by character.
    std::vector<double> cost;  ///< Cost of each character to its place [m]; infinite for the unmatched.
    double objective = 0.0;    ///< Objective of the committed flows [cost^p].
    /// Upper bound of the duality gap, the objective less a proven lower bound [cost^p]: what the commit
    /// threshold dropped. It is the whole objective where PlanDef::reassign is false.
    double gapBound = 0.0;
    /// Number of characters whose place (that of the largest flow) differs from the incumbent.
    std::int32_t reassigned = 0;
};

/// A plan of one group. Its work can be spread over several steps: start(), then advance() with shares that
/// add up to the whole, then finish(). The last finished plan serves guide() meanwhile. Some plans leave most
/// of their work to workInBackground(), which another thread may call between the last advance() and
/// finish().
class Plan {
public:
    virtual ~Plan() = default;

    /// Name of the method: "exact" or "fast".
    virtual const char* name() const = 0;
    /// True where plans are made from PlanInput::unitCost; false where from the static ground and the dynamic
    /// cost.
    virtual bool readsUnitCost() const = 0;
    /// Allocates memory for a group of this size on this ground, so that its first plan need not. Must be
    /// called before the first start(); changes no result.
    virtual void reserve(std::size_t /*characters*/, std::size_t /*places*/, const StaticGround&) {}
    /// Freezes the input of the next plan; a pending plan is dropped. Fails with InvalidArgument, changing
    /// nothing, where sizes do not fit or a value is out of range.
    virtual Status start(const PlanDef& def, const PlanInput& input) = 0;
    /// True between start() and finish().
    virtual bool pending() const = 0;
    /// Does share `slice` of `slices` of the work; slices are numbered 0, 1, ... and come in this order.
    virtual void advance(std::int32_t slice, std::int32_t slices, ThreadPool& pool) = 0;
    /// Completes the pending plan (all remaining shares are done now) and writes the result. Fails with
    /// InvalidArgument where no plan is pending.
    virtual Status finish(ThreadPool& pool, PlanResult& result) = 0;
    /// True where workInBackground() has something to do.
    virtual bool worksInBackground() const { return false; }
    /// Does the remaining work of the pending plan. Meanwhile other threads may call guide(), waitingPlace()
    /// and costAt(), and nothing else; the ground and the dynamic cost of PlanInput must not change.
    virtual void workInBackground() {}

    /// Writes the guidance of each character by the last finished plan: the unit vector of its desired
    /// direction, and the remaining cost [m]; zero and infinite for the unmatched and where no path is known.
    /// Where the line to the place is clear within GuidanceInput::directReach the cost is the straight
    /// distance. Elsewhere a plan that keeps cost fields leads to the position that the place had at start();
    /// off the field it leads straight to the place if the line is clear, else back to the field.
    virtual void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
                       std::span<double> cost) = 0;

    /// The place near which an unmatched character waits, by the last finished plan: the nearest usable place
    /// in the character's region. -1 for none, and for characters that had a place at start().
    virtual std::int32_t waitingPlace(std::int32_t character) const = 0;
    /// Cost from `p` to a place by the last finished plan [m], for pictures; infinite where unknown.
    virtual double costAt(std::int32_t place, Vec2 p) const = 0;

    /// Writes all that can influence later results: frozen inputs and progress, never the cost fields.
    virtual void save(Writer& archive) const = 0;
    /// Reads what save() wrote, and solves the cost fields again. False where it does not fit.
    virtual bool load(Reader& archive, ThreadPool& pool) = 0;
    /// True where the pending and the last finished plan are for so many characters and places on this
    /// ground.
    virtual bool suits(std::size_t characters, std::size_t places, const Grid& grid) const = 0;
    /// Adds what save() writes to a hash, except the cells of unit costs, which follow from the state that
    /// was hashed at the step of start().
    virtual void hash(Hasher& archive) const = 0;
};

/// The reference plan: one cost field per place, exact assignment (docs/method/exact-plan.md).
std::unique_ptr<Plan> makeExactPlan();
/// The same objective within a fraction of a percent, at a cost that grows about linearly with the crowd:
/// geodesics interpolated between landmark fields, and dynamic assignment on a sparse graph
/// (docs/method/fast-plan.md). Supplies and demands are one unit each: start() fails with InvalidArgument on
/// other amounts.
std::unique_ptr<Plan> makeFastPlan();

}  // namespace muster
