// The operator models' constants: times, scatter and attention of people, with their sources.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/status.h"

namespace muster {

/// Version of all constants and of all that operator models do with them: any change raises it.
inline constexpr std::int32_t kOperatorVersion = 1;

/// What one pointing device costs. Lengths are on the display.
struct DeviceParameters {
    double pointBase = 0.0;     ///< Time to point or tap at index of difficulty 0 [s].
    double pointSlope = 0.0;    ///< More of it for each bit [s].
    double press = 0.0;         ///< Pressing a button, and as long again for releasing it [s].
    double dragBase = 0.0;      ///< Time to drag to a target at index of difficulty 0 [s].
    double dragSlope = 0.0;     ///< More of it for each bit [s].
    double steerBase = 0.0;     ///< Time to begin a path [s].
    double steerSlope = 0.0;    ///< Time per width of the path that may be strayed over [s].
    double lostWidth = 0.0;     ///< What the finger hides of that width [mm].
    double drawSpeed = 0.0;     ///< Top speed in the open [mm/s].
    double scatterShare = 0.0;  ///< Standard deviation of end points, as a share of the target's width...
    double scatterLeast = 0.0;  ///< ...and what is added to it, squared [mm].
    double wobble = 0.0;        ///< Standard deviation of a path about its aim [mm].
    double latency = 0.0;       ///< From a movement to its picture [s].
    double handOff = 0.0;       ///< From lifting a finger to the next touch of the same hand [s].
};

/// All constants of an operator model.
struct OperatorParameters {
    DeviceParameters mouse;     ///< Of the mouse.
    DeviceParameters touch;     ///< Of fingers.
    double hands = 2.0;         ///< Hands on the touch screen, 1 or 2.
    double secondHand = 0.2;    ///< More for a second hand with an aim of its own [s].
    double key = 0.2;           ///< Pressing a key [s].
    double reaction = 0.25;     ///< From what is seen to what is done about it [s].
    double takeIn = 0.5;        ///< Taking in the scene at the start [s]...
    double takeInItem = 0.05;   ///< ...and more of it for each item [s].
    double decide = 1.2;        ///< Deciding something new [s].
    double decideNext = 0.3;    ///< Deciding the next step of a plan [s].
    double chooseBase = 0.24;   ///< Choosing among groups [s]...
    double chooseSlope = 0.08;  ///< ...and more of it for each bit [s].
    double attention = 0.3;     ///< Attention goes from one group to another [s].
    double groupsInMind = 4.0;  ///< Groups that are directed at once.
    double replan = 1.0;        ///< Least time between two plans [s].
    double routeDetour = 0.08;  ///< By how much routes are longer than the best found, as a share.
    double noise = 0.3;         ///< Coefficient of variation of each time.
    double between = 0.22;      ///< Standard deviation of the logarithm of a model's own factor of time.
};

/// A constant in files, reports and sweeps.
struct OperatorConstant {
    std::string_view name;               ///< "touch.drag-slope"...
    std::string_view unit;               ///< "s", "mm", "" for a number.
    double low = 0.0;                    ///< Least value of sweeps.
    double high = 0.0;                   ///< Greatest value of sweeps.
    std::string_view source;             ///< Where value and range come from.
    double& (*at)(OperatorParameters&);  ///< Its place.
};

/// All constants, in the order of reports.
std::span<const OperatorConstant> operatorConstants();
/// The parameters that a setting names: "default", "equal-motor" (fingers cost what the mouse costs),
/// "NAME=VALUE" for a constant, "draw N" for row N of the Latin hypercube. Fails with NotFound or ParseError.
Result<OperatorParameters> operatorSetting(const std::string& setting);
/// Rows of the Latin hypercube over all constants' ranges.
inline constexpr std::int32_t kHypercubeDraws = 200;
/// The settings of the sweep of one constant at a time: both ends of each range.
std::vector<std::string> oneAtATimeSettings();

}  // namespace muster
