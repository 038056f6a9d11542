#include "people/clips/retarget.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "base/maths.h"
#include "people/clips/forward.h"
#include "people/clips/hips_path.h"

namespace muster {
namespace {

constexpr double kSmoothing = 0.5;    // Smoothing window of the travel of clips that do not repeat [s].
constexpr double kFloorShare = 0.05;  // Share of frames that may be below the floor, as noise.

/// Hips and rotations of all frames in the ground frame.
struct Track {
    std::vector<HipsAt> hips;
    std::vector<Transform> root;  ///< Scaled position [m] and rotation of the hips.
    std::vector<BodyPose> poses;  ///< Rotations of all joints but the hips.
};

/// Computes global rotations of Muster's joints from those of the file's joints.
class RoleRotations {
public:
    RoleRotations(const BvhMotion& motion, const RoleJoints& roles)
        : roles_(roles), turns_(restAlignment(motion, roles)) {}

    const std::array<Quat, kJointCount>& of(const std::vector<Transform>& joints) {
        for (std::size_t r = 0; r < kJointCount; ++r) {
            const std::int32_t parent = skeleton()[r].parent;
            if (roles_[r] >= 0)
                world_[r] = normalized(joints[roles_[r]].rotation * turns_[r]);
            else if (parent >= 0)
                world_[r] = world_[parent];
        }
        // A missing joint gets half the rotation between its neighbours.
        halve(JointRole::Hips, JointRole::Spine, JointRole::Chest);
        halve(JointRole::Chest, JointRole::Neck, JointRole::Head);
        return world_;
    }

private:
    void halve(JointRole below, JointRole joint, JointRole above) {
        if (roles_[index(joint)] < 0 && roles_[index(above)] >= 0)
            world_[index(joint)] = nlerp(world_[index(below)], world_[index(above)], 0.5f);
    }

    const RoleJoints& roles_;
    RestAlignment turns_;
    std::array<Quat, kJointCount> world_{};
};

Track trackOf(const BvhMotion& motion, const RoleJoints& roles) {
    Track track;
    RoleRotations rotations(motion, roles);
    const float scale = legScale(motion, roles);
    std::vector<Transform> joints;
    for (std::size_t f = 0; f < motion.frames; ++f) {
        globalTransforms(motion, f, joints);
        const auto& world = rotations.of(joints);
        const Vec3 hips = joints[roles[0]].translation * scale;
        track.root.push_back({world[0], hips});
        track.hips.push_back({hips.x, hips.y, facingOf(world[0])});
        BodyPose& pose = track.poses.emplace_back();
        for (std::size_t r = 1; r < kJointCount; ++r)
            pose.rotation[r] = normalized(conjugate(world[skeleton()[r].parent]) * world[r]);
    }
    unwrap(track.hips);
    return track;
}

/// Expresses the poses in the travelling frame.
void toTravellingFrame(const Track& track, const std::vector<Travel>& travel, std::vector<BodyPose>& poses) {
    poses = track.poses;
    for (std::size_t f = 0; f < poses.size(); ++f) {
        const Quat back = yawTurn(-static_cast<double>(travel[f].yaw));
        poses[f].rotation[0] = normalized(back * track.root[f].rotation);
        poses[f].hips = rotate(back, track.root[f].translation - Vec3{travel[f].x, travel[f].y, 0.0f});
    }
}

/// Height of the lowest point that may touch the ground, measured at the sole or skin [m].
float lowestPoint(const BodyPose& pose) {
    using enum JointRole;
    static constexpr std::pair<JointRole, float> kPoints[] = {
        {LeftFoot, 0.08f},    {RightFoot, 0.08f},    {LeftToeBase, 0.03f}, {RightToeBase, 0.03f},
        {LeftLeg, 0.06f},     {RightLeg, 0.06f},     {LeftHand, 0.03f},    {RightHand, 0.03f},
        {LeftForeArm, 0.04f}, {RightForeArm, 0.04f}, {Hips, 0.12f},        {Chest, 0.12f}};
    JointTransforms joints;
    jointTransforms(pose, {}, joints);
    float lowest = 1e9f;
    for (const auto& [role, skin] : kPoints)
        lowest = std::min(lowest, joints[index(role)].translation.z - skin);
    return lowest;
}

/// Shifts the whole motion vertically so that its contacts are at height 0.
void settle(std::vector<BodyPose>& poses) {
    std::vector<float> lowest;
    for (const BodyPose& pose : poses) lowest.push_back(lowestPoint(pose));
    const auto at = lowest.begin() +
                    static_cast<std::ptrdiff_t>(kFloorShare * static_cast<double>(lowest.size()));
    std::nth_element(lowest.begin(), at, lowest.end());
    const float floor = *at;
    for (BodyPose& pose : poses) pose.hips.z -= floor;
}

/// Drops the last pose, which repeats the first, and distributes their difference over the cycle.
void closeCycle(std::vector<BodyPose>& poses) {
    const BodyPose first = poses.front(), last = poses.back();
    poses.pop_back();
    for (std::size_t f = 0; f < poses.size(); ++f) {
        const float share = static_cast<float>(f) / static_cast<float>(poses.size());
        poses[f].hips += (first.hips - last.hips) * share;
        for (std::size_t r = 0; r < kJointCount; ++r) {
            const Quat off = conjugate(last.rotation[r]) * first.rotation[r];
            poses[f].rotation[r] = normalized(poses[f].rotation[r] * nlerp({}, off, share));
        }
    }
}

/// Reads a file that bvhText wrote, which needs no retargeting.
void takeOwn(const BvhMotion& motion, Clip& clip) {
    for (std::size_t f = 0; f < motion.frames; ++f) {
        const auto values = motion.frame(f);
        const Quat root = values[0].rotation;
        double yaw = 2.0 * arcTangent2(root.z, root.w);
        if (f > 0)
            yaw -= 2.0 * kPi *
                   std::floor((yaw - static_cast<double>(clip.travel.back().yaw)) / (2.0 * kPi) + 0.5);
        clip.travel.push_back({values[0].translation.x, values[0].translation.y, static_cast<float>(yaw)});
        BodyPose& pose = clip.poses.emplace_back();
        pose.hips = values[1].translation;
        for (std::size_t r = 0; r < kJointCount; ++r) pose.rotation[r] = values[r + 1].rotation;
    }
    if (clip.cyclic) clip.poses.pop_back();
}

}  // namespace

bool isOwnSkeleton(const BvhMotion& motion) {
    if (motion.joints.size() != kJointCount + 1 || !motion.joints[0].moves || !motion.joints[1].moves)
        return false;
    for (std::size_t r = 0; r < kJointCount; ++r) {
        const BvhJoint& joint = motion.joints[r + 1];
        const Joint& ours = skeleton()[r];
        if (joint.name != ours.name || joint.parent != ours.parent + 1) return false;
        if (r > 0 && distance(joint.offset, ours.offset) > 1e-4f) return false;
    }
    return true;
}

Result<Clip> retarget(const BvhMotion& motion, const RetargetOptions& options) {
    if (motion.frames < 3)
        return invalidArgument("found " + std::to_string(motion.frames) + " frames, expected at least 3");
    Clip clip;
    clip.name = options.name;
    clip.motion = options.motion;
    clip.rate = motion.rate;
    clip.cyclic = options.cyclic.value_or(isCyclic(motion));
    if (isOwnSkeleton(motion)) {
        takeOwn(motion, clip);
    } else {
        const RoleJoints roles = findRoles(motion.joints);
        if (Status s = hasBody(roles); !s.ok()) return s;
        const Track track = trackOf(motion, roles);
        clip.travel = clip.cyclic ? evenTravel(track.hips)
                                  : smoothTravel(track.hips, motion.rate, kSmoothing);
        toTravellingFrame(track, clip.travel, clip.poses);
        settle(clip.poses);
        if (clip.cyclic) closeCycle(clip.poses);
    }
    fromStart(clip.travel);
    findContacts(clip);
    if (Status s = validate(clip); !s.ok()) return s;
    return clip;
}

}  // namespace muster
