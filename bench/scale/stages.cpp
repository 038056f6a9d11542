#include "scale/stages.h"

#include <algorithm>
#include <cstdio>

#include "scale/meter.h"

namespace muster::scale {

double timedStep(World& world) {
    const double began = threadMilliseconds();
    world.step();
    return threadMilliseconds() - began;
}

std::string stagesText(const StageTimes& times, double least) {
    std::string text;
    for (std::size_t k = 0; k < times.milliseconds.size(); ++k) {
        if (times.milliseconds[k] < least) continue;
        char part[64];
        std::snprintf(part, sizeof(part), "%s%s %.2f", text.empty() ? "" : ", ", stepStages()[k].name.data(),
                      times.milliseconds[k]);
        text += part;
    }
    return text;
}

void StageMeans::add(const StageTimes& times) {
    for (std::size_t k = 0; k < times.milliseconds.size(); ++k)
        sums_.milliseconds[k] += times.milliseconds[k];
    ++steps_;
}

std::string StageMeans::text(double least) const {
    StageTimes means = sums_;
    for (double& time : means.milliseconds) time /= static_cast<double>(std::max<std::int64_t>(1, steps_));
    return stagesText(means, least);
}

}  // namespace muster::scale
