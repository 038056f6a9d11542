// Simple clips for tests: legs that swing like clockwork, feet flat on the floor.
#pragma once

#include <algorithm>
#include <string>

#include "muster/clip.h"
#include "people/motion/two_bone.h"

namespace muster::testing {

/// How a gait swings.
struct SwingDef {
    std::string name = "walk";
    std::string motion = "run";
    double duration = 1.0;  ///< Of a cycle [s].
    double speed = 1.25;    ///< [m/s]
    double duty = 0.6;      ///< Share of the cycle that a foot touches the floor.
    double lift = 0.1;      ///< Of the swinging foot [m].
    bool cyclic = true;
    int cycles = 1;  ///< Of a clip that ends.
};

/// Where an ankle is at a share of its cycle, in the travelling frame; it touches from 0 to `duty`.
inline Vec3 swingingAnkle(const SwingDef& def, double share, float side) {
    share -= share >= 1.0 ? 1.0 : 0.0;
    const double stance = def.speed * def.duration * def.duty;
    if (share < def.duty || def.speed == 0.0)
        return {static_cast<float>(stance * (0.5 - share / def.duty)) * (def.speed > 0.0 ? 1.0f : 0.0f), side,
                0.08f};
    const double t = (share - def.duty) / (1.0 - def.duty), smooth = t * t * (3.0 - 2.0 * t);
    return {static_cast<float>(stance * (smooth - 0.5)), side,
            static_cast<float>(0.08 + def.lift * 4.0 * t * (1.0 - t))};
}

/// Bends a leg of the pose so that its ankle comes to a place, foot level.
inline void placeAnkle(BodyPose& pose, bool left, Vec3 ankle) {
    const std::size_t hip = index(left ? JointRole::LeftUpLeg : JointRole::RightUpLeg);
    const auto& bones = skeleton();
    TwoBones leg{.root = pose.hips + bones[hip].offset};
    leg.middle = leg.root + bones[hip + 1].offset;
    leg.end = leg.middle + bones[hip + 2].offset;
    leg.upper = length(bones[hip + 1].offset);
    leg.lower = length(bones[hip + 2].offset);
    const TwoBoneRotation turn = reach(leg, ankle, {1.0f, 0.0f, 0.0f});
    pose.rotation[hip] = turn.upper;
    pose.rotation[hip + 1] = normalized(conjugate(turn.upper) * turn.lower);
    pose.rotation[hip + 2] = conjugate(turn.lower);
}

/// A clip of that gait; the left foot touches down first, the right half a cycle later.
inline Clip swingingClip(const SwingDef& def) {
    Clip clip{.name = def.name, .motion = def.motion, .cyclic = def.cyclic};
    const int cycles = def.cyclic ? 1 : def.cycles;
    const auto frames = static_cast<int>(def.duration * cycles * clip.rate + 0.5);
    for (int f = 0; f < frames + (def.cyclic ? 0 : 1); ++f) {
        const double time = f / clip.rate, share = time / def.duration;
        BodyPose pose = restPose();
        pose.hips.z = 0.85f;
        const double left = share - static_cast<int>(share), right = left + (left < 0.5 ? 0.5 : -0.5);
        placeAnkle(pose, true, swingingAnkle(def, left, 0.09f));
        placeAnkle(pose, false, swingingAnkle(def, right, -0.09f));
        clip.poses.push_back(pose);
    }
    for (int f = 0; f <= frames; ++f)
        clip.travel.push_back({static_cast<float>(def.speed * f / clip.rate), 0.0f, 0.0f});
    const double reachAhead = 0.5 * def.speed * def.duration * def.duty;
    for (int half = 0; half < 2 * cycles; ++half) {
        const double begin = 0.5 * half * def.duration,
                     end = begin + (def.speed > 0.0 ? def.duty : 1.0) * def.duration;
        const bool left = half % 2 == 0;
        const Vec3 anchor{static_cast<float>(begin * def.speed + reachAhead), left ? 0.09f : -0.09f, 0.08f};
        clip.contacts.push_back({left ? Limb::LeftFoot : Limb::RightFoot, begin,
                                 def.cyclic ? end : std::min(end, clip.duration()), anchor});
    }
    return clip;
}

/// Ways to stand and go, under branches and over things.
inline ClipLibrary swingingClips() {
    ClipLibrary library;
    const auto add = [&](const SwingDef& def) { library.clips.push_back(swingingClip(def)); };
    add({"idle", "run", 4.0, 0.0, 1.0, 0.0, true, 1});
    add({"walk", "run", 1.0, 1.25, 0.6, 0.1, true, 1});
    add({"jog", "run", 0.75, 1.95, 0.4, 0.15, true, 1});
    add({"run", "run", 0.7, 2.6, 0.3, 0.2, true, 1});
    add({"duck", "duck", 0.8, 1.04, 0.6, 0.1, true, 1});
    add({"duck-enter", "duck", 0.8, 1.04, 0.6, 0.1, false, 1});
    add({"duck-exit", "duck", 0.8, 1.04, 0.6, 0.1, false, 1});
    add({"jump", "jump", 0.5, 2.08, 0.4, 0.2, false, 2});
    add({"jump-over", "jump", 0.5, 2.08, 0.4, 0.2, false, 2});
    add({"climb", "climb", 1.5, 0.39, 0.7, 0.2, false, 2});
    return library;
}

}  // namespace muster::testing
