#include "people/motion/body_overlap.h"

#include <algorithm>

namespace muster {
namespace {

// Sizes of a person 1.75 m tall, as the bodies are sculpted (people/bodies/shape.cpp).
constexpr float kTorsoRadius = 0.12f;   // Half the depth of the torso [m].
constexpr float kTorsoAside = 0.05f;    // Distance from the axis of the torso to those of its halves [m].
constexpr float kShoulderRise = 0.14f;  // Height of the axis's upper end above the joint of the chest [m].
constexpr float kHeadRadius = 0.10f;    // Radius of the sphere that stands for the head [m].
constexpr float kHeadMiddle = 0.10f;    // Height of the middle of the head above its joint [m].
constexpr double kComparedReach = 2.0;  // Distance beyond which two bodies are not compared [m].

double clamp01(double v) {
    return std::clamp(v, 0.0, 1.0);
}

double dot3(Vec3 a, Vec3 b) {
    return static_cast<double>(a.x) * b.x + static_cast<double>(a.y) * b.y + static_cast<double>(a.z) * b.z;
}

// Least distance of two segments (Ericson 2005, section 5.1.9).
double segmentDistance(const std::array<Vec3, 2>& p, const std::array<Vec3, 2>& q) {
    const Vec3 d1 = p[1] - p[0], d2 = q[1] - q[0], r = p[0] - q[0];
    const double a = dot3(d1, d1), e = dot3(d2, d2), f = dot3(d2, r);
    constexpr double kPoint = 1e-12;
    double s = 0.0, t = 0.0;
    if (a > kPoint && e > kPoint) {
        const double c = dot3(d1, r), b = dot3(d1, d2), denominator = a * e - b * b;
        s = denominator > kPoint ? clamp01((b * f - c * e) / denominator) : 0.0;
        t = (b * s + f) / e;
        if (t < 0.0 || t > 1.0) {
            t = clamp01(t);
            s = clamp01((b * t - c) / a);
        }
    } else if (e > kPoint) {
        t = clamp01(f / e);
    } else if (a > kPoint) {
        s = clamp01(-dot3(d1, r) / a);
    }
    const Vec3 apart = r + d1 * static_cast<float>(s) - d2 * static_cast<float>(t);
    return static_cast<double>(length(apart));
}

}  // namespace

SolidBody solidBody(const JointTransforms& joints, float size) {
    const Transform& hips = joints[index(JointRole::Hips)];
    const Transform& chest = joints[index(JointRole::Chest)];
    const Transform& head = joints[index(JointRole::Head)];
    const auto at = [size](const Transform& joint, Vec3 p) {
        return joint.translation + rotate(joint.rotation, p) * size;
    };
    SolidBody body;
    body.left = {at(hips, {0.0f, kTorsoAside, 0.0f}), at(chest, {0.0f, kTorsoAside, kShoulderRise})};
    body.right = {at(hips, {0.0f, -kTorsoAside, 0.0f}), at(chest, {0.0f, -kTorsoAside, kShoulderRise})};
    body.head = at(head, {0.0f, 0.0f, kHeadMiddle});
    body.size = size;
    return body;
}

double overlapOf(const SolidBody& a, const SolidBody& b) {
    const double torsoA = static_cast<double>(kTorsoRadius * a.size);
    const double torsoB = static_cast<double>(kTorsoRadius * b.size);
    const double headA = static_cast<double>(kHeadRadius * a.size);
    const double headB = static_cast<double>(kHeadRadius * b.size);
    const std::array<Vec3, 2> pointA{a.head, a.head}, pointB{b.head, b.head};
    double deepest = headA + headB - segmentDistance(pointA, pointB);
    for (const auto* half : {&a.left, &a.right})
        deepest = std::max(deepest, torsoA + headB - segmentDistance(*half, pointB));
    for (const auto* other : {&b.left, &b.right})
        deepest = std::max(deepest, torsoB + headA - segmentDistance(*other, pointA));
    for (const auto* half : {&a.left, &a.right})
        for (const auto* other : {&b.left, &b.right})
            deepest = std::max(deepest, torsoA + torsoB - segmentDistance(*half, *other));
    return deepest;
}

MotionOverlap& BodyOverlapReport::of(const std::string& motion) {
    const auto at = std::lower_bound(
        motions_.begin(), motions_.end(), motion,
        [](const MotionOverlap& entry, const std::string& name) { return entry.motion < name; });
    if (at != motions_.end() && at->motion == motion) return *at;
    MotionOverlap entry;
    entry.motion = motion;
    return *motions_.insert(at, std::move(entry));
}

void BodyOverlapReport::observePair(const World& world, const CrowdMotion& motion, std::size_t a,
                                    std::size_t b) {
    const double overlap = overlapOf(bodies_[a], bodies_[b]);
    for (int round = 0; round < 2; ++round, std::swap(a, b)) {
        const auto& clips = motion.library().clips;
        const std::string& own = clips[motion.states()[motion.near()[a]].clip].motion;
        MotionOverlap& entry = of(own);
        ++entry.pairSteps;
        entry.deepSteps += overlap > kDeepOverlap ? 1 : 0;
        if (overlap <= entry.deepest) continue;
        entry.deepest = overlap;
        entry.first = motion.nearId(a);
        entry.second = motion.nearId(b);
        entry.otherMotion = clips[motion.states()[motion.near()[b]].clip].motion;
        entry.time = world.time();
    }
}

void BodyOverlapReport::observe(const World& world, const CrowdMotion& motion) {
    const std::size_t count = motion.library().clips.empty() ? 0 : motion.near().size();
    bodies_.resize(count);
    placed_.clear();
    JointTransforms joints;
    for (std::size_t k = 0; k < count; ++k) {
        const MotionState& state = motion.states()[motion.near()[k]];
        worldJoints(state, motion.pose(k), joints);
        bodies_[k] = solidBody(joints, state.size);
        placed_.push_back({state.position.x, k});
    }
    std::sort(placed_.begin(), placed_.end(),
              [](const Placed& a, const Placed& b) { return a.x != b.x ? a.x < b.x : a.near < b.near; });
    for (std::size_t i = 0; i < count; ++i) {
        const Vec2 from = motion.states()[motion.near()[placed_[i].near]].position;
        for (std::size_t j = i + 1; j < count && placed_[j].x - placed_[i].x < kComparedReach; ++j) {
            const Vec2 to = motion.states()[motion.near()[placed_[j].near]].position;
            if (distance(from, to) < kComparedReach)
                observePair(world, motion, placed_[i].near, placed_[j].near);
        }
    }
}

double BodyOverlapReport::deepest() const {
    double most = 0.0;
    for (const MotionOverlap& entry : motions_) most = std::max(most, entry.deepest);
    return most;
}

}  // namespace muster
