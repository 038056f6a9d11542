#include "people/generator/figure.h"

#include <algorithm>

#include "base/maths.h"

namespace muster::generator {
namespace {

constexpr std::size_t at(JointRole role, std::size_t side, JointRole right) {
    return side == 0 ? index(role) : index(right);
}

Vec3 mirrored(Vec3 p) {
    return {p.x, -p.y, p.z};
}
Quat mirrored(Quat q) {
    return {-q.x, q.y, -q.z, q.w};
}
/// Mirrors a right limb to the left side or back, because all limbs are computed as left ones.
template <class T>
T sided(std::size_t side, T value) {
    return side == 0 ? value : mirrored(value);
}

/// The rotation that maps the coordinate axes to these three orthonormal vectors.
Quat fromAxes(Vec3 x, Vec3 y, Vec3 z) {
    const float trace = x.x + y.y + z.z;
    if (trace > 0.0f) return normalized(Quat{y.z - z.y, z.x - x.z, x.y - y.x, 1.0f + trace});
    if (x.x > y.y && x.x > z.z)
        return normalized(Quat{1.0f + x.x - y.y - z.z, x.y + y.x, x.z + z.x, y.z - z.y});
    if (y.y > z.z) return normalized(Quat{x.y + y.x, 1.0f - x.x + y.y - z.z, y.z + z.y, z.x - x.z});
    return normalized(Quat{x.z + z.x, y.z + z.y, 1.0f - x.x - y.y + z.z, x.y - y.x});
}

/// Directions of two bones that reach a target, with their middle joint towards a pole.
struct TwoBones {
    Vec3 first;   ///< Direction of the first bone.
    Vec3 second;  ///< Direction of the second bone.
    Vec3 bend;    ///< Normal of the bones' plane; `first` rotates to `second` about it.
};

TwoBones solve(Vec3 origin, Vec3 target, float l1, float l2, Vec3 pole) {
    const Vec3 toTarget = target - origin;
    const float d = std::clamp(length(toTarget), std::fabs(l1 - l2) + 1e-3f, (l1 + l2) * 0.9999f);
    const Vec3 u = normalized(toTarget, {0.0f, 0.0f, -1.0f});
    const Vec3 n = normalized(pole - dot(pole, u) * u, {0.0f, 1.0f, 0.0f});
    const float c = (l1 * l1 + d * d - l2 * l2) / (2.0f * l1 * d),
                s = std::sqrt(std::max(0.0f, 1.0f - c * c));
    const Vec3 first = c * u + s * n;
    return {first, normalized(d * u - l1 * first), cross(u, -n)};
}

struct Frames {
    std::array<Quat, kJointCount> rotation;  // Rotations in the travelling frame.
    std::array<Vec3, kJointCount> position;

    void put(std::size_t joint, Quat q) {
        const auto& bone = skeleton()[joint];
        rotation[joint] = q;
        const auto parent = static_cast<std::size_t>(bone.parent);
        position[joint] = position[parent] + rotate(rotation[parent], bone.offset);
    }
};

void putTrunk(const ChannelValues& body, Frames& frames) {
    const Quat pelvis = turned(body[Channel::PelvisPitch], body[Channel::PelvisRoll],
                               body[Channel::PelvisYaw]);
    const Quat chest = turned(body[Channel::ChestPitch], body[Channel::ChestRoll], body[Channel::ChestYaw]);
    const Quat head = turned(body[Channel::HeadPitch], body[Channel::HeadRoll], body[Channel::HeadYaw]);
    frames.rotation[0] = pelvis;
    frames.position[0] = {static_cast<float>(body[Channel::HipsX]), static_cast<float>(body[Channel::HipsY]),
                          static_cast<float>(body[Channel::HipsZ])};
    frames.put(index(JointRole::Spine), nlerp(pelvis, chest, 0.5f));
    frames.put(index(JointRole::Chest), chest);
    frames.put(index(JointRole::Neck), nlerp(chest, head, 0.5f));
    frames.put(index(JointRole::Head), head);
}

void putLeg(const Leg& leg, std::size_t side, Frames& frames) {
    using enum JointRole;
    const std::size_t upper = at(LeftUpLeg, side, RightUpLeg);
    frames.put(upper, {});
    const TwoBones bones = solve(frames.position[upper], leg.ankle, 0.42f, 0.41f, leg.knee);
    const auto hinge = [&](Vec3 bone) { return fromAxes(cross(bones.bend, -bone), bones.bend, -bone); };
    frames.rotation[upper] = hinge(bones.first);
    frames.put(at(LeftLeg, side, RightLeg), hinge(bones.second));
    frames.put(at(LeftFoot, side, RightFoot), leg.foot);
    frames.put(at(LeftToeBase, side, RightToeBase), leg.foot * axisAngle({0.0f, 1.0f, 0.0f}, leg.toe));
}

/// Rotation of the left upper arm relative to the chest.
Quat armTurn(const ChannelValues& body, std::size_t side) {
    return turned(-body.arm(side, Channel::LeftArmForward), 0.0, 0.0) *
           turned(0.0, body.arm(side, Channel::LeftArmOut), 0.0) * turned(0.0, -0.5 * kPi, -0.0) *
           axisAngle({0.0f, 1.0f, 0.0f}, body.arm(side, Channel::LeftArmTurn));
}

/// Angle by which the collar bone lifts with the arm [rad].
double collarLift(Vec3 arm) {
    const double raised = arcTangent2(
        std::sqrt(static_cast<double>(arm.x) * arm.x + static_cast<double>(arm.y) * arm.y), -arm.z);
    return std::clamp(0.35 * (raised - 1.4), 0.0, 0.45);
}

/// Distributes the hand's twist about the forearm over forearm and hand. The share falls with the part of the
/// rotation that is not twist.
void shareTwist(Quat& fore, Quat hand) {
    const Quat local = conjugate(fore) * hand;
    const float about = local.y * local.y + local.w * local.w;
    fore = fore * nlerp({}, normalized(Quat{0.0f, local.y, 0.0f, local.w}), 0.5f * about);
}

/// The three local rotations of a left arm; the first is relative to the chest.
struct ArmTurns {
    Quat upper, fore, hand;
};

/// The arm given by the body's channels.
ArmTurns freeArm(const ChannelValues& body, std::size_t side) {
    return {armTurn(body, side), turned(0.0, 0.0, -body.arm(side, Channel::LeftElbow)),
            turned(0.0, -body.arm(side, Channel::LeftWrist), 0.0)};
}

/// The arm whose wrist is at the target of `reach`, in the frame of a left arm; `shoulder` is the position of
/// the upper arm's joint.
ArmTurns reachingArm(const Reach& reach, std::size_t side, Quat chest, Vec3 shoulder) {
    const TwoBones bones = solve(shoulder, sided(side, reach.wrist), 0.28f, 0.25f,
                                 normalized(sided(side, reach.elbow)));
    const auto hinge = [&](Vec3 bone) { return fromAxes(cross(bone, -bones.bend), bone, -bones.bend); };
    const Quat upper = hinge(bones.first);
    Quat fore = hinge(bones.second);
    const Quat palm = nlerp(sided(side, reach.hand), fore, static_cast<float>(reach.follow));
    shareTwist(fore, palm);
    return {conjugate(chest) * upper, conjugate(upper) * fore, conjugate(fore) * palm};
}

/// Computes the arm as a left one; the chest and the results are mirrored for the right arm.
void putArm(const ChannelValues& body, const Reach& reach, std::size_t side, Frames& frames) {
    using enum JointRole;
    const std::size_t collar = at(LeftShoulder, side, RightShoulder), upper = at(LeftArm, side, RightArm);
    const std::size_t fore = at(LeftForeArm, side, RightForeArm), hand = at(LeftHand, side, RightHand);
    const Quat chest = sided(side, frames.rotation[index(Chest)]);
    const auto put = [&](std::size_t joint, Quat q) { frames.put(joint, sided(side, q)); };
    const auto shoulder = [&] { return sided(side, frames.position[upper]); };
    const auto share = static_cast<float>(reach.weight);
    ArmTurns arm = freeArm(body, side);
    put(collar, chest);
    put(upper, chest);
    Vec3 direction = rotate(arm.upper, {0.0f, 1.0f, 0.0f});
    if (share > 0.0f) {
        const Vec3 aim = normalized(rotate(conjugate(chest), sided(side, reach.wrist) - shoulder()),
                                    direction);
        direction = normalized(lerp(direction, aim, share), aim);
    }
    put(collar, chest * turned(0.0, collarLift(direction), 0.0));
    put(upper, chest);
    if (share > 0.0f) {
        const ArmTurns reached = reachingArm(reach, side, chest, shoulder());
        arm = {nlerp(arm.upper, reached.upper, share), nlerp(arm.fore, reached.fore, share),
               nlerp(arm.hand, reached.hand, share)};
    }
    put(upper, chest * arm.upper);
    put(fore, chest * arm.upper * arm.fore);
    put(hand, chest * arm.upper * arm.fore * arm.hand);
}

}  // namespace

Quat turned(double pitch, double roll, double yaw) {
    return yawTurn(yaw) * axisAngle({1.0f, 0.0f, 0.0f}, roll) * axisAngle({0.0f, 1.0f, 0.0f}, pitch);
}

Quat flatHand(std::size_t side, double yaw, double tilt) {
    // In the rest pose the fingers point to +y at the left hand and to -y at the right.
    const double quarter = side == 0 ? 0.5 * kPi : -0.5 * kPi;
    return yawTurn(yaw) * axisAngle({0.0f, 1.0f, 0.0f}, -tilt) * yawTurn(-quarter);
}

Figure blend(const Figure& a, const Figure& b, double t) {
    const auto share = static_cast<float>(t);
    Figure out;
    out.body = blend(a.body, b.body, t);
    for (std::size_t side = 0; side < 2; ++side) {
        const Leg &la = a.legs[side], &lb = b.legs[side];
        out.legs[side] = {lerp(la.ankle, lb.ankle, share), nlerp(la.foot, lb.foot, share),
                          la.toe + (lb.toe - la.toe) * t, normalized(lerp(la.knee, lb.knee, share), lb.knee)};
        const Reach &ra = a.reach[side], &rb = b.reach[side];
        const double sum = ra.weight * (1.0 - t) + rb.weight * t;
        // If only one of the two has a weight, its target is used unchanged.
        const float mix = sum > 0.0 ? static_cast<float>(rb.weight * t / sum) : share;
        out.reach[side] = {sum, lerp(ra.wrist, rb.wrist, mix), nlerp(ra.hand, rb.hand, mix),
                           lerp(ra.elbow, rb.elbow, mix), ra.follow + (rb.follow - ra.follow) * mix};
    }
    return out;
}

Vec3 hipJoint(const ChannelValues& body, std::size_t side) {
    const Quat pelvis = turned(body[Channel::PelvisPitch], body[Channel::PelvisRoll],
                               body[Channel::PelvisYaw]);
    const Vec3 hips{static_cast<float>(body[Channel::HipsX]), static_cast<float>(body[Channel::HipsY]),
                    static_cast<float>(body[Channel::HipsZ])};
    return hips + rotate(pelvis, skeleton()[at(JointRole::LeftUpLeg, side, JointRole::RightUpLeg)].offset);
}

BodyPose poseOf(const Figure& figure) {
    Frames frames;
    putTrunk(figure.body, frames);
    for (std::size_t side = 0; side < 2; ++side) {
        putLeg(figure.legs[side], side, frames);
        putArm(figure.body, figure.reach[side], side, frames);
    }
    BodyPose pose;
    pose.hips = frames.position[0];
    pose.rotation[0] = frames.rotation[0];
    for (std::size_t j = 1; j < kJointCount; ++j) {
        const auto parent = static_cast<std::size_t>(skeleton()[j].parent);
        pose.rotation[j] = normalized(conjugate(frames.rotation[parent]) * frames.rotation[j]);
    }
    return pose;
}

}  // namespace muster::generator
