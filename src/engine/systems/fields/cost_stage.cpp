#include "engine/systems/fields/cost_stage.h"

#include "engine/state/ground_class.h"

namespace muster {
namespace {

// Steps for which the unit cost is still updated after it was last read: to update what one step has changed
// costs far less than to build it again.
constexpr std::int32_t kUnreadSteps = 60;

}  // namespace

void CostStage::reset(WorldState& state) {
    state_ = &state;
    def_ = state.parameters.density;
    density_ = DensityField(state.environment.def().box, def_);
    unitCostBuilt_ = dynamicCostBuilt_ = false;
    unitCostUnread_ = kUnreadSteps;
    for (const auto& own : classes_) own.second->begin();
}

void CostStage::splatDensity(WorldState& state) {
    const Parameters::Density& def = state.parameters.density;
    if (&state != state_ || def.cell != def_.cell || def.lambda != def_.lambda) reset(state);
    farFields_.beginStep();
    density_.splat(state.characters.position, state.characters.velocity);
    unitCostBuilt_ = dynamicCostBuilt_ = false;
    for (const auto& own : classes_) own.second->begin();
}

void CostStage::updateUnitCost() {
    if (unitCostUnread_ >= kUnreadSteps) return;
    ++unitCostUnread_;
    buildUnitCost();
}

const UnitCost& CostStage::unitCost() {
    unitCostUnread_ = 0;
    if (!unitCostBuilt_) buildUnitCost();
    return builder_.cost();
}

void CostStage::buildUnitCost() {
    builder_.update(state_->parameters, state_->environment, density_, state_->parameters.character.radius);
    unitCostBuilt_ = true;
}

const StaticGround& CostStage::staticGround() {
    const Parameters::Cost& cost = state_->parameters.cost;
    ground_.update(state_->environment, cost.alpha + cost.beta, state_->parameters.character.radius);
    return ground_;
}

SharedFarFields* CostStage::farFields() {
    farFields_.update(staticGround());
    return &farFields_;
}

const DynamicCost& CostStage::dynamicCost() {
    if (dynamicCostBuilt_) return dynamicCost_;
    dynamicCost_.update(state_->parameters, state_->environment, density_,
                        state_->parameters.character.radius);
    dynamicCostBuilt_ = true;
    return dynamicCost_;
}

PlanCosts& CostStage::ofClass(std::int32_t groundClass) {
    if (groundClass == 0) return *this;
    std::unique_ptr<ClassCosts>& own = classes_[groundClass];
    if (own == nullptr) own = std::make_unique<ClassCosts>(*this, groundClass);
    return *own;
}

double CostStage::ClassCosts::radius() const {
    return groundRadius(stage_.state_->parameters.character.radius, class_);
}

const UnitCost& CostStage::ClassCosts::unitCost() {
    if (!unitCostBuilt_) builder_.update(stage_.state_->parameters, environment(), stage_.density_, radius());
    unitCostBuilt_ = true;
    return builder_.cost();
}

const StaticGround& CostStage::ClassCosts::staticGround() {
    const Parameters::Cost& cost = stage_.state_->parameters.cost;
    ground_.update(environment(), cost.alpha + cost.beta, radius());
    return ground_;
}

SharedFarFields* CostStage::ClassCosts::farFields() {
    farFields_.update(staticGround());
    return &farFields_;
}

const DynamicCost& CostStage::ClassCosts::dynamicCost() {
    if (!dynamicCostBuilt_)
        dynamicCost_.update(stage_.state_->parameters, environment(), stage_.density_, radius());
    dynamicCostBuilt_ = true;
    return dynamicCost_;
}

}  // namespace muster
