#include "clips/rest_alignment.h"

#include <cmath>
#include <vector>

#include "clips/forward.h"

namespace muster {
namespace {

constexpr float kBuild = 0.9f;  // Cosine of the lean of a trunk that build explains, some 25 degrees.
constexpr float kSteep = 0.5f;  // Cosine of the slope from which a foot is not flat in the rest pose.

bool isFoot(JointRole role) {
    return role == JointRole::LeftFoot || role == JointRole::RightFoot || role == JointRole::LeftToeBase ||
           role == JointRole::RightToeBase;
}

bool isTrunk(JointRole role) {
    return index(role) <= index(JointRole::Head) || role == JointRole::LeftShoulder ||
           role == JointRole::RightShoulder;
}

/// The role that a bone of ours leads to; Count where it ends in a tip. The chest leads to the neck.
JointRole bodyEnd(JointRole role) {
    for (std::size_t child = index(role) + 1; child < kJointCount; ++child)
        if (skeleton()[child].parent == static_cast<std::int32_t>(index(role)))
            return static_cast<JointRole>(child);
    return JointRole::Count;
}

class Aligner {
public:
    Aligner(const BvhMotion& motion, const RoleJoints& roles)
        : motion_(motion), roles_(roles), rest_(restPlaces(motion.joints)) {}

    RestAlignment align() {
        RestAlignment turns;
        const Quat body = bodyTurn();
        for (std::size_t r = 0; r < kJointCount; ++r) {
            const auto role = static_cast<JointRole>(r);
            const std::int32_t parent = skeleton()[r].parent;
            turns[r] = parent < 0 ? body : turns[static_cast<std::size_t>(parent)];
            if (isTrunk(role)) turns[r] = body;
            const Vec3 theirs = theirBone(role);
            if (r == 0 || lengthSquared(theirs) == 0.0f) continue;
            turns[r] = align(role, body, theirs);
        }
        return turns;
    }

private:
    Vec3 at(JointRole role) const { return rest_[static_cast<std::size_t>(roles_[index(role)])]; }

    /// The turn of the whole body: by its left and its up.
    Quat bodyTurn() const {
        const Vec3 left =
            normalized(at(JointRole::LeftUpLeg) - at(JointRole::RightUpLeg), {0.0f, 1.0f, 0.0f});
        Vec3 up = at(JointRole::Hips) - 0.5f * (at(JointRole::LeftLeg) + at(JointRole::RightLeg));
        up = normalized(up - dot(up, left) * left, {0.0f, 0.0f, 1.0f});
        const Quat first = shortestArc({0.0f, 0.0f, 1.0f}, up);
        const Quat turn = shortestArc(rotate(first, {0.0f, 1.0f, 0.0f}), left) * first;
        return turn.w * turn.w > 0.97f ? Quat{} : turn;
    }

    /// Direction of the file's bone in its rest pose; null where it has none.
    Vec3 theirBone(JointRole role) const {
        if (roles_[index(role)] < 0) return {};
        const auto joint = static_cast<std::size_t>(roles_[index(role)]);
        const JointRole end = bodyEnd(role);
        if (end != JointRole::Count && roles_[index(end)] >= 0) return normalized(at(end) - rest_[joint]);
        for (std::size_t child = joint + 1; child < motion_.joints.size(); ++child) {
            if (motion_.joints[child].parent == static_cast<std::int32_t>(joint) &&
                lengthSquared(motion_.joints[child].offset) > 0.0f)
                return normalized(motion_.joints[child].offset);
        }
        return motion_.joints[joint].ends.empty() ? Vec3{} : normalized(motion_.joints[joint].ends.front());
    }

    static Quat align(JointRole role, Quat body, Vec3 theirs) {
        const JointRole end = bodyEnd(role);
        const Joint& bone = skeleton()[index(role)];
        const Vec3 ours =
            rotate(body, normalized(end == JointRole::Count ? bone.tip : skeleton()[index(end)].offset));
        if (isTrunk(role) && dot(ours, theirs) > kBuild) return body;
        if (isFoot(role)) {
            const Vec3 up = rotate(body, {0.0f, 0.0f, 1.0f}), ahead = rotate(body, {1.0f, 0.0f, 0.0f});
            const Vec3 flat = theirs - dot(theirs, up) * up;
            if (length(flat) > kSteep) return shortestArc(ahead, normalized(flat)) * body;
        }
        return shortestArc(ours, theirs) * body;
    }

    const BvhMotion& motion_;
    const RoleJoints& roles_;
    std::vector<Vec3> rest_;
};

}  // namespace

RestAlignment restAlignment(const BvhMotion& motion, const RoleJoints& roles) {
    return Aligner(motion, roles).align();
}

float legScale(const BvhMotion& motion, const RoleJoints& roles) {
    const std::vector<Vec3> rest = restPlaces(motion.joints);
    const auto at = [&](JointRole role) { return rest[static_cast<std::size_t>(roles[index(role)])]; };
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
