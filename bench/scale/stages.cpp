#include "scale/stages.h"

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
        std::snprintf(part, sizeof(part), "%s%s %.1f", text.empty() ? "" : ", ", stepStages()[k].name.data(),
                      times.milliseconds[k]);
        text += part;
    }
    return text;
}

}  // namespace muster::scale
