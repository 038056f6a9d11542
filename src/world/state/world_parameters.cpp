// Views of the parameters, one for each part that reads some.
#include "world/state/world_state.h"

namespace muster {

UnitCostDef unitCostDef(const Parameters& parameters) {
    UnitCostDef def;
    def.alpha = parameters.alpha;
    def.beta = parameters.beta;
    def.gamma = parameters.gamma;
    def.density = parameters.density != 0.0;
    def.discomfort = parameters.discomfort != 0.0;
    def.freeSpeed = parameters.maxSpeed;
    def.densityMin = parameters.densityMin;
    def.densityMax = parameters.densityMax;
    def.lookAhead = parameters.densityLookAhead;
    def.minSpeed = parameters.minSpeed;
    def.discomfortTime = parameters.discomfortTime;
    def.discomfortRange = parameters.discomfortRange;
    def.discomfortGain = parameters.discomfortGain;
    return def;
}

void World::Impl::makeDensity() {
    density = DensityField(environment.def().box, {parameters.densityCell, parameters.densityLambda});
}

ControlDef World::Impl::controlDef() const {
    ControlDef def;
    def.window = parameters.touchWindow;
    def.checkpointSpacing = parameters.checkpointSpacing;
    def.maxSpeed = parameters.controlSpeed;
    def.clockRate = parameters.clockRate;
    def.softWeight = parameters.softWeight;
    return def;
}

FormationMeshDef World::Impl::meshDef() const {
    FormationMeshDef def;
    def.relaxTime = parameters.relaxTime;
    def.environmentField = parameters.environmentField != 0.0;
    def.fieldGain = parameters.fieldGain;
    def.fieldSpeed = parameters.fieldSpeed;
    def.morphSpeed = parameters.morphSpeed;
    return def;
}

PlaceDef World::Impl::placeDef() const {
    return {parameters.radius, parameters.placeClearance, parameters.placeSpeed};
}

PlanMode World::Impl::planMode() const {
    return static_cast<PlanMode>(static_cast<int>(parameters.planMode));
}

PlanDef World::Impl::planDef() const {
    PlanDef def;
    def.exponent = parameters.exponent;
    def.commitThreshold = parameters.threshold;
    def.commitThresholdShare = parameters.thresholdShare;
    def.bottleneck = static_cast<int>(parameters.objective) == static_cast<int>(PlanObjective::LongestWalk);
    def.geodesic = parameters.geodesic != 0.0;
    return def;
}

SteeringDef World::Impl::steeringDef() const {
    SteeringDef def;
    def.radius = parameters.radius;
    def.maxSpeed = parameters.maxSpeed;
    def.acceleration = parameters.acceleration;
    def.velocityGain = parameters.velocityGain;
    def.positionGain = parameters.positionGain;
    def.directReach = parameters.directReach;
    def.separationGain = parameters.separationGain;
    def.separationReach = parameters.separationReach;
    return def;
}

}  // namespace muster
