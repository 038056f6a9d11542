// Measures of clips, taken from joints alone.
#pragma once

#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <string>

#include "base/maths.h"
#include "muster/own_clips.h"

namespace muster::test {

inline constexpr Vec3 kHeelOfSole{-0.06f, 0.0f, -0.08f};  // From the ankle [m].
inline constexpr Vec3 kToesJoint{0.13f, 0.0f, -0.05f};    // From the ankle [m].
inline constexpr Vec3 kBallOfSole{0.0f, 0.0f, -0.03f};    // From the toes' joint [m].
inline constexpr Vec3 kTipOfSole{0.07f, 0.0f, -0.03f};    // From the toes' joint [m].

inline const Clip& clipNamed(const std::string& name) {
    const Clip* clip = ownClips().find(name);
    REQUIRE_MESSAGE(clip != nullptr, name);
    return *clip;
}

/// Joints at a time on the clip's ground.
inline JointTransforms jointsOnGround(const Clip& clip, double time) {
    BodyPose pose;
    clip.sample(time, pose);
    const Travel at = clip.travelAt(time);
    JointTransforms joints;
    jointTransforms(pose, {yawTurn(at.yaw), {at.x, at.y, 0.0f}}, joints);
    return joints;
}

/// Joints at a frame in the travelling frame; cyclic clips wrap.
inline JointTransforms jointsAt(const Clip& clip, int frame) {
    const int count = static_cast<int>(clip.poses.size());
    JointTransforms joints;
    jointTransforms(clip.poses[((frame % count) + count) % count], {}, joints);
    return joints;
}

inline std::size_t sided(JointRole left, std::size_t side) {
    return index(left) + 4 * side;
}

/// The three points that a sole touches with: heel, ball, tip of the toes.
inline std::array<Vec3, 3> soleOf(const JointTransforms& joints, std::size_t side) {
    const Transform &foot = joints[sided(JointRole::LeftFoot, side)],
                    &toes = joints[sided(JointRole::LeftToeBase, side)];
    return {foot.apply(kHeelOfSole), toes.apply(kBallOfSole), toes.apply(kTipOfSole)};
}

inline double degreesOf(double radians) {
    return radians * 180.0 / kPi;
}

/// Bend of a hinge joint [deg].
inline double bendOf(const BodyPose& pose, JointRole left, std::size_t side) {
    return degreesOf(angleBetween({}, pose.rotation[sided(left, side)]));
}

/// Thigh forward of the vertical [deg].
inline double thighOf(const JointTransforms& joints, std::size_t side) {
    const Vec3 way = joints[sided(JointRole::LeftLeg, side)].translation -
                     joints[sided(JointRole::LeftUpLeg, side)].translation;
    return degreesOf(arcTangent2(way.x, -way.z));
}

/// Least and most of a measure.
struct Range {
    double least = 1e9;
    double most = -1e9;

    void add(double value) {
        least = std::min(least, value);
        most = std::max(most, value);
    }
};

/// A measure of both sides over all poses.
inline Range rangeOver(
    const Clip& clip,
    const std::function<double(const BodyPose&, const JointTransforms&, std::size_t)>& measure) {
    Range range;
    for (const BodyPose& pose : clip.poses) {
        JointTransforms joints;
        jointTransforms(pose, {}, joints);
        for (std::size_t side = 0; side < 2; ++side) range.add(measure(pose, joints, side));
    }
    return range;
}

/// Path length of the touching point over a foot's contact [m]: heel, ball or tip, whichever is lowest at the
/// moment.
inline double slideOf(const Clip& clip, const Contact& contact) {
    const std::size_t side = contact.limb == Limb::LeftFoot ? 0 : 1;
    constexpr double kStep = 1.0 / 240.0;
    double path = 0.0;
    for (double time = contact.begin; time + kStep < contact.end; time += kStep) {
        const auto before = soleOf(jointsOnGround(clip, time), side),
                   after = soleOf(jointsOnGround(clip, time + kStep), side);
        const auto lowest = static_cast<std::size_t>(
            std::min_element(before.begin(), before.end(), [](Vec3 a, Vec3 b) { return a.z < b.z; }) -
            before.begin());
        const Vec3 way = after[lowest] - before[lowest];
        path += std::sqrt(static_cast<double>(way.x) * way.x + static_cast<double>(way.y) * way.y);
    }
    return path;
}

inline bool isFoot(Limb limb) {
    return limb == Limb::LeftFoot || limb == Limb::RightFoot;
}
inline bool onTheWall(const Clip& clip, const Contact& contact) {
    return clip.motion == "climb" && contact.anchor.z > 0.2f;
}

}  // namespace muster::test
