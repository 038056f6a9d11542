// The reference plan: one cost field per place by fast marching, exact assignment (SPEC A1, A2; paper eqs. 2
// and 5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/assignment/planning/commit_rule.h"
#include "engine/assignment/planning/exact/frozen_plan.h"
#include "engine/assignment/planning/plan.h"
#include "engine/assignment/transport/dense/bottleneck_assignment.h"

namespace muster {

/// Double-buffered: the pending plan is being solved, the finished one guides.
class ExactPlan final : public Plan {
public:
    const char* name() const override { return "exact"; }
    std::int32_t shares(std::int32_t period) const override { return period; }
    Status start(const PlanDef& def, const PlanInput& input) override;
    bool pending() const override { return pending_.valid(); }
    void advance(std::int32_t share, std::int32_t shares, ThreadPool& pool) override;
    Status finish(ThreadPool& pool, PlanResult& result) override;
    void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
               std::span<double> cost) override;
    std::int32_t waitingPlace(std::int32_t character) const override {
        const bool known = finished_.valid() && character >= 0 && character < finished_.characters();
        return known ? finished_.waitingPlace(character) : -1;
    }
    double costAt(std::int32_t place, Vec2 p) const override;
    void forget() override {
        pending_.clear();
        finished_.clear();
    }
    void save(Writer& archive) const override;
    bool load(Reader& archive, ThreadPool& pool) override;
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const override {
        return pending_.suits(characters, places, grid) && finished_.suits(characters, places, grid);
    }
    void hash(Hasher& archive) const override;

private:
    /// Guidance like that of geodesics, in double precision.
    struct FieldGuidance {
        Vec2 direction;  // Unit vector; zero where no path is known.
        double cost;     // Cost of the path [m]; infinite where no path is known.
    };

    std::size_t pairIndex(std::int32_t character, std::int32_t place) const {
        return static_cast<std::size_t>(character) * pending_.places() + place;
    }
    Status reassign(ThreadPool& pool, PlanResult& result);
    Status solveProvenAssignment(ThreadPool& pool);
    Status solveAssignment();
    void keepIncumbents(PlanResult& result);
    void readCosts(std::int32_t place);
    void separateClasses();
    void collectIncumbents();
    void report(PlanResult& result);
    FieldGuidance guideOne(Vec2 p, std::int32_t place, Vec2 placeNow, const Environment& environment,
                           double directReach) const;
    FieldGuidance guideOffField(Vec2 p, const CostField* field, Vec2 placeNow,
                                const Environment& environment) const;
    double lineRadius() const;

    FrozenPlan pending_;
    FrozenPlan finished_;
    // Working memory.
    std::vector<FieldWorker> workers_;
    TransportationSolver solver_;
    BottleneckSolver bottleneck_;
    TransportationSolution solution_;
    CommitRule commitRule_;
    std::vector<double> cost_;             // Costs of characters x places [m].
    std::vector<double> powered_;          // Costs to the power of the objective.
    std::vector<double> classed_;          // Costs with classes: pairs outside of them come last.
    std::vector<double> allowed_;          // The costs, infinite for pairs costlier than the bottleneck.
    std::vector<double> demand_;           // Demand per place.
    std::vector<double> unclaimedDemand_;  // Demand per place that incumbents do not claim.
    std::vector<Flow> incumbents_;         // Flows of the incumbents, ordered by character.
    std::vector<std::int32_t> mainPlace_;  // Per character, -1 for none.
    // Places whose optimal flow uses a pair of which only a bound is known.
    std::vector<std::int32_t> unproven_;
};

}  // namespace muster
