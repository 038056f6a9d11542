#include "muster/parameters.h"

#include <array>
#include <cmath>
#include <string>

#include "environment/environment.h"
#include "world/state/number_text.h"

namespace muster {
namespace {

using P = Parameters;

// Clearance is known up to its limit only, and a place asks for the radius and its own clearance.
constexpr double kMaxRadius = 0.5 * Environment::kClearanceLimit;

constexpr auto kTable = std::to_array<ParameterInfo>({
    {"time.step", "s", 1.0 / 240.0, 1.0 / 20.0, "Simulated time of one step.", &P::stepTime},
    {"input.window", "s", 0.0, 2.0, "Touches that begin within it form one control.", &P::touchWindow},
    {"input.reach", "m", 0.0, 100.0, "A touch farther than this from every mesh holds nothing.",
     &P::touchReach},
    {"input.checkpointSpacing", "m", 0.01, 100.0, "Distance between checkpoints of a drawn path.",
     &P::checkpointSpacing},
    {"control.speed", "m/s", 0.01, 100.0, "Top speed of control points along their paths.", &P::controlSpeed},
    {"control.clockRate", "1", 1.0, 100.0, "Drawing seconds followed per second when catching up, at most.",
     &P::clockRate},
    {"control.softWeight", "1", 1e-6, 1e6, "Weight of supplementary points against the mesh's own stiffness.",
     &P::softWeight},
    {"opposing.enabled", "switch", 0.0, 1.0, "The mesh waits for a crowd that falls behind.",
     &P::opposingForce},
    {"opposing.gain", "1/m", 0.0, 100.0, "Share of control speed lost per metre of mean lag.",
     &P::opposingGain},
    {"mesh.relaxTime", "s", 0.01, 60.0, "Time in which a mesh without controls returns to its rest shape.",
     &P::relaxTime},
    {"field.enabled", "switch", 0.0, 1.0, "Obstacles push mesh vertices away and out.", &P::environmentField},
    {"field.range", "m", 0.0, 100.0, "Range of the potential field of obstacles that give none.",
     &P::fieldRange},
    {"field.strength", "1", 0.0, 100.0, "Strength of the potential field of obstacles that give none.",
     &P::fieldStrength},
    {"field.gain", "m", 0.0, 100.0, "Displacement of a vertex per unit of field.", &P::fieldGain},
    {"field.speed", "m/s", 0.01, 100.0, "Top speed at which a vertex's displacement changes.",
     &P::fieldSpeed},
    {"mesh.morphSpeed", "m/s", 0.01, 100.0, "Top vertex speed while relaxing or changing formation.",
     &P::morphSpeed},
    {"place.speed", "m/s", 0.01, 100.0, "Top speed of travelling places in the open.", &P::placeSpeed},
    {"place.clearance", "m", 0.0, kMaxRadius,
     "Kept between a place and obstacles beyond the characters' radius.", &P::placeClearance},
    {"cost.alpha", "1", 0.0, 1000.0, "Weight of path length in the unit cost.", &P::alpha},
    {"cost.beta", "1", 0.0, 1000.0, "Weight of time in the unit cost.", &P::beta},
    {"cost.gamma", "1", 0.0, 1000.0, "Weight of discomfort in the unit cost.", &P::gamma},
    {"cost.minSpeed", "1", 1e-3, 1.0, "Floor of the speed in a crowd, relative to the free speed.",
     &P::minSpeed},
    {"density.enabled", "switch", 0.0, 1.0, "Crowded ground costs more.", &P::density},
    {"density.cell", "m", 0.1, 100.0, "Edge of a density cell.", &P::densityCell},
    {"density.lambda", "1", 0.1, 10.0,
     "Exponent of the shares that a character gives to the cells around it.", &P::densityLambda},
    {"density.min", "1/m^2", 0.0, 100.0, "Density below which nobody is slowed.", &P::densityMin},
    {"density.max", "1/m^2", 0.01, 100.0, "Density above which one moves with the flow; above density.min.",
     &P::densityMax},
    {"density.lookAhead", "m", 0.0, 10.0, "How far ahead density is read.", &P::densityLookAhead},
    {"discomfort.enabled", "switch", 0.0, 1.0, "Ground ahead of moving obstacles costs more.",
     &P::discomfort},
    {"discomfort.time", "s", 0.0, 60.0, "How far ahead moving obstacles are predicted.", &P::discomfortTime},
    {"discomfort.range", "m", 0.01, 100.0, "How far discomfort reaches beyond the swept surface.",
     &P::discomfortRange},
    {"discomfort.gain", "1", 0.0, 1000.0, "Discomfort on the obstacle's own track.", &P::discomfortGain},
    {"plan.mode", "mode", 0.0, 2.0,
     "0 re-planned every period, 1 assigned once, 2 character i keeps place i.", &P::planMode},
    {"plan.solver", "mode", 0.0, 1.0, "0 exact, the reference; 1 fast, for large crowds.", &P::planSolver},
    {"plan.objective", "mode", 0.0, 1.0,
     "0 least sum of cost^p, p by plan.exponent; 1 least longest walk, then least such sum.", &P::objective},
    {"plan.period", "steps", 0.0, 600.0, "A plan is made every so many steps; 0 for what suits the solver.",
     &P::planPeriod},
    {"plan.exponent", "1", 1.0, 8.0, "Exponent p of the objective: 1 least sum, 2 least squares.",
     &P::exponent},
    {"plan.threshold", "cost^p", 0.0, 1e9, "A change of places must lower the objective by more.",
     &P::threshold},
    {"plan.thresholdShare", "1", 0.0, 1.0,
     "A change of places must lower the objective of those it concerns by more than this share.",
     &P::thresholdShare},
    {"plan.geodesic", "switch", 0.0, 1.0, "Costs by the cost field; else straight-line distances.",
     &P::geodesic},
    {"character.radius", "m", 0.05, kMaxRadius, "Radius of a character.", &P::radius},
    {"character.maxSpeed", "m/s", 0.01, 50.0, "Top speed of a character in the open.", &P::maxSpeed},
    {"character.acceleration", "m/s^2", 0.01, 1000.0, "Top acceleration of a character.", &P::acceleration},
    {"character.velocityGain", "1/s", 0.0, 60.0, "Gain of the controller on the error of velocity.",
     &P::velocityGain},
    {"character.positionGain", "1/s", 0.0, 60.0, "Gain of the controller on the distance to the place.",
     &P::positionGain},
    {"character.directReach", "m", 0.0, 100.0,
     "Within this clear straight line a character heads for its place.", &P::directReach},
    {"character.separationGain", "m/s", 0.0, 100.0, "Speed at which close neighbours move apart.",
     &P::separationGain},
    {"character.separationReach", "m", 0.0, 10.0, "Gap under which neighbours move apart.",
     &P::separationReach},
    {"contact.iterations", "count", 1.0, 100.0, "Rounds that resolve contacts in a step.",
     &P::contactIterations},
});

bool isWhole(const ParameterInfo& info) {
    return info.unit == "switch" || info.unit == "mode" || info.unit == "steps" || info.unit == "count";
}

}  // namespace

std::uint32_t planPeriodOf(const Parameters& parameters) {
    if (parameters.planPeriod >= 1.0) return static_cast<std::uint32_t>(parameters.planPeriod);
    return parameters.planSolver == 0.0 ? 4 : 1;
}

std::span<const ParameterInfo> parameterTable() {
    return kTable;
}

Status setParameter(Parameters& parameters, std::string_view name, double value) {
    for (const ParameterInfo& info : kTable) {
        if (info.name != name) continue;
        const std::string range = std::string("[").append(numberText(info.minimum)) + ", " +
                                  numberText(info.maximum) + "]";
        if (!(value >= info.minimum && value <= info.maximum)) {
            return invalidArgument("parameter " + std::string(name) + " is " + numberText(value) +
                                   ", expected a number in " + range + " " + std::string(info.unit));
        }
        if (isWhole(info) && value != std::floor(value)) {
            return invalidArgument("parameter " + std::string(name) + " is " + numberText(value) +
                                   ", expected a whole number in " + range);
        }
        parameters.*info.member = value;
        return {};
    }
    return {StatusCode::NotFound, "there is no parameter \"" + std::string(name.substr(0, 80)) + "\""};
}

Result<Parameters> parameterPreset(std::string_view name) {
    Parameters parameters;
    if (name == "muster") return parameters;
    if (name == "paper") {
        parameters.exponent = 1.0;
        parameters.threshold = 0.0;
        parameters.thresholdShare = 0.0;
        parameters.planSolver = 0.0;
        parameters.planPeriod = 1.0;
        return parameters;
    }
    return Status(StatusCode::NotFound,
                  "there is no preset \"" + std::string(name.substr(0, 80)) + "\", expected muster or paper");
}

Status usePreset(Parameters& parameters, std::string_view name) {
    const auto wanted = parameterPreset(name);
    if (!wanted.ok()) return wanted.status();
    const Parameters ours = *parameterPreset("muster"), papers = *parameterPreset("paper");
    for (const ParameterInfo& info : kTable)
        if (ours.*info.member != papers.*info.member) parameters.*info.member = (*wanted).*info.member;
    return {};
}

}  // namespace muster
