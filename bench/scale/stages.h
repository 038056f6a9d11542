// What a step and its stages took.
#pragma once

#include <string>

#include "muster/world.h"

namespace muster::scale {

/// Steps the world; CPU time of the thread [ms].
double timedStep(World& world);
/// Names and times of those stages that took at least so many milliseconds.
std::string stagesText(const StageTimes& times, double least);

}  // namespace muster::scale
