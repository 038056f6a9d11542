// Facts of motion clips, some of which their files may tell.
#pragma once

#include <string>

#include "io/scenario/fields.h"
#include "muster/patch.h"

namespace muster {

/// Gives a clip that is called as one of Muster's own that one's facts.
void takeOwnFacts(ClipFacts& clip);

/// Takes from the clip's file in `folder` what the object leaves out of speed, length, duration and cyclic.
/// Speeds are relative to `run` [m/s]; 0 for the clip that is running itself.
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
}

/// Speed of running by the facts of the clip that stands for it [m/s]; Muster's own where they do not tell.
double runSpeed(const std::vector<ClipFacts>& clips);

}  // namespace muster
