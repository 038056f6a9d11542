#include <algorithm>

#include "people/generator/transitions.h"

namespace muster::generator {

Clip transitionClip(const Transition& transition) {
    const LegTrack left(0, transition.steps[0], transition.course, transition.before[0], transition.after[0]);
    const LegTrack right(1, transition.steps[1], transition.course, transition.before[1],
                         transition.after[1]);
    ClipDef plan;
    plan.name = transition.name;
    plan.motion = transition.motion;
    plan.frames = transition.frames;
    plan.figure = [&](double time) {
        return Figure{transition.course.body(time), {left.at(time), right.at(time)}, {}};
    };
    plan.travel = transition.course.travel;
    addContacts(plan.contacts, 0, left.steps(), transition.frames / kFrameRate, false);
    addContacts(plan.contacts, 1, right.steps(), transition.frames / kFrameRate, false);
    plan.entryPhase = transition.entryPhase;
    plan.exitPhase = transition.exitPhase;
    plan.obstacle = transition.obstacle;
    return makeClip(std::move(plan));
}

std::function<double(double)> changingSpeed(double from, double to, double begin, double end) {
    return [=](double time) {
        const double u = std::clamp((time - begin) / (end - begin), 0.0, 1.0),
                     after = std::max(0.0, time - end);
        return from * time + (to - from) * ((end - begin) * u * u * u * (1.0 - 0.5 * u) + after);
    };
}

Step stepOutside(Step step, double begin) {
    step.begin = begin;
    step.end = begin + 0.5;
    step.swing = {};
    return step;
}

}  // namespace muster::generator
