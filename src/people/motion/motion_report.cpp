#include "people/motion/motion_report.h"

#include <algorithm>
#include "people/motion/crowd_view.h"

namespace muster {
namespace {

constexpr float kFloorHeight = 0.02f;  // Height below which a sole is on the floor [m].
constexpr float kSlideSpeed = 0.5f;    // Speed above which a sole on the floor slides [m/s].
constexpr float kAnkleHeight = 0.08f;  // Height of the ankle above the sole [m].

// Points of the sole: heel, ball, tip of the toes.
std::array<Vec3, 3> solePoints(const JointTransforms& joints, std::size_t side, float size) {
    const Transform& foot = joints[index(side == 0 ? JointRole::LeftFoot : JointRole::RightFoot)];
    const Transform& toes = joints[index(side == 0 ? JointRole::LeftToeBase : JointRole::RightToeBase)];
    const auto at = [size](const Transform& joint, Vec3 p) {
        return joint.translation + rotate(joint.rotation, p) * size;
    };
    return {at(foot, {-0.05f, 0.0f, -kAnkleHeight}), at(foot, {0.13f, 0.0f, -kAnkleHeight}),
            at(toes, {0.07f, 0.0f, -0.03f})};
}

float kneeAngle(const BodyPose& pose, std::size_t side) {
    const Quat q = pose.rotation[index(side == 0 ? JointRole::LeftLeg : JointRole::RightLeg)];
    return static_cast<float>(angleBetween({}, q));
}

double quantile(std::vector<float> values, double share) {
    if (values.empty()) return 0.0;
    const auto k = static_cast<std::ptrdiff_t>(share * static_cast<double>(values.size() - 1));
    std::nth_element(values.begin(), values.begin() + k, values.end());
    return static_cast<double>(values[k]);
}

float flatLength(Vec3 v) {
    return std::sqrt(v.x * v.x + v.y * v.y);
}

bool isAction(const Clip& clip) {
    return !clip.cyclic && (clip.motion == "jump" || clip.motion == "climb");
}
bool isLocomotion(const Clip& clip) {
    return clip.motion == "run" || clip.motion == "walk";
}

// Largest depth of a point below the floor [m].
float depth(const JointTransforms& joints, float size) {
    float lowest = 0.0f;
    for (std::size_t side = 0; side < 2; ++side)
        for (const Vec3 p : solePoints(joints, side, size)) lowest = std::min(lowest, p.z);
    for (const JointRole knee : {JointRole::LeftLeg, JointRole::RightLeg})
        lowest = std::min(lowest, joints[index(knee)].translation.z - 0.045f * size);
    for (const JointRole wrist : {JointRole::LeftHand, JointRole::RightHand})
        lowest = std::min(lowest, joints[index(wrist)].translation.z - 0.02f * size);
    return -lowest;
}

}  // namespace

void MotionReport::observe(const World& world, const CrowdMotion& motion) {
    const auto dt = static_cast<float>(world.parameters().stepTime);
    for (const Event& event : world.events()) figures_.singleSteps += event.kind == EventKind::SingleStep;
    now_.clear();
    std::size_t old = 0;
    for (std::size_t k = 0; k < motion.near().size(); ++k) {
        const std::uint32_t id = world.characters().id[motion.near()[k]];
        while (old < seen_.size() && seen_[old].id < id) ++old;
        Seen& seen = now_.emplace_back();
        if (old < seen_.size() && seen_[old].id == id) seen = seen_[old];
        const Vec2 position = motion.states()[motion.near()[k]].position;
        if (distance(position, seen.position) > kPutElsewhere) seen = {};
        seen.id = id;
        seen.position = position;
        observeBody(motion, k, dt, seen);
    }
    seen_.swap(now_);
}

void MotionReport::observeBody(const CrowdMotion& motion, std::size_t k, float dt, Seen& seen) {
    const MotionState& state = motion.states()[motion.near()[k]];
    const BodyPose& pose = motion.pose(k);
    JointTransforms joints;
    jointTransforms(pose, {}, joints);
    float most = 0.0f;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Vec3 now = joints[j].translation;
        most = std::max(most, length(now - seen.joints[j] * 2.0f + seen.before[j]) / (dt * dt));
        seen.before[j] = seen.joints[j];
        seen.joints[j] = now;
    }
    if (seen.steps >= 2) accelerations_.push_back(most);
    for (std::size_t side = 0; side < 2; ++side) {
        const float knee = kneeAngle(pose, side);
        if (seen.steps >= 1) knees_.push_back(std::fabs(knee - seen.knees[side]) / dt);
        seen.knees[side] = knee;
    }
    worldJoints(state, pose, joints);
    const Clip& clip = motion.library().clips[state.clip];
    if (clip.motion != "swim") {
        depths_.push_back(depth(joints, state.size));
        observeFeet(joints, motion, k, dt, seen);
    } else {
        seen.locked = {};
    }
    seen.onFloor = clip.motion != "swim";
    observeClip(state, motion.library(), dt, seen);
    ++figures_.bodySteps;
    seen.steps = std::min(2u, seen.steps + 1);
}

void MotionReport::observeFeet(const JointTransforms& joints, const CrowdMotion& motion, std::size_t k,
                               float dt, Seen& seen) {
    const float size = motion.states()[motion.near()[k]].size;
    for (std::size_t side = 0; side < 2; ++side) {
        const auto points = solePoints(joints, side, size);
        const bool locked = motion.locked(k, side == 0 ? Limb::LeftFoot : Limb::RightFoot);
        const auto lowest = static_cast<std::size_t>(
            std::min_element(points.begin(), points.end(), [](Vec3 a, Vec3 b) { return a.z < b.z; }) -
            points.begin());
        const float moved = flatLength(points[lowest] - seen.soles[side][lowest]);
        if (seen.onFloor && points[lowest].z < kFloorHeight && seen.soles[side][lowest].z < kFloorHeight)
            lowSpeeds_.push_back(moved / dt);
        if (seen.onFloor && locked && seen.locked[side]) seen.slide[side] += static_cast<double>(moved);
        if (seen.locked[side] && !locked) slides_.push_back(static_cast<float>(seen.slide[side]));
        if (!locked) seen.slide[side] = 0.0;
        seen.locked[side] = locked;
        seen.soles[side] = points;
    }
}

void MotionReport::observeClip(const MotionState& state, const ClipLibrary& library, float dt, Seen& seen) {
    const Clip& clip = library.clips[state.clip];
    float played = state.time - seen.time;
    if (clip.cyclic && played < -1e-4f) played += static_cast<float>(clip.duration());
    const double rate = static_cast<double>(played / dt);
    const bool same = seen.steps >= 1 && seen.clip == state.clip;
    const bool goesOn = same && rate > -1e-3 && rate < 3.0;
    if (seen.steps >= 1 && !goesOn) ++figures_.switches;
    if (isAction(clip) && (!same || seen.time > state.time + 0.05f)) ++figures_.actions;
    if (goesOn && isLocomotion(clip) && clip.cyclic && clip.speed() > 0.05) {
        figures_.rateLeast = figures_.rateMost == 0.0 ? rate : std::min(figures_.rateLeast, rate);
        figures_.rateMost = std::max(figures_.rateMost, rate);
    }
    seen.clip = state.clip;
    seen.time = state.time;
}

MotionFigures MotionReport::figures() const {
    MotionFigures f = figures_;
    f.contacts = slides_.size();
    f.slideMedian = quantile(slides_, 0.5);
    f.slide95 = quantile(slides_, 0.95);
    f.slideMax = quantile(slides_, 1.0);
    const auto fast = std::count_if(lowSpeeds_.begin(), lowSpeeds_.end(),
                                    [](float v) { return v > kSlideSpeed; });
    if (!lowSpeeds_.empty()) f.lowFast = static_cast<double>(fast) / static_cast<double>(lowSpeeds_.size());
    f.lowSpeed95 = quantile(lowSpeeds_, 0.95);
    f.kneeMax = quantile(knees_, 1.0);
    f.knee999 = quantile(knees_, 0.999);
    f.penetration = quantile(depths_, 1.0);
    f.penetration999 = quantile(depths_, 0.999);
    f.accelerationMax = quantile(accelerations_, 1.0);
    f.acceleration999 = quantile(accelerations_, 0.999);
    return f;
}

}  // namespace muster
