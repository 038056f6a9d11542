#include <algorithm>

#include "character/generator/passages.h"

namespace muster::generator {

Clip passageClip(const Passage& passage) {
    const LegTrack left(0, passage.steps[0], passage.course, passage.before[0], passage.after[0]);
    const LegTrack right(1, passage.steps[1], passage.course, passage.before[1], passage.after[1]);
    ClipPlan plan;
    plan.name = passage.name;
    plan.motion = passage.motion;
    plan.frames = passage.frames;
    plan.figure = [&](double time) {
        return Figure{passage.course.body(time), {left.at(time), right.at(time)}, {}};
    };
    plan.travel = passage.course.travel;
    addContacts(plan.contacts, 0, left.steps(), passage.frames / kFrameRate, false);
    addContacts(plan.contacts, 1, right.steps(), passage.frames / kFrameRate, false);
    plan.entryPhase = passage.entryPhase;
    plan.exitPhase = passage.exitPhase;
    plan.obstacle = passage.obstacle;
    return makeClip(std::move(plan));
}

std::function<double(double)> changingSpeed(double from, double to, double begin, double end) {
    return [=](double time) {
        const double u = std::clamp((time - begin) / (end - begin), 0.0, 1.0),
                     after = std::max(0.0, time - end);
        return from * time + (to - from) * ((end - begin) * u * u * u * (1.0 - 0.5 * u) + after);
    };
}

}  // namespace muster::generator
