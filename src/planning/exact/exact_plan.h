// The reference plan: one cost field per place, exact assignment (SPEC A1, A2).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "assignment/dense/bottleneck_assignment.h"
#include "planning/exact/commit_rule.h"
#include "planning/exact/plan_generation.h"
#include "planning/plan.h"

namespace muster {

/// Two generations: the pending one is being solved, the finished one steers.
class ExactPlan final : public Plan {
public:
    const char* name() const override { return "exact"; }
    bool readsUnitCost() const override { return true; }
    Status start(const PlanDef& def, const PlanInput& input) override;
    bool pending() const override { return pending_.valid(); }
    void advance(std::int32_t slice, std::int32_t slices, ThreadPool& pool) override;
    Status finish(ThreadPool& pool, PlanResult& result) override;
    void guide(const GuidanceInput& input, ThreadPool& pool, std::span<Vec2> direction,
               std::span<double> cost) override;
    std::int32_t waitingPlace(std::int32_t character) const override {
        const bool known = finished_.valid() && character >= 0 && character < finished_.characters();
        return known ? finished_.waitingPlace(character) : -1;
    }
    double costAt(std::int32_t place, Vec2 p) const override;
    void save(Writer& archive) const override;
    bool load(Reader& archive, ThreadPool& pool) override;
    bool suits(std::size_t characters, std::size_t places, const Grid& grid) const override {
        return pending_.suits(characters, places, grid) && finished_.suits(characters, places, grid);
    }
    void hash(Hasher& archive) const override;

private:
    struct Heading {
        Vec2 direction;
        double cost;
    };

    Status assign(ThreadPool& pool, PlanResult& result);
    Status solveProven(ThreadPool& pool);
    Status solveOnce();
    void keepIncumbents(PlanResult& result);
    void fillCosts(std::int32_t place);
    void collectIncumbents();
    void report(PlanResult& result);
    Heading head(Vec2 p, std::int32_t place, Vec2 placeNow, const Environment& environment,
                 double direct) const;
    Heading headUnknown(Vec2 p, const CostField* field, Vec2 placeNow, const Environment& environment) const;
    double steerRadius() const;

    PlanGeneration pending_;
    PlanGeneration finished_;
    // Working memory.
    std::vector<FieldWorker> workers_;
    TransportationSolver solver_;
    BottleneckSolver bottleneck_;
    TransportationSolution solution_;
    CommitRule rule_;
    std::vector<double> cost_;     // Characters x places.
    std::vector<double> powered_;  // The same to the power of the objective.
    std::vector<double> allowed_;  // ... where no pair may be dearer than the longest walk must be.
    std::vector<double> demand_;
    std::vector<double> left_;  // Demand not taken by incumbents.
    std::vector<Flow> incumbents_;
    std::vector<std::int32_t> unproven_;  // Places that were given to characters their fronts have not met.
};

}  // namespace muster
