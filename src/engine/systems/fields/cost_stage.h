// The stage of density and costs (SPEC A3 to A5).
#pragma once

#include <cstdint>
#include <map>
#include <memory>

#include "engine/assignment/planning/plan_costs.h"
#include "engine/fields/cost/density.h"
#include "engine/fields/cost/unit_cost_builder.h"
#include "engine/state/world_state.h"

namespace muster {

/// Owns the density of the crowd, and the costs that plans read. It computes a cost when it is asked for.
class CostStage final : public PlanCosts {
public:
    /// Prepares the density for a world before its first step.
    void reset(WorldState& state);
    /// Computes the density, after which the costs of the last step are out of date. The state must outlive
    /// the next call.
    void splatDensity(WorldState& state);
    /// Updates the unit cost if it was read lately.
    void updateUnitCost();

    /// Density and average velocity by the last run.
    const DensityField& density() const { return density_; }
    const Environment& environment() const override { return state_->environment; }
    const UnitCost& unitCost() override;
    const StaticGround& staticGround() override;
    const DynamicCost& dynamicCost() override;
    RouteGraph* routes() override { return &state_->refreshRoutes(); }
    SharedFarFields* farFields() override;
    PlanCosts& ofClass(std::int32_t groundClass) override;

private:
    // The costs of a class of ground other than the usual one.
    class ClassCosts final : public PlanCosts {
    public:
        ClassCosts(CostStage& stage, std::int32_t groundClass) : stage_(stage), class_(groundClass) {}
        // Marks the costs of the last step as out of date.
        void begin() {
            unitCostBuilt_ = dynamicCostBuilt_ = false;
            farFields_.beginStep();
        }

        const Environment& environment() const override { return stage_.environment(); }
        const UnitCost& unitCost() override;
        const StaticGround& staticGround() override;
        const DynamicCost& dynamicCost() override;
        RouteGraph* routes() override { return &stage_.state_->refreshRoutes(class_); }
        SharedFarFields* farFields() override;

    private:
        double radius() const;

        CostStage& stage_;
        std::int32_t class_;
        UnitCostBuilder builder_;
        bool unitCostBuilt_ = false;
        StaticGround ground_;
        SharedFarFields farFields_;
        DynamicCost dynamicCost_;
        bool dynamicCostBuilt_ = false;
    };

    void buildUnitCost();

    WorldState* state_ = nullptr;
    Parameters::Density def_;  // Parameters of the density; its cells and lambda are made for them.
    DensityField density_;
    UnitCostBuilder builder_;
    bool unitCostBuilt_ = false;       // True once it is built for the present density.
    std::int32_t unitCostUnread_ = 0;  // Steps since the unit cost was last asked for.
    StaticGround ground_;
    SharedFarFields farFields_;
    DynamicCost dynamicCost_;
    bool dynamicCostBuilt_ = false;  // True once it is built for the present density.
    std::map<std::int32_t, std::unique_ptr<ClassCosts>> classes_;
};

}  // namespace muster
