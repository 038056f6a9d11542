// Facts of motion clips in a scenario; some come from the clips' files.
#pragma once

#include <string>

#include "files/scenario/fields.h"
#include "muster/ground.h"

namespace muster {

/// Gives a clip with the name of one of Muster's own clips the facts of that clip.
void takeOwnFacts(ClipFacts& clip);

/// Reads speed, length, duration and cyclic from the clip's file in `folder` where the object omits them.
/// Speeds are relative to `run` [m/s]; 0 for the running clip itself.
void readClipFile(FieldReader& v, ClipFacts& clip, const std::string& folder, double run);

/// The clip's file, from which what the object omits is read.
template <class Visitor>
void describeClipFile(Visitor& v, ClipFacts& clip, const std::string& folder, double run) {
    if constexpr (Visitor::kReading) takeOwnFacts(clip);
    v.text(
        "file", clip.file,
        "The clip's BVH file, in the scenario's folder or below it: what is left out here is read from it.");
    if constexpr (Visitor::kReading) readClipFile(v, clip, folder, run);
}

/// Speed of running by the facts of the running clip [m/s]; that of Muster's own clip where they do not give
/// it.
double runSpeed(const std::vector<ClipFacts>& clips);

}  // namespace muster
