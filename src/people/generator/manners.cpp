#include "people/generator/other_clips.h"

#include <string>

#include "base/appearance_text.h"
#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"

namespace muster::generator {
namespace {

void addSet(std::vector<Clip>& clips, MotionSet set, GaitKind walking, GaitKind jogging) {
    const Gait walk = gaitOf(walking), jog = gaitOf(jogging);
    const std::string word = kMotionSetWords[static_cast<std::size_t>(set)];
    const auto add = [&](const char* name, const Gait& gait) {
        clips.push_back(gaitClip(word + name, "run", gait));
        clips.back().set = set;
    };
    add("-walk", walk);
    add("-walk-left", bent(walk, 2.0));
    add("-walk-right", bent(walk, -2.0));
    add("-jog", jog);
}

}  // namespace

void addMotionSets(std::vector<Clip>& clips) {
    addSet(clips, MotionSet::March, GaitKind::MarchingWalk, GaitKind::MarchingJog);
    addSet(clips, MotionSet::Weary, GaitKind::WearyWalk, GaitKind::WearyJog);
}

}  // namespace muster::generator
