#include "engine/state/layer_defs.h"

namespace muster {
namespace {

constexpr std::int32_t kExactPeriod = 4;  // Exact plans take several steps, fast ones one.
constexpr std::int32_t kFastPeriod = 1;

}  // namespace

ControlDef controlDef(const Parameters& parameters) {
    ControlDef def;
    def.window = parameters.input.window;
    def.checkpointSpacing = parameters.input.checkpointSpacing;
    def.maxSpeed = parameters.control.speed;
    def.clockRate = parameters.control.clockRate;
    def.softWeight = parameters.control.softWeight;
    return def;
}

FormationMeshDef meshDef(const Parameters& parameters) {
    FormationMeshDef def;
    def.relaxTime = parameters.mesh.relaxTime;
    def.morphSpeed = parameters.mesh.morphSpeed;
    def.environmentField = parameters.field.enabled;
    def.fieldGain = parameters.field.gain;
    def.fieldSpeed = parameters.field.speed;
    return def;
}

PlaceDef placeDef(const Parameters& parameters) {
    return {parameters.character.radius, parameters.place.clearance, parameters.place.speed, 0.0};
}

UnitCostDef unitCostDef(const Parameters& parameters) {
    UnitCostDef def;
    def.alpha = parameters.cost.alpha;
    def.beta = parameters.cost.beta;
    def.gamma = parameters.cost.gamma;
    def.minSpeed = parameters.cost.minSpeed;
    def.freeSpeed = parameters.character.maxSpeed;
    def.density = parameters.density.enabled;
    def.densityMin = parameters.density.min;
    def.densityMax = parameters.density.max;
    def.lookAhead = parameters.density.lookAhead;
    def.discomfort = parameters.discomfort.enabled;
    def.discomfortTime = parameters.discomfort.time;
    def.discomfortRange = parameters.discomfort.range;
    def.discomfortGain = parameters.discomfort.gain;
    return def;
}

PlanDef planDef(const Parameters& parameters) {
    PlanDef def;
    def.exponent = parameters.plan.exponent;
    def.commitThreshold = parameters.plan.threshold;
    def.commitThresholdShare = parameters.plan.thresholdShare;
    def.bottleneck = parameters.plan.objective == PlanObjective::LongestWalk;
    def.geodesic = parameters.plan.geodesic;
    return def;
}

ContactDef contactDef(const Parameters& parameters) {
    return {parameters.character.radius, parameters.contact.iterations};
}

std::int32_t planPeriod(const Parameters& parameters) {
    if (parameters.plan.period > 0) return parameters.plan.period;
    return parameters.plan.solver == PlanSolver::Exact ? kExactPeriod : kFastPeriod;
}

}  // namespace muster
