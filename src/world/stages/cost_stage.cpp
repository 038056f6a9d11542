#include "world/stages/cost_stage.h"

#include "world/state/layer_defs.h"

namespace muster {
namespace {

// The unit cost is updated in every step while somebody asks for it at least so often: an update of what one
// step changed costs far less than a build from scratch.
constexpr std::int32_t kUnreadSteps = 60;

}  // namespace

void CostStage::reset(WorldState& state) {
    state_ = &state;
    def_ = state.parameters.density;
    density_ = DensityField(state.environment.def().box, def_);
    unitCostBuilt_ = dynamicCostBuilt_ = false;
    unitCostUnread_ = kUnreadSteps;
}

void CostStage::run(WorldState& state) {
    const Parameters::Density& def = state.parameters.density;
    if (&state != state_ || def.cell != def_.cell || def.lambda != def_.lambda) reset(state);
    density_.splat(state.characters.position, state.characters.velocity);
    unitCostBuilt_ = dynamicCostBuilt_ = false;
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
    builder_.update(unitCostDef(state_->parameters), state_->environment, density_,
                    state_->parameters.character.radius);
    unitCostBuilt_ = true;
}

const StaticGround& CostStage::staticGround() {
    const Parameters::Cost& cost = state_->parameters.cost;
    ground_.update(state_->environment, cost.alpha + cost.beta, state_->parameters.character.radius);
    return ground_;
}

const DynamicCost& CostStage::dynamicCost() {
    if (dynamicCostBuilt_) return dynamicCost_;
    dynamicCost_.update(unitCostDef(state_->parameters), state_->environment, density_,
                        state_->parameters.character.radius);
    dynamicCostBuilt_ = true;
    return dynamicCost_;
}

}  // namespace muster
