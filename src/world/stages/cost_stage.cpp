#include "world/stages/cost_stage.h"

#include <algorithm>

#include "world/state/layer_defs.h"

namespace muster {

void CostStage::reset(const WorldState& state) {
    def_ = state.parameters.density;
    density_ = DensityField(state.environment.def().box, def_);
    built_ = false;
}

void CostStage::run(const WorldState& state) {
    const Parameters::Density& def = state.parameters.density;
    if (def.cell != def_.cell || def.lambda != def_.lambda) reset(state);
    density_.splat(state.characters.position, state.characters.velocity);
    built_ = false;
    const auto reads = [](const Group& group) { return group.plan->readsUnitCost(); };
    if (std::any_of(state.groups.begin(), state.groups.end(), reads)) build(state);
}

const UnitCost& CostStage::unitCost(const WorldState& state) {
    if (!built_) build(state);
    return builder_.cost();
}

void CostStage::build(const WorldState& state) {
    builder_.update(unitCostDef(state.parameters), state.environment, density_,
                    state.parameters.character.radius);
    built_ = true;
}

}  // namespace muster
