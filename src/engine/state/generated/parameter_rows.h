// Made by schema/generate.mjs from schema/parameters.txt: change these, not this file.
// The rows of the table of parameters, and what presets change.
#pragma once

#include <array>
#include <string_view>

#include "engine/state/parameter_row.h"

namespace muster::parameter_rows {

using P = Parameters;

// clang-format off
inline constexpr auto kAll = std::to_array<ParameterInfo>({
    parameter<&P::stepTime>("time.step", "s", 1.0 / 240.0, 1.0 / 10.0,
        "Simulated time of one step."),
    parameter<&P::input, &P::Input::window>("input.window", "s", 0.0, 2.0,
        "Touches that begin within it form one control."),
    parameter<&P::input, &P::Input::reach>("input.reach", "m", 0.0, 100.0,
        "A touch farther than this from every mesh holds nothing."),
    parameter<&P::input, &P::Input::checkpointSpacing>("input.checkpointSpacing", "m", 0.01, 100.0,
        "Distance between checkpoints of a drawn path."),
    parameter<&P::control, &P::Control::speed>("control.speed", "m/s", 0.01, 100.0,
        "Top speed of control points along their paths."),
    parameter<&P::control, &P::Control::clockRate>("control.clockRate", "1", 1.0, 100.0,
        "Drawing seconds followed per second when catching up, at most."),
    parameter<&P::control, &P::Control::softWeight>("control.softWeight", "1", 1e-6, 1e6,
        "Weight of supplementary points against the mesh's own stiffness."),
    parameter<&P::opposing, &P::Opposing::enabled>("opposing.enabled", "switch", 0.0, 1.0,
        "The mesh waits for a crowd that falls behind."),
    parameter<&P::opposing, &P::Opposing::gain>("opposing.gain", "1/m", 0.0, 100.0,
        "Share of control speed lost per metre of mean lag."),
    parameter<&P::mesh, &P::Mesh::relaxTime>("mesh.relaxTime", "s", 0.01, 60.0,
        "Time in which a mesh without controls returns to its rest shape."),
    parameter<&P::field, &P::Field::enabled>("field.enabled", "switch", 0.0, 1.0,
        "Obstacles push mesh vertices away and out."),
    parameter<&P::field, &P::Field::range>("field.range", "m", 0.0, 100.0,
        "Range of the potential field of obstacles that give none."),
    parameter<&P::field, &P::Field::strength>("field.strength", "1", 0.0, 100.0,
        "Strength of the potential field of obstacles that give none."),
    parameter<&P::field, &P::Field::gain>("field.gain", "m", 0.0, 100.0,
        "Displacement of a vertex per unit of field."),
    parameter<&P::field, &P::Field::speed>("field.speed", "m/s", 0.01, 100.0,
        "Top speed at which a vertex's displacement changes."),
    parameter<&P::mesh, &P::Mesh::morphSpeed>("mesh.morphSpeed", "m/s", 0.01, 100.0,
        "Top vertex speed while relaxing or changing formation."),
    parameter<&P::place, &P::Place::speed>("place.speed", "m/s", 0.01, 100.0,
        "Top speed of travelling places in the open."),
    parameter<&P::place, &P::Place::clearance>("place.clearance", "m", 0.0, 1.5,
        "Kept between a place and obstacles beyond the characters' radius."),
    parameter<&P::cost, &P::Cost::alpha>("cost.alpha", "1", 0.0, 1000.0,
        "Weight of path length in the unit cost."),
    parameter<&P::cost, &P::Cost::beta>("cost.beta", "1", 0.0, 1000.0,
        "Weight of time in the unit cost."),
    parameter<&P::cost, &P::Cost::gamma>("cost.gamma", "1", 0.0, 1000.0,
        "Weight of discomfort in the unit cost."),
    parameter<&P::cost, &P::Cost::minSpeed>("cost.minSpeed", "1", 1e-3, 1.0,
        "Floor of the speed in a crowd, relative to the free speed."),
    parameter<&P::density, &P::Density::enabled>("density.enabled", "switch", 0.0, 1.0,
        "Crowded ground costs more."),
    parameter<&P::density, &P::Density::cell>("density.cell", "m", 0.1, 100.0,
        "Edge of a density cell."),
    parameter<&P::density, &P::Density::lambda>("density.lambda", "1", 0.1, 10.0,
        "Exponent of the shares that a character gives to the cells around it."),
    parameter<&P::density, &P::Density::min>("density.min", "1/m^2", 0.0, 100.0,
        "Density below which nobody is slowed."),
    parameter<&P::density, &P::Density::max>("density.max", "1/m^2", 0.01, 100.0,
        "Density above which one moves with the flow; above density.min."),
    parameter<&P::density, &P::Density::lookAhead>("density.lookAhead", "m", 0.0, 10.0,
        "How far ahead density is read."),
    parameter<&P::discomfort, &P::Discomfort::enabled>("discomfort.enabled", "switch", 0.0, 1.0,
        "Ground ahead of moving obstacles costs more."),
    parameter<&P::discomfort, &P::Discomfort::time>("discomfort.time", "s", 0.0, 60.0,
        "How far ahead moving obstacles are predicted."),
    parameter<&P::discomfort, &P::Discomfort::range>("discomfort.range", "m", 0.01, 100.0,
        "How far discomfort reaches beyond the swept surface."),
    parameter<&P::discomfort, &P::Discomfort::gain>("discomfort.gain", "1", 0.0, 1000.0,
        "Discomfort on the obstacle's own track."),
    parameter<&P::plan, &P::Plan::mode>("plan.mode", "mode", 0.0, 2.0,
        "0 re-planned every period, 1 assigned once, 2 character i keeps place i."),
    parameter<&P::plan, &P::Plan::solver>("plan.solver", "mode", 0.0, 1.0,
        "0 exact, the reference; 1 fast, for large crowds."),
    parameter<&P::plan, &P::Plan::objective>("plan.objective", "mode", 0.0, 1.0,
        "0 least sum of cost^p, p by plan.exponent; 1 least longest walk, then least such sum."),
    parameter<&P::plan, &P::Plan::period>("plan.period", "steps", 0.0, 600.0,
        "A plan is made every so many steps; 0 for what suits the solver."),
    parameter<&P::plan, &P::Plan::exponent>("plan.exponent", "1", 1.0, 8.0,
        "Exponent p of the objective: 1 least sum, 2 least squares."),
    parameter<&P::plan, &P::Plan::threshold>("plan.threshold", "cost^p", 0.0, 1e9,
        "A change of places must lower the objective by more."),
    parameter<&P::plan, &P::Plan::thresholdShare>("plan.thresholdShare", "1", 0.0, 1.0,
        "A change of places must lower the objective of those it concerns by more than this share."),
    parameter<&P::plan, &P::Plan::geodesic>("plan.geodesic", "switch", 0.0, 1.0,
        "Costs by the cost field; else straight-line distances."),
    parameter<&P::plan, &P::Plan::waits>("plan.waits", "switch", 0.0, 1.0,
        "Where many wait before a passage, some go round."),
    parameter<&P::character, &P::Character::radius>("character.radius", "m", 0.05, 1.5,
        "Radius of a character."),
    parameter<&P::character, &P::Character::maxSpeed>("character.maxSpeed", "m/s", 0.01, 50.0,
        "Top speed of a character in the open."),
    parameter<&P::character, &P::Character::acceleration>("character.acceleration", "m/s^2", 0.01, 1000.0,
        "Top acceleration of a character."),
    parameter<&P::character, &P::Character::velocityGain>("character.velocityGain", "1/s", 0.0, 60.0,
        "Gain of the controller on the error of velocity."),
    parameter<&P::character, &P::Character::positionGain>("character.positionGain", "1/s", 0.0, 60.0,
        "Gain of the controller on the distance to the place."),
    parameter<&P::character, &P::Character::directReach>("character.directReach", "m", 0.0, 100.0,
        "Within this clear straight line a character heads for its place."),
    parameter<&P::character, &P::Character::headway>("character.headway", "s", 0.02, 5.0,
        "Time that a character keeps from who is ahead of it."),
    parameter<&P::character, &P::Character::inStep>("character.inStep", "1", 0.0, 1.0,
        "Share of the speed of who is ahead that a character may walk on top of its headway: 1 in step."),
    parameter<&P::character, &P::Character::foresight>("character.foresight", "s", 0.1, 10.0,
        "Time for which a character keeps clear of who comes towards it."),
    parameter<&P::contact, &P::Contact::iterations>("contact.iterations", "count", 1.0, 100.0,
        "Rounds that resolve contacts in a step."),
});

/// Names of earlier versions.
inline constexpr auto kRetired = std::to_array<std::string_view>({"character.separationGain", "character.separationReach"});

/// The presets, the defaults first.
inline constexpr auto kPresets = std::to_array<std::string_view>({"units", "people", "paper"});
// clang-format on

/// Makes a preset of the defaults; false where there is none of that name.
inline bool makePreset(Parameters& p, std::string_view name) {
    if (name == "units" || name == "muster") return true;
    if (name == "people") {
        p.cost.alpha = 0.0;
        p.cost.beta = 1.0;
        p.density.min = 0.75;
        p.character.radius = 0.18;
        p.character.maxSpeed = 1.34;
        p.character.headway = 1.06;
        p.character.inStep = 0.0;
        p.character.foresight = 3.0;
        return true;
    }
    if (name == "paper") {
        p.plan.solver = PlanSolver::Exact;
        p.plan.period = 1;
        p.plan.exponent = 1.0;
        p.plan.threshold = 0.0;
        p.plan.thresholdShare = 0.0;
        return true;
    }
    return false;
}

}  // namespace muster::parameter_rows
