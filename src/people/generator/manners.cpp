#include "people/generator/other_clips.h"

#include <string>

#include "base/appearance_text.h"
#include "people/generator/clip_maker.h"
#include "people/generator/gait.h"

namespace muster::generator {
namespace {

Gait marchingWalk() {
    Gait gait = walkGait();
    gait.cycle = 62 / kFrameRate;
    gait.footOut = 0.045;
    gait.toeOut = degrees(4);
    gait.swing = {{swingKey(0.25, 16), swingKey(0.5, 43), swingKey(0.75, 38)},
                  {swingKey(0.28, 76), swingKey(0.5, 82), swingKey(0.75, 38)},
                  {swingKey(0.13, -15), swingKey(0.30, 2), swingKey(0.6, 11)}};
    gait.sway = 0.012;
    gait.pelvisPitch = degrees(2);
    gait.pelvisRoll = degrees(2);
    gait.lean = degrees(-3);
    gait.nod = 0.0;
    gait.chestYaw = degrees(4);
    gait.chestRoll = 0.0;
    gait.headPitch = degrees(-2);
    gait.arm = {degrees(2), degrees(36), 0.02};
    gait.armOut = degrees(6);
    gait.armTurn = degrees(10);
    gait.armAcross = 0.0;
    gait.elbow = {degrees(9), degrees(5), 0.04};
    gait.wrist = degrees(2);
    return gait;
}

Gait marchingJog() {
    Gait gait = jogGait();
    gait.sway = 0.008;
    gait.pelvisPitch = degrees(4);
    gait.pelvisYaw = degrees(4);
    gait.lean = degrees(1);
    gait.nod = degrees(1);
    gait.chestYaw = degrees(4);
    gait.chestRoll = degrees(1);
    gait.headPitch = 0.0;
    gait.arm = {degrees(-14), degrees(24), 0.02};
    gait.armOut = degrees(8);
    gait.armAcross = 0.0;
    gait.elbow = {degrees(92), degrees(4), 0.1};
    return gait;
}

Gait wearyWalk() {
    Gait gait = walkGait();
    gait.cycle = 70 / kFrameRate;
    gait.speed = 1.1;
    gait.contact = 0.63;
    gait.footOut = 0.07;
    gait.toeOut = degrees(12);
    gait.strike = degrees(12);
    gait.push = degrees(46);
    gait.height = 0.895;
    gait.bob = 0.02;
    gait.sway = 0.034;
    gait.pelvisPitch = degrees(9);
    gait.pelvisRoll = degrees(5);
    gait.lean = degrees(19);
    gait.nod = degrees(2);
    gait.chestYaw = degrees(4);
    gait.chestRoll = degrees(3);
    gait.headPitch = degrees(20);
    gait.arm = {degrees(10), degrees(9), 0.05};
    gait.armOut = degrees(7);
    gait.armTurn = degrees(26);
    gait.elbow = {degrees(20), degrees(6), 0.08};
    return gait;
}

Gait wearyJog() {
    Gait gait = jogGait();
    gait.footOut = 0.055;
    gait.toeOut = degrees(10);
    gait.sway = 0.02;
    gait.pelvisPitch = degrees(9);
    gait.lean = degrees(17);
    gait.nod = degrees(3);
    gait.chestYaw = degrees(8);
    gait.chestRoll = degrees(4);
    gait.headPitch = degrees(14);
    gait.arm = {degrees(4), degrees(16), 0.04};
    gait.armOut = degrees(12);
    gait.elbow = {degrees(68), degrees(10), 0.1};
    return gait;
}

void addSet(std::vector<Clip>& clips, MotionSet set, const Gait& walk, const Gait& jog) {
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
    addSet(clips, MotionSet::March, marchingWalk(), marchingJog());
    addSet(clips, MotionSet::Weary, wearyWalk(), wearyJog());
}

}  // namespace muster::generator
