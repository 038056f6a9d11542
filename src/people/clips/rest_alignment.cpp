#include "people/clips/retarget.h"

#include <cmath>
#include <vector>

#include "base/maths.h"
#include "people/clips/forward.h"

namespace muster {
namespace {

// Cosine of the largest lean of a trunk that counts as physique, about 25 degrees.
constexpr float kBuild = 0.9f;
// Squared cosine of half the largest rotation of the hips that counts as physique.
constexpr float kUntilted = 0.97f;
constexpr float kSteep = 0.5f;  // Cosine of the slope beyond which a foot is not flat in the rest pose.

bool isFoot(JointRole role) {
    return role == JointRole::LeftFoot || role == JointRole::RightFoot || role == JointRole::LeftToeBase ||
           role == JointRole::RightToeBase;
}

bool isTrunk(JointRole role) {
    return index(role) <= index(JointRole::Head) || role == JointRole::LeftShoulder ||
           role == JointRole::RightShoulder;
}

/// The role at the end of a bone of Muster's skeleton; Count for a bone without child. The chest's bone ends
/// at the neck.
JointRole bodyEnd(JointRole role) {
    for (std::size_t child = index(role) + 1; child < kJointCount; ++child)
        if (skeleton()[child].parent == static_cast<std::int32_t>(index(role)))
            return static_cast<JointRole>(child);
    return JointRole::Count;
}

/// Joints of the file in the pose in which skeletons are compared: the rest pose, or a frame if the rest pose
/// is unusable, as in files whose bones all lie along one axis.
class Reference {
public:
    Reference(const BvhMotion& motion, const RoleJoints& roles) : roles_(roles) {
        for (const Vec3 position : restPositions(motion.joints)) joints_.push_back({{}, position});
        rest_ = stands();
        if (!rest_) globalTransforms(motion, mostUpright(motion), joints_);
    }

    bool isRest() const { return rest_; }
    const Transform& joint(std::size_t j) const { return joints_[j]; }
    Vec3 at(JointRole role) const { return joints_[roles_[index(role)]].translation; }

    /// Direction from the hips to the highest joint of the trunk; upwards along the legs without one.
    Vec3 trunk() const {
        for (const JointRole role : {JointRole::Neck, JointRole::Head, JointRole::Chest, JointRole::Spine})
            if (roles_[index(role)] >= 0) return normalized(at(role) - at(JointRole::Hips));
        return legs();
    }
    /// Direction upwards along the thighs.
    Vec3 legs() const {
        return normalized(at(JointRole::Hips) - 0.5f * (at(JointRole::LeftLeg) + at(JointRole::RightLeg)));
    }

private:
    /// True if the legs are straight and point away from the trunk.
    bool stands() const {
        using enum JointRole;
        const auto bone = [this](JointRole a, JointRole b) { return normalized(at(b) - at(a)); };
        return dot(trunk(), legs()) > 0.5f && dot(bone(LeftUpLeg, LeftLeg), bone(LeftLeg, LeftFoot)) > 0.7f &&
               dot(bone(RightUpLeg, RightLeg), bone(RightLeg, RightFoot)) > 0.7f;
    }

    std::size_t mostUpright(const BvhMotion& motion) {
        std::size_t best = 0;
        float most = -1e9f;
        for (std::size_t f = 0; f < motion.frames; ++f) {
            globalTransforms(motion, f, joints_);
            const float upright = trunk().z + legs().z;
            if (upright <= most) continue;
            most = upright;
            best = f;
        }
        return best;
    }

    const RoleJoints& roles_;
    std::vector<Transform> joints_;
    bool rest_ = true;
};

class Aligner {
public:
    Aligner(const BvhMotion& motion, const RoleJoints& roles)
        : motion_(motion), roles_(roles), reference_(motion, roles) {}

    RestAlignment align() {
        RestAlignment turns, world;  // Rotations of Muster's bones: relative to the file's joints, and global
                                     // in the reference pose.
        for (std::size_t r = 0; r < kJointCount; ++r) {
            const std::int32_t parent = skeleton()[r].parent;
            world[r] = parent < 0 ? bodyTurn() : world[parent];
            const Vec3 theirs = theirBone(static_cast<JointRole>(r));
            if (r > 0 && lengthSquared(theirs) > 0.0f)
                world[r] = align(static_cast<JointRole>(r), world[r], theirs);
            if (roles_[r] < 0) continue;
            turns[r] = normalized(conjugate(reference_.joint(static_cast<std::size_t>(roles_[r])).rotation) *
                                  world[r]);
        }
        return turns;
    }

private:
    /// Rotation of the whole body, from its left and up directions.
    Quat bodyTurn() const {
        const Vec3 left = normalized(
            reference_.at(JointRole::LeftUpLeg) - reference_.at(JointRole::RightUpLeg), {0.0f, 1.0f, 0.0f});
        Vec3 up = reference_.isRest() ? reference_.legs() : reference_.trunk();
        up = normalized(up - dot(up, left) * left, {0.0f, 0.0f, 1.0f});
        const Quat first = shortestArc({0.0f, 0.0f, 1.0f}, up);
        const Quat turn = shortestArc(rotate(first, {0.0f, 1.0f, 0.0f}), left) * first;
        return reference_.isRest() && turn.w * turn.w > kUntilted ? Quat{} : turn;
    }

    /// Direction of the file's bone in the reference pose; zero without one.
    Vec3 theirBone(JointRole role) const {
        if (roles_[index(role)] < 0) return {};
        const auto joint = static_cast<std::size_t>(roles_[index(role)]);
        const Transform& here = reference_.joint(joint);
        const JointRole end = bodyEnd(role);
        if (end != JointRole::Count && roles_[index(end)] >= 0)
            return normalized(reference_.at(end) - here.translation);
        for (std::size_t child = joint + 1; child < motion_.joints.size(); ++child) {
            if (motion_.joints[child].parent == static_cast<std::int32_t>(joint) &&
                lengthSquared(motion_.joints[child].offset) > 0.0f)
                return rotate(here.rotation, normalized(motion_.joints[child].offset));
        }
        const auto& ends = motion_.joints[joint].ends;
        return ends.empty() ? Vec3{} : rotate(here.rotation, normalized(ends.front()));
    }

    /// Global rotation of Muster's bone in the reference pose; `base` is the rotation of its parent.
    Quat align(JointRole role, Quat base, Vec3 theirs) const {
        const JointRole end = bodyEnd(role);
        const Joint& bone = skeleton()[index(role)];
        const Vec3 ours = rotate(
            base, normalized(end == JointRole::Count ? bone.tip : skeleton()[index(end)].offset));
        if (isTrunk(role) && dot(ours, theirs) > kBuild) return base;
        if (isFoot(role) && reference_.isRest()) {
            const Vec3 up = rotate(base, {0.0f, 0.0f, 1.0f}), ahead = rotate(base, {1.0f, 0.0f, 0.0f});
            const Vec3 flat = theirs - dot(theirs, up) * up;
            if (length(flat) > kSteep) return shortestArc(ahead, normalized(flat)) * base;
        }
        return shortestArc(ours, theirs) * base;
    }

    const BvhMotion& motion_;
    const RoleJoints& roles_;
    Reference reference_;
};

}  // namespace

RestAlignment restAlignment(const BvhMotion& motion, const RoleJoints& roles) {
    return Aligner(motion, roles).align();
}

float legScale(const BvhMotion& motion, const RoleJoints& roles) {
    const std::vector<Vec3> rest = restPositions(motion.joints);
    const auto at = [&](JointRole role) { return rest[roles[index(role)]]; };
    float theirs = 0.0f, ours = 0.0f;
    using enum JointRole;
    for (const auto& [hip, knee, ankle] :
         {std::array{LeftUpLeg, LeftLeg, LeftFoot}, std::array{RightUpLeg, RightLeg, RightFoot}}) {
        theirs += distance(at(hip), at(knee)) + distance(at(knee), at(ankle));
        ours += length(skeleton()[index(knee)].offset) + length(skeleton()[index(ankle)].offset);
    }
    return theirs > 1e-6f ? ours / theirs : 1.0f;
}

}  // namespace muster
