// Plans: who goes where (SPEC A1-A3). No field and no cost matrix crosses this interface.
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

namespace muster {

/// The objective and how it is committed.
struct PlanDef {
    double exponent = 2.0;  ///< p of the objective sum c^p f, 1 to 16.
    /// A change of places (one cycle or path of exchanges) is committed only where it lowers the objective by
    /// more [cost^p] >= 0.
    double threshold = 0.02;
    /// ... and by more than this share of the objective of those it concerns >= 0.
    double thresholdShare = 0.003;
    /// First the least cost of the dearest pair, then the objective above among such matchings.
    bool longestWalk = false;
    /// Costs by the cost field; else straight-line distances (ways still follow the field).
    bool geodesic = true;
    /// False keeps every incumbent place that may be taken (assigned once, fixed places): only ways are
    /// planned.
    bool reassign = true;

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(exponent, threshold, thresholdShare, longestWalk, geodesic, reassign);
    }
};

/// What a plan reads. Spans stay valid during the call only; start() copies what it needs.
struct PlanInput {
    std::span<const Vec2> characters;         ///< Positions [m].
    std::span<const double> supply;           ///< Per character; empty for 1 each.
    std::span<const Vec2> places;             ///< Positions [m].
    std::span<const double> demand;           ///< Per place; empty for 1 each.
    std::span<const std::uint8_t> usable;     ///< Per place, 0 for one nobody may take; empty for all.
    std::span<const std::int32_t> incumbent;  ///< Place of each character now, -1 for none.
    const UnitCost* cost = nullptr;           ///< For plans that ask for it (Plan::readsUnitCost), else null.
    const StaticGround* ground = nullptr;     ///< For the other plans; lives as long as the plan.
    const DynamicCost* excess = nullptr;      ///< For the other plans; lives as long as the plan.
    std::span<const std::uint8_t> present =
        {};  ///< Per character, 0 for one known to be cut off from the places; empty for all.
};

/// What steering reads. Spans stay valid during the call only.
struct SteerInput {
    std::span<const Vec2> characters;          ///< Positions [m].
    std::span<const std::int32_t> place;       ///< Of each character, -1 for the unmatched.
    std::span<const Vec2> places;              ///< Today's positions [m].
    const Environment* environment = nullptr;  ///< Not null.
    /// Within a clear straight line of this the direction leads straight to the place [m].
    double direct = 0.0;
    const StaticGround* ground = nullptr;  ///< As for plans.
    const DynamicCost* excess = nullptr;   ///< As for plans.
};

/// What a plan returns.
struct PlanResult {
    std::vector<Flow> flows;   ///< Ordered by character.
    std::vector<double> cost;  ///< Of each character to its place; infinite for the unmatched.
    double objective = 0.0;    ///< Of the flows as committed [cost^p].
    /// Objective less a proven lower bound [cost^p]: what the threshold kept back; the whole objective where
    /// places are kept.
    double gapBound = 0.0;
    /// Characters whose place (that of the largest flow) is another than the incumbent.
    std::int32_t changed = 0;
};

/// A plan of one group. Work can be spread over several steps: start(), then advance() with shares that
/// add up to the whole, then finish(). The last finished plan serves steer() meanwhile. Some plans leave most
/// of their work to workAside(), which another thread may do between the last advance() and finish().
class Plan {
public:
    virtual ~Plan() = default;

    /// "exact", "fast"...
    virtual const char* name() const = 0;
    /// True where plans are made from the unit cost of all ground; else from the still ground and the crowd's
    /// excess.
    virtual bool readsUnitCost() const = 0;
    /// Makes room for a group of this size on this ground, so that its first plan need not. Before the first
    /// start(); changes no result.
    virtual void reserve(std::size_t /*characters*/, std::size_t /*places*/, const StaticGround&) {}
    /// Freezes the input of the next plan; a plan under way is dropped. Fails with InvalidArgument, changing
    /// nothing, where sizes do not fit or a value is out of range.
    virtual Status start(const PlanDef& def, const PlanInput& input) = 0;
    /// True between start() and finish().
    virtual bool pending() const = 0;
    /// Does share `slice` of `slices` (0, 1, ... in turn) of the work.
    virtual void advance(std::int32_t slice, std::int32_t slices, ThreadPool& pool) = 0;
    /// Completes the plan (all shares not yet done are done now) and writes the result. Fails with
    /// InvalidArgument where no plan is under way.
    virtual Status finish(ThreadPool& pool, PlanResult& result) = 0;
    /// True where workAside() has something to do.
    virtual bool worksAside() const { return false; }
    /// Does what is left of the pending plan. Meanwhile other threads may call steer(), waitingPlace() and
    /// costAt(), and nothing else; the ground and the excess of PlanInput stay as they are.
    virtual void workAside() {}

    /// Writes for each character the unit direction to walk now, and the cost left, by the last finished
    /// plan; zero and infinite for the unmatched and where no way is known. Where the line to the place is
    /// clear within SteerInput::direct the cost is the straight distance. Elsewhere a plan made of fields
    /// leads to where the place was when the plan was started; where its field is unknown straight if the
    /// line is clear, else back to known ground.
    virtual void steer(const SteerInput& input, ThreadPool& pool, std::span<Vec2> direction,
                       std::span<double> cost) = 0;

    /// The place beside which a character waits while it stays unmatched, by the last finished plan: the
    /// nearest that somebody can take among those it can come to. -1 for none, and for those that held a
    /// place when it was started.
    virtual std::int32_t waitingPlace(std::int32_t character) const = 0;
    /// Cost to place `place` from `p` by the last finished plan, for pictures; infinite where unknown.
    virtual double costAt(std::int32_t place, Vec2 p) const = 0;

    /// Writes all that can influence later results (frozen inputs, progress; never the fields).
    virtual void save(Writer& archive) const = 0;
    /// Reads what save() wrote, and makes the fields anew. False where it does not fit.
    virtual bool load(Reader& archive, ThreadPool& pool) = 0;
    /// True where the plan under way and the last finished one are for so many characters and places on this
    /// ground.
    virtual bool suits(std::size_t characters, std::size_t places, const Grid& grid) const = 0;
    /// Adds what save() writes to a hash, less the cells of unit costs: these follow from the state that was
    /// hashed at the step of start().
    virtual void hash(Hasher& archive) const = 0;
};

/// The reference: one cost field per place, exact assignment.
std::unique_ptr<Plan> makeExactPlan();
/// The same objective within a fraction of a percent, at a cost that hardly grows with the crowd: costs
/// interpolated between landmark fields, an assignment kept near-optimal on a few arcs per place
/// (docs/method/fast-plan.md). One unit each: fails with InvalidArgument on other amounts.
std::unique_ptr<Plan> makeFastPlan();

}  // namespace muster
