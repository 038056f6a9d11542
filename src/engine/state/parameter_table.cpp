// The table of parameters, and the presets.
#include "muster/parameter_table.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <type_traits>

#include "engine/ground/environment/environment.h"
#include "engine/state/validation_parts.h"

namespace muster {
namespace {

using P = Parameters;

// Clearance is known up to its limit only, and a place needs the radius and its own clearance.
constexpr double kMaxRadius = 0.5 * Environment::kClearanceLimit;

double readStep(const Parameters& parameters) {
    return parameters.stepTime;
}
void writeStep(Parameters& parameters, double value) {
    parameters.stepTime = value;
}

/// Reads one field of one group as a number.
template <auto Group, auto Field>
double read(const Parameters& parameters) {
    return static_cast<double>((parameters.*Group).*Field);
}

/// Writes a valid number to one field of one group.
template <auto Group, auto Field>
void write(Parameters& parameters, double value) {
    auto& target = (parameters.*Group).*Field;
    target = static_cast<std::remove_reference_t<decltype(target)>>(value);
}

template <auto Group, auto Field>
constexpr ParameterInfo field(std::string_view name, std::string_view unit, double minimum, double maximum,
                              std::string_view description) {
    return {name, unit, minimum, maximum, description, &read<Group, Field>, &write<Group, Field>};
}

constexpr auto kTable = std::to_array<ParameterInfo>({
    {"time.step", "s", 1.0 / 240.0, 1.0 / 10.0, "Simulated time of one step.", &readStep, &writeStep},
    field<&P::input, &P::Input::window>("input.window", "s", 0.0, 2.0,
                                        "Touches that begin within it form one control."),
    field<&P::input, &P::Input::reach>("input.reach", "m", 0.0, 100.0,
                                       "A touch farther than this from every mesh holds nothing."),
    field<&P::input, &P::Input::checkpointSpacing>("input.checkpointSpacing", "m", 0.01, 100.0,
                                                   "Distance between checkpoints of a drawn path."),
    field<&P::control, &P::Control::speed>("control.speed", "m/s", 0.01, 100.0,
                                           "Top speed of control points along their paths."),
    field<&P::control, &P::Control::clockRate>(
        "control.clockRate", "1", 1.0, 100.0,
        "Drawing seconds followed per second when catching up, at most."),
    field<&P::control, &P::Control::softWeight>(
        "control.softWeight", "1", 1e-6, 1e6,
        "Weight of supplementary points against the mesh's own stiffness."),
    field<&P::opposing, &P::Opposing::enabled>("opposing.enabled", "switch", 0.0, 1.0,
                                               "The mesh waits for a crowd that falls behind."),
    field<&P::opposing, &P::Opposing::gain>("opposing.gain", "1/m", 0.0, 100.0,
                                            "Share of control speed lost per metre of mean lag."),
    field<&P::mesh, &P::Mesh::relaxTime>("mesh.relaxTime", "s", 0.01, 60.0,
                                         "Time in which a mesh without controls returns to its rest shape."),
    field<&P::field, &P::Field::enabled>("field.enabled", "switch", 0.0, 1.0,
                                         "Obstacles push mesh vertices away and out."),
    field<&P::field, &P::Field::range>("field.range", "m", 0.0, 100.0,
                                       "Range of the potential field of obstacles that give none."),
    field<&P::field, &P::Field::strength>("field.strength", "1", 0.0, 100.0,
                                          "Strength of the potential field of obstacles that give none."),
    field<&P::field, &P::Field::gain>("field.gain", "m", 0.0, 100.0,
                                      "Displacement of a vertex per unit of field."),
    field<&P::field, &P::Field::speed>("field.speed", "m/s", 0.01, 100.0,
                                       "Top speed at which a vertex's displacement changes."),
    field<&P::mesh, &P::Mesh::morphSpeed>("mesh.morphSpeed", "m/s", 0.01, 100.0,
                                          "Top vertex speed while relaxing or changing formation."),
    field<&P::place, &P::Place::speed>("place.speed", "m/s", 0.01, 100.0,
                                       "Top speed of travelling places in the open."),
    field<&P::place, &P::Place::clearance>(
        "place.clearance", "m", 0.0, kMaxRadius,
        "Kept between a place and obstacles beyond the characters' radius."),
    field<&P::cost, &P::Cost::alpha>("cost.alpha", "1", 0.0, 1000.0,
                                     "Weight of path length in the unit cost."),
    field<&P::cost, &P::Cost::beta>("cost.beta", "1", 0.0, 1000.0, "Weight of time in the unit cost."),
    field<&P::cost, &P::Cost::gamma>("cost.gamma", "1", 0.0, 1000.0,
                                     "Weight of discomfort in the unit cost."),
    field<&P::cost, &P::Cost::minSpeed>("cost.minSpeed", "1", 1e-3, 1.0,
                                        "Floor of the speed in a crowd, relative to the free speed."),
    field<&P::density, &P::Density::enabled>("density.enabled", "switch", 0.0, 1.0,
                                             "Crowded ground costs more."),
    field<&P::density, &P::Density::cell>("density.cell", "m", 0.1, 100.0, "Edge of a density cell."),
    field<&P::density, &P::Density::lambda>(
        "density.lambda", "1", 0.1, 10.0,
        "Exponent of the shares that a character gives to the cells around it."),
    field<&P::density, &P::Density::min>("density.min", "1/m^2", 0.0, 100.0,
                                         "Density below which nobody is slowed."),
    field<&P::density, &P::Density::max>("density.max", "1/m^2", 0.01, 100.0,
                                         "Density above which one moves with the flow; above density.min."),
    field<&P::density, &P::Density::lookAhead>("density.lookAhead", "m", 0.0, 10.0,
                                               "How far ahead density is read."),
    field<&P::discomfort, &P::Discomfort::enabled>("discomfort.enabled", "switch", 0.0, 1.0,
                                                   "Ground ahead of moving obstacles costs more."),
    field<&P::discomfort, &P::Discomfort::time>("discomfort.time", "s", 0.0, 60.0,
                                                "How far ahead moving obstacles are predicted."),
    field<&P::discomfort, &P::Discomfort::range>("discomfort.range", "m", 0.01, 100.0,
                                                 "How far discomfort reaches beyond the swept surface."),
    field<&P::discomfort, &P::Discomfort::gain>("discomfort.gain", "1", 0.0, 1000.0,
                                                "Discomfort on the obstacle's own track."),
    field<&P::plan, &P::Plan::mode>(
        "plan.mode", "mode", 0.0, 2.0,
        "0 re-planned every period, 1 assigned once, 2 character i keeps place i."),
    field<&P::plan, &P::Plan::solver>("plan.solver", "mode", 0.0, 1.0,
                                      "0 exact, the reference; 1 fast, for large crowds."),
    field<&P::plan, &P::Plan::objective>(
        "plan.objective", "mode", 0.0, 1.0,
        "0 least sum of cost^p, p by plan.exponent; 1 least longest walk, then least such sum."),
    field<&P::plan, &P::Plan::period>("plan.period", "steps", 0.0, 600.0,
                                      "A plan is made every so many steps; 0 for what suits the solver."),
    field<&P::plan, &P::Plan::exponent>("plan.exponent", "1", 1.0, 8.0,
                                        "Exponent p of the objective: 1 least sum, 2 least squares."),
    field<&P::plan, &P::Plan::threshold>("plan.threshold", "cost^p", 0.0, 1e9,
                                         "A change of places must lower the objective by more."),
    field<&P::plan, &P::Plan::thresholdShare>(
        "plan.thresholdShare", "1", 0.0, 1.0,
        "A change of places must lower the objective of those it concerns by more than this share."),
    field<&P::plan, &P::Plan::geodesic>("plan.geodesic", "switch", 0.0, 1.0,
                                        "Costs by the cost field; else straight-line distances."),
    field<&P::plan, &P::Plan::waits>("plan.waits", "switch", 0.0, 1.0,
                                     "Where many wait before a passage, some go round."),
    field<&P::character, &P::Character::radius>("character.radius", "m", 0.05, kMaxRadius,
                                                "Radius of a character."),
    field<&P::character, &P::Character::maxSpeed>("character.maxSpeed", "m/s", 0.01, 50.0,
                                                  "Top speed of a character in the open."),
    field<&P::character, &P::Character::acceleration>("character.acceleration", "m/s^2", 0.01, 1000.0,
                                                      "Top acceleration of a character."),
    field<&P::character, &P::Character::velocityGain>("character.velocityGain", "1/s", 0.0, 60.0,
                                                      "Gain of the controller on the error of velocity."),
    field<&P::character, &P::Character::positionGain>("character.positionGain", "1/s", 0.0, 60.0,
                                                      "Gain of the controller on the distance to the place."),
    field<&P::character, &P::Character::directReach>(
        "character.directReach", "m", 0.0, 100.0,
        "Within this clear straight line a character heads for its place."),
    field<&P::character, &P::Character::headway>("character.headway", "s", 0.02, 5.0,
                                                 "Time that a character keeps from who is ahead of it."),
    field<&P::character, &P::Character::inStep>(
        "character.inStep", "1", 0.0, 1.0,
        "Share of the speed of who is ahead that a character may walk on top of its headway: 1 in step."),
    field<&P::character, &P::Character::foresight>(
        "character.foresight", "s", 0.1, 10.0,
        "Time for which a character keeps clear of who comes towards it."),
    field<&P::contact, &P::Contact::iterations>("contact.iterations", "count", 1.0, 100.0,
                                                "Rounds that resolve contacts in a step."),
});

constexpr std::string_view kRetired[] = {"character.separationGain", "character.separationReach"};

}  // namespace

bool ParameterInfo::whole() const {
    return unit == "switch" || unit == "mode" || unit == "steps" || unit == "count";
}

bool ParameterInfo::valid(double value) const {
    return value >= minimum && value <= maximum && (!whole() || value == std::floor(value));
}

std::span<const ParameterInfo> parameterTable() {
    return kTable;
}

std::span<const std::string_view> retiredParameters() {
    return kRetired;
}

Status setParameter(Parameters& parameters, std::string_view name, double value) {
    for (const ParameterInfo& info : kTable) {
        if (info.name != name) continue;
        if (info.valid(value)) {
            info.set(parameters, value);
            return {};
        }
        const bool inside = value >= info.minimum && value <= info.maximum;
        const std::string range = std::string("[").append(numberText(info.minimum)) + ", " +
                                  numberText(info.maximum) + "]";
        return invalidArgument("parameter " + std::string(name) + " is " + numberText(value) +
                               (inside ? ", expected a whole number in " + range
                                       : ", expected a number in " + range + " " + std::string(info.unit)));
    }
    if (std::find(std::begin(kRetired), std::end(kRetired), name) != std::end(kRetired)) return {};
    return {StatusCode::NotFound, "there is no parameter \"" + std::string(name.substr(0, 80)) + "\""};
}

Result<Parameters> parameterPreset(std::string_view name) {
    Parameters parameters;
    if (name == "units" || name == "muster") return parameters;
    if (name == "people") {
        parameters.character.radius = 0.18;
        parameters.character.maxSpeed = 1.34;
        parameters.character.headway = 1.06;
        parameters.character.inStep = 0.0;
        parameters.character.foresight = 3.0;
        parameters.density.min = 0.75;
        parameters.cost.alpha = 0.0;
        parameters.cost.beta = 1.0;
        return parameters;
    }
    if (name == "paper") {
        parameters.plan.exponent = 1.0;
        parameters.plan.threshold = 0.0;
        parameters.plan.thresholdShare = 0.0;
        parameters.plan.solver = PlanSolver::Exact;
        parameters.plan.period = 1;
        return parameters;
    }
    return Status(StatusCode::NotFound, "there is no preset \"" + std::string(name.substr(0, 80)) +
                                            "\", expected units, people or paper");
}

Status usePreset(Parameters& parameters, std::string_view name) {
    const auto preset = parameterPreset(name);
    if (!preset.ok()) return preset.status();
    const Parameters units = *parameterPreset("units");
    const Parameters others[] = {*parameterPreset("people"), *parameterPreset("paper")};
    for (const ParameterInfo& info : kTable) {
        const double now = info.get(parameters), usual = info.get(units), wanted = info.get(*preset);
        const bool ofOther = std::any_of(std::begin(others), std::end(others), [&](const Parameters& other) {
            return info.get(other) != usual && info.get(other) == now;
        });
        if (wanted != usual || ofOther) info.set(parameters, wanted);
    }
    return {};
}

}  // namespace muster
