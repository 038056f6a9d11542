// What a step and its stages took.
#pragma once

#include <cstdint>
#include <string>

#include "muster/world.h"

namespace muster::scale {

/// Steps the world; CPU time of the thread [ms].
double timedStep(World& world);
/// Names and times of those stages that took at least so many milliseconds.
std::string stagesText(const StageTimes& times, double least);
/// The mean of each stage over several steps.
class StageMeans {
public:
    void add(const StageTimes& times);
    /// Names and means of those stages that took at least so many milliseconds in the mean.
    std::string text(double least) const;

private:
    StageTimes sums_;
    std::int64_t steps_ = 0;
};

}  // namespace muster::scale
