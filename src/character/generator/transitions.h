// Clips from one way of moving on two feet to another.
#pragma once

#include "character/generator/clip_maker.h"
#include "character/generator/gait.h"

namespace muster::generator {

/// A clip on two feet: where it goes, how it holds itself, and its steps.
struct Transition {
    std::string name;
    std::string motion = "run";
    int frames = 60;
    Course course;
    std::vector<Step> steps[2];        ///< Left, right.
    std::optional<LegJoin> before[2];  ///< Where a leg is in mid-swing at the start.
    std::optional<LegJoin> after[2];   ///< Where one is at the end.
    double entryPhase = 0.0;
    double exitPhase = 0.0;
    ClipObstacle obstacle;
};

/// The clip of a transition.
Clip transitionClip(const Transition& transition);

/// A way [m] whose speed [m/s] changes from `from` at time `begin` to `to` at time `end` [s], 0 at time 0.
std::function<double(double)> changingSpeed(double from, double to, double begin, double end);

/// "start", "start-walk", "stop", "stop-walk", "turn-left", "turn-right", "duck-enter", "duck-exit".
void addTransitions(std::vector<Clip>& clips);

}  // namespace muster::generator
