// Transition clips between gaits, standing and turning on the spot, and to motions that use the hands:
// crawling and swimming.
#pragma once

#include <vector>

#include "muster/clip.h"
#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"
#include "people/generator/leg_track.h"

namespace muster::generator {

/// The description of a clip on two feet: its travel, its body and its steps.
struct Transition {
    std::string name;                  ///< Name of the clip.
    std::string motion = "run";        ///< Name of the clip's motion.
    int frames = 60;                   ///< Number of frame intervals.
    Course course;                     ///< Travel and body.
    std::vector<Step> steps[2];        ///< Steps of the left and the right foot.
    std::optional<LegJoin> before[2];  ///< Set if the leg is in mid-swing at the start.
    std::optional<LegJoin> after[2];   ///< Set if the leg is in mid-swing at the end.
    double entryPhase = 0.0;           ///< Entry phase as in Clip::entryPhase.
    double exitPhase = 0.0;            ///< Exit phase as in Clip::exitPhase.
    ClipObstacle obstacle;             ///< Obstacle that the clip crosses, if any.
};

/// Samples a transition into a clip.
Clip transitionClip(const Transition& transition);

/// Distance [m] by time, 0 at time 0, whose speed [m/s] changes from `from` at time `begin` to `to` at time
/// `end` [s].
std::function<double(double)> changingSpeed(double from, double to, double begin, double end);

/// Adds "start", "start-walk", "stop", "stop-walk", "turn-left", "turn-right", "duck-enter" and "duck-exit".
void addTransitions(std::vector<Clip>& clips);

/// A step moved to `begin` [s], outside the clip, for a leg that comes from or goes to another motion than a
/// step.
Step stepOutside(Step step, double begin);

/// Adds "crawl-enter" and "crawl-exit".
void addCrawlTransitions(std::vector<Clip>& clips);
/// Adds "swim-enter" and "swim-exit".
void addSwimTransitions(std::vector<Clip>& clips);

}  // namespace muster::generator
