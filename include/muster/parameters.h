// Every number that researchers and users may change, with name, unit, range and default.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "muster/status.h"

namespace muster {

struct UnitCostDef;

/// Parameters of a world. Switches are 0 or 1. The defaults are the preset `muster`.
struct Parameters {
    double stepTime = 1.0 / 60.0;
    // Input layer (SPEC U1-U6).
    double touchWindow = 0.15;
    double touchReach = 1.5;
    double checkpointSpacing = 0.5;
    double controlSpeed = 1.6;
    double clockRate = 4.0;
    double softWeight = 6.0;
    double opposingForce = 1.0;
    double opposingGain = 0.35;
    // Mesh layer (SPEC M2-M5).
    double relaxTime = 1.0;
    double environmentField = 1.0;
    double fieldRange = 1.5;
    double fieldStrength = 1.0;
    double fieldGain = 1.0;
    double fieldSpeed = 1.5;
    double morphSpeed = 3.0;
    double placeSpeed = 2.0;
    double placeClearance = 0.02;
    // Cost (SPEC A3-A5).
    double alpha = 0.5;
    double beta = 0.5;
    double gamma = 1.0;
    double density = 1.0;
    double densityCell = 1.0;
    double densityLambda = 1.0;
    double densityMin = 1.3;
    double densityMax = 3.5;
    double densityLookAhead = 0.5;
    double minSpeed = 0.05;
    double discomfort = 1.0;
    double discomfortTime = 1.5;
    double discomfortRange = 1.0;
    double discomfortGain = 8.0;
    // Plan (SPEC A1).
    double planMode = 0.0;
    double planSolver = 1.0;
    double objective = 0.0;
    double planPeriod = 0.0;
    double exponent = 2.0;
    double threshold = 0.02;
    double thresholdShare = 0.003;
    double geodesic = 1.0;
    // Characters (SPEC A6).
    double radius = 0.25;
    double maxSpeed = 2.0;
    double acceleration = 10.0;
    double velocityGain = 12.0;
    double positionGain = 3.0;
    double directReach = 1.5;
    double separationGain = 1.0;
    double separationReach = 0.15;
    double contactIterations = 8.0;
};

/// What is known of one parameter.
struct ParameterInfo {
    std::string_view name;         ///< As files and messages spell it: "plan.exponent".
    std::string_view unit;         ///< "m", "s", "m/s", "1", "switch"...
    double minimum;                ///< Smallest allowed value.
    double maximum;                ///< Largest allowed value.
    std::string_view description;  ///< One sentence.
    double Parameters::*member;    ///< Where it stands.
};

/// Plans a world can follow; the values of `plan.mode`.
enum class PlanMode {
    Transport = 0,     ///< Re-planned every period.
    AssignedOnce = 1,  ///< Assigned at the start and after each formation change, then kept.
    Fixed = 2,         ///< Character i keeps place i.
};

/// Who makes the plans; the values of `plan.solver`.
enum class PlanSolver {
    Exact = 0,  ///< The reference: one cost field per place.
    Fast = 1,   ///< The same answer nearly, for large crowds.
};

/// What a plan makes least; the values of `plan.objective`.
enum class PlanObjective {
    Power = 0,        ///< The sum of cost^p, p by `plan.exponent`: 1 least sum, 2 least squares.
    LongestWalk = 1,  ///< The cost of the dearest pair, and then that sum.
};

/// Steps from plan to plan: `plan.period`, or where that is 0 what suits the solver.
std::uint32_t planPeriodOf(const Parameters& parameters);

/// Weights and thresholds of the unit cost as the parameters say.
UnitCostDef unitCostDef(const Parameters& parameters);

/// All parameters, in a fixed order.
std::span<const ParameterInfo> parameterTable();
/// Sets one by name. Fails with NotFound, or InvalidArgument naming name, value and range (numbers that stand
/// for switches or whole numbers must be such).
Status setParameter(Parameters& parameters, std::string_view name, double value);
/// "muster" (the defaults) or "paper" (p = 1, threshold 0, a plan every step). Fails with NotFound.
Result<Parameters> parameterPreset(std::string_view name);
/// Sets what the presets differ in as that preset has it; all else stays. Fails, changing nothing, with
/// NotFound.
Status usePreset(Parameters& parameters, std::string_view name);

}  // namespace muster
