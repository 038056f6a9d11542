// Facts of motion clips in a scenario; some come from the clips' files.
#pragma once

#include <string>

#include "files/scenario/fields.h"
#include "muster/patch.h"

namespace muster {

/// Gives a clip with the name of one of Muster's own clips the facts of that clip.
void takeOwnFacts(ClipFacts& clip);

/// Reads speed, length, duration and cyclic from the clip's file in `folder` where the object omits them.
/// Speeds are relative to `run` [m/s]; 0 for the running clip itself.
void readClipFile(FieldReader& v, ClipFacts& clip, const std::string& folder, double run);

template <class Visitor>
void describeClip(Visitor& v, ClipFacts& clip, const std::string& folder, double run) {
    v.text("name", clip.name, "What patches call it.", Need::Required);
    if constexpr (Visitor::kReading) takeOwnFacts(clip);
    v.text(
        "file", clip.file,
        "The clip's BVH file, in the scenario's folder or below it: what is left out here is read from it.");
    if constexpr (Visitor::kReading) readClipFile(v, clip, folder, run);
    v.number("speed", clip.speed, {0.01, 100.0}, "Travel speed relative to running.");
    v.number("length", clip.length, {0.0, 1e4, "m"}, "Ground covered by one play; 0 where unknown.");
    v.number("duration", clip.duration, {0.0, 1e4, "s"}, "Of one play.");
    v.flag("cyclic", clip.cyclic, "False for motions that happen once per patch, such as a jump.");
    v.number("transitionTime", clip.transitionTime, {0.0, 100.0, "s"},
             "Played on entering and leaving; 0 for none.");
    v.number("reachAhead", clip.reachAhead, {0.0, 2.0, "m"},
             "From the character's position to the head of a body that leans or lies; 0 for upright bodies.");
    v.number("reachBehind", clip.reachBehind, {0.0, 2.0, "m"}, "From there back to its hips.");
}

/// Speed of running by the facts of the running clip [m/s]; that of Muster's own clip where they do not give
/// it.
double runSpeed(const std::vector<ClipFacts>& clips);

}  // namespace muster
