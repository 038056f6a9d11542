#include "people/motion/posed_body.h"

#include <algorithm>

#include "people/motion/limb_lock.h"
#include "people/motion/two_bone.h"

namespace muster {
namespace {

// Share of a leg's length within which locked feet are brought by lowering the hips.
constexpr float kLockedReach = 0.985f;
constexpr float kMostDrop = 0.12f;        // Largest distance by which hips are lowered [m].
constexpr float kStanceTime = 0.1f;       // Smoothing time of the middles of steps [s].
constexpr float kKnee = 0.04f;            // Height of the knee's joint above the floor when kneeling [m].
constexpr float kSole = 0.08f;            // Height of the ankle above the sole [m].
constexpr float kKneePace = 20.0f;        // Largest angular speed of a knee [rad/s].
constexpr float kSoleTolerance = 0.003f;  // Penetration of the sole up to which it is not corrected [m].

std::size_t at(JointRole role) {
    return index(role);
}

/// Joints of one limb, from the trunk outwards.
struct Chain {
    std::size_t upper, lower, end;
};
constexpr std::array<Chain, kLockableLimbCount> kChains{
    {{13, 14, 15}, {17, 18, 19}, {6, 7, 8}, {10, 11, 12}}};
static_assert(index(JointRole::LeftUpLeg) == 13 && index(JointRole::RightUpLeg) == 17 &&
              index(JointRole::LeftArm) == 6 && index(JointRole::RightArm) == 10);

/// Rotations of a limb in the pose, in the body axes.
struct LimbPose {
    Quat parent;  ///< Rotation of the limb's parent joint.
    Quat upper, lower, end;
    TwoBones bones;
};

LimbPose limbPose(const BodyPose& pose, const Transform& parent, const Chain& chain) {
    const auto& joints = skeleton();
    LimbPose limb;
    limb.parent = parent.rotation;
    limb.upper = parent.rotation * pose.rotation[chain.upper];
    limb.lower = limb.upper * pose.rotation[chain.lower];
    limb.end = limb.lower * pose.rotation[chain.end];
    limb.bones.root = parent.apply(joints[chain.upper].offset);
    limb.bones.middle = limb.bones.root + rotate(limb.upper, joints[chain.lower].offset);
    limb.bones.end = limb.bones.middle + rotate(limb.lower, joints[chain.end].offset);
    limb.bones.upper = length(joints[chain.lower].offset);
    limb.bones.lower = length(joints[chain.end].offset);
    return limb;
}

// Rotates the limb's joints so that its end gets the target's position and rotation. Returns the position it
// reaches.
Vec3 bend(const LimbPose& limb, const LimbTarget& target, Vec3 pole, const Chain& chain, BodyPose& pose) {
    const TwoBoneRotation solved = reach(limb.bones, target.position, pole);
    const Quat upper = solved.upper * limb.upper, lower = solved.lower * limb.lower;
    pose.rotation[chain.upper] = normalized(conjugate(limb.parent) * upper);
    pose.rotation[chain.lower] = normalized(conjugate(upper) * lower);
    pose.rotation[chain.end] = normalized(conjugate(lower) * target.rotation);
    return solved.end;
}

// Distance by which the ankle must rise for the sole to be on the floor [m].
float soleDepth(const LimbTarget& target, Quat toes) {
    const auto height = [&](Vec3 p) { return target.position.z + rotate(target.rotation, p).z; };
    const Vec3 toeBase = skeleton()[at(JointRole::LeftToeBase)].offset;
    const Vec3 tip = toeBase + rotate(toes, Vec3{0.07f, 0.0f, -kSole - toeBase.z});
    const float lowest = std::min(
        {height({-0.05f, 0.0f, -kSole}), height({toeBase.x, 0.0f, -kSole}), height(tip)});
    return std::max(0.0f, -lowest - kSoleTolerance);
}

// Depth of the lower knee below the floor [m].
float kneeDepth(const BodyPose& pose) {
    const auto& joints = skeleton();
    float lowest = kKnee;
    for (const std::size_t hip : {at(JointRole::LeftUpLeg), at(JointRole::RightUpLeg)}) {
        const Vec3 knee = rotate(pose.rotation[0],
                                 joints[hip].offset + rotate(pose.rotation[hip], joints[hip + 1].offset));
        lowest = std::min(lowest, pose.hips.z + knee.z);
    }
    return kKnee - lowest;
}

/// Solves one step of one body.
class BodyStep {
public:
    BodyStep(const ClipTable& table, const Mover& mover, float dt, PosedBody& body)
        : table_(table), entry_(table[mover.clip]), mover_(mover), dt_(dt), body_(body), axes_(mover) {}

    void play(float decay) {
        BodyPose& pose = body_.pose;
        const auto time = static_cast<double>(mover_.time);
        entry_.clip->sample(time, pose);
        if (body_.fresh) {
            body_.inertialisation.clear();
            body_.last = pose;
        } else if (mover_.switched) {
            BodyPose playedBefore;
            const double earlier = time - static_cast<double>(mover_.rate * dt_);
            entry_.clip->sample(entry_.cyclic ? earlier : std::max(0.0, earlier), playedBefore);
            body_.inertialisation.begin(body_.before, body_.last, playedBefore, pose, dt_);
        }
        body_.inertialisation.apply(dt_, decay, pose);
        body_.before = body_.fresh ? pose : body_.last;
        body_.last = pose;
        liftOntoObstacle(pose);
    }

    void solveLegs() {
        BodyPose& pose = body_.pose;
        std::array<LimbPose, 2> legs;
        std::array<LimbTarget, 2> targets;
        const Transform hips{pose.rotation[0], pose.hips};
        for (std::size_t side = 0; side < 2; ++side) {
            legs[side] = limbPose(pose, hips, kChains[side]);
            const LimbTarget free{strideTarget(legs[side].bones.end, side), legs[side].end};
            targets[side] = lockLimb(table_, mover_, axes_, side, free, dt_, body_);
            if (entry_.onFloor)
                targets[side].position.z += soleDepth(targets[side], pose.rotation[kChains[side].end + 1]);
        }
        lowerHips(legs, targets);
        float below = 0.0f;
        for (std::size_t side = 0; side < 2; ++side) {
            LimbPose& leg = legs[side];
            for (Vec3* p : {&leg.bones.root, &leg.bones.middle, &leg.bones.end}) p->z -= body_.drop;
            below = std::max(below, targets[side].position.z - stretch(leg, side, targets[side], pose).z);
        }
        pose.hips.z -= body_.drop;
        if (entry_.onFloor) pose.hips.z += std::max(0.0f, below - kSoleTolerance);
        if (entry_.onFloor && entry_.handsTouch) pose.hips.z += kneeDepth(pose);
    }

    void solveArms() {
        bool any = entry_.handsTouch;
        for (std::size_t limb = 2; limb < kLockableLimbCount; ++limb)
            any = any || body_.limbs[limb].locked || body_.limbs[limb].fade > 0.0f;
        if (!any) return;
        BodyPose& pose = body_.pose;
        const auto& joints = skeleton();
        Transform chest{pose.rotation[0], pose.hips};
        for (const JointRole role : {JointRole::Spine, JointRole::Chest})
            chest = chest * Transform{pose.rotation[at(role)], joints[at(role)].offset};
        for (std::size_t limb = 2; limb < kLockableLimbCount; ++limb) {
            const std::size_t shoulder = kChains[limb].upper - 1;
            const Transform bearer = chest * Transform{pose.rotation[shoulder], joints[shoulder].offset};
            const LimbPose arm = limbPose(pose, bearer, kChains[limb]);
            const LimbTarget free{arm.bones.end, arm.end};
            const LimbTarget target = lockLimb(table_, mover_, axes_, limb, free, dt_, body_);
            const Vec3 elbow = arm.bones.middle - 0.5f * (arm.bones.root + arm.bones.end);
            if (!(target.position == free.position)) bend(arm, target, elbow, kChains[limb], pose);
        }
    }

private:
    // Moves the leg towards its target, limited by the largest speed of a knee. Returns the position of the
    // ankle.
    Vec3 stretch(const LimbPose& leg, std::size_t side, LimbTarget target, BodyPose& pose) {
        if (!body_.fresh)
            target.position = pacedTarget(leg.bones, target.position, body_.knees[side], kKneePace * dt_);
        const bool there = lengthSquared(target.position - leg.bones.end) < 1e-10f &&
                           target.rotation == leg.end;
        const Vec3 forward = rotate(leg.upper, {1.0f, 0.0f, 0.0f});
        const Vec3 end = there ? leg.bones.end : bend(leg, target, forward, kChains[side], pose);
        body_.knees[side] = middleCosine(leg.bones, distance(leg.bones.root, end));
        return end;
    }

    // Corrects the height of taller and shorter bodies on an obstacle, which does not scale with them.
    void liftOntoObstacle(BodyPose& pose) const {
        const float height = entry_.clip->obstacle.height;
        if (entry_.use != ClipUse::Action || height < kFixedHeight) return;
        const float up = std::clamp(pose.hips.z - 0.9f, 0.0f, height);
        pose.hips.z += up * (1.0f - mover_.size) / mover_.size;
    }

    // The ankle after scaling the step by the stride and rotating it into the direction of travel.
    Vec3 strideTarget(Vec3 ankle, std::size_t side) {
        Vec3& middle = body_.stance[side];
        middle += (entry_.stance[side] - middle) * (body_.fresh ? 1.0f : std::min(1.0f, dt_ / kStanceTime));
        const Vec3 d = ankle - middle;
        const float x = mover_.strideX, y = mover_.strideY,
                    low = 0.3f + 0.7f * std::min(1.0f, std::sqrt(x * x + y * y));
        return {middle.x + x * d.x - y * d.y, middle.y + y * d.x + x * d.y,
                d.z > 0.0f ? middle.z + d.z * low : ankle.z};
    }

    void lowerHips(const std::array<LimbPose, 2>& legs, const std::array<LimbTarget, 2>& targets) {
        float needed = 0.0f;
        for (std::size_t side = 0; side < 2; ++side) {
            if (!body_.limbs[side].locked) continue;
            const TwoBones& bones = legs[side].bones;
            const Vec3 d = targets[side].position - bones.root;
            const float longest = kLockedReach * (bones.upper + bones.lower);
            const float down = std::sqrt(std::max(0.0f, longest * longest - d.x * d.x - d.y * d.y));
            needed = std::max(needed, -d.z - down);
        }
        needed = std::min(needed, kMostDrop);
        const float time = needed > body_.drop ? 0.02f : 0.12f;
        body_.drop += (needed - body_.drop) * std::min(1.0f, dt_ / time);
    }

    const ClipTable& table_;
    const ClipEntry& entry_;
    const Mover& mover_;
    float dt_;
    PosedBody& body_;
    BodyFrame axes_;
};

}  // namespace

void solveBody(const ClipTable& table, const Mover& mover, float dt, float decay, PosedBody& body) {
    if (body.fresh) {
        body.limbs = {};
        body.drop = body.lookYaw = body.lookPitch = 0.0f;
    }
    BodyStep step(table, mover, dt, body);
    step.play(decay);
    step.solveLegs();
    step.solveArms();
    body.fresh = false;
}

}  // namespace muster
