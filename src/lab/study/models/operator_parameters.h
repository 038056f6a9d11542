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

/// Times and scatter of one pointing device. Lengths are on the display.
struct DeviceParameters {
    double pointBase = 0.0;     ///< Time to point or tap at index of difficulty 0 [s].
    double pointSlope = 0.0;    ///< Time to point or tap per bit more [s].
    double press = 0.0;         ///< Time to press a button, and as long again to release it [s].
    double dragBase = 0.0;      ///< Time to drag to a target at index of difficulty 0 [s].
    double dragSlope = 0.0;     ///< Time to drag per bit more [s].
    double steerBase = 0.0;     ///< Time to begin a path [s].
    double steerSlope = 0.0;    ///< Time per width of the path that may be strayed over [s].
    double lostWidth = 0.0;     ///< Part of that width that the finger hides [mm].
    double drawSpeed = 0.0;     ///< Top speed of drawing in the open [mm/s].
    double scatterShare = 0.0;  ///< Standard deviation of end points, as a share of the target's width...
    double scatterLeast = 0.0;  ///< ...and the length whose square is added to the square [mm].
    double wobble = 0.0;        ///< Standard deviation of a path about its aim [mm].
    double latency = 0.0;       ///< Time from a movement to its picture [s].
    double handOff = 0.0;       ///< Time from lifting a finger to the next touch of the same hand [s].
};

/// All constants of an operator model.
struct OperatorParameters {
    DeviceParameters mouse;     ///< Constants of the mouse.
    DeviceParameters touch;     ///< Constants of fingers.
    double hands = 2.0;         ///< Hands on the touch screen, 1 or 2.
    double secondHand = 0.2;    ///< Additional time for a second hand with an aim of its own [s].
    double key = 0.2;           ///< Time to press a key [s].
    double reaction = 0.25;     ///< Time from a sight to the reaction to it [s].
    double takeIn = 0.5;        ///< Time to take in the scene at the start [s]...
    double takeInItem = 0.05;   ///< ...and additional time for each item [s].
    double decide = 1.2;        ///< Time to decide something new [s].
    double decideNext = 0.3;    ///< Time to decide the next step of a plan [s].
    double chooseBase = 0.24;   ///< Time to choose among groups [s]...
    double chooseSlope = 0.08;  ///< ...and additional time for each bit [s].
    double attention = 0.3;     ///< Time in which attention goes from one group to another [s].
    double groupsInMind = 4.0;  ///< Number of groups that are directed at once.
    double replan = 1.0;        ///< Least time between two plans [s].
    double routeDetour = 0.08;  ///< Share by which tours are longer than the best found.
    double noise = 0.3;         ///< Coefficient of variation of each time.
    double between = 0.22;      ///< Standard deviation of the logarithm of a model's own factor of time.
};

/// A constant in files, reports and sweeps.
struct OperatorConstant {
    std::string_view name;               ///< Name such as "touch.drag-slope".
    std::string_view unit;               ///< Unit such as "s" or "mm"; empty for a number.
    double low = 0.0;                    ///< Least value of sweeps.
    double high = 0.0;                   ///< Greatest value of sweeps.
    std::string_view source;             ///< Source of value and range.
    double& (*at)(OperatorParameters&);  ///< The constant in its parameters.
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
