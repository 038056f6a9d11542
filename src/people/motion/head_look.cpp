#include "people/motion/head_look.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/easing.h"

namespace muster {
namespace {

constexpr double kMostYaw = 75.0 / 180.0 * kPi;    // To either side [rad].
constexpr double kMostPitch = 35.0 / 180.0 * kPi;  // Up and down [rad].
constexpr double kEaseTime = 0.18;                 // Smoothing time of turning [s].
constexpr double kFastest = 4.0;                   // Largest speed of turning [rad/s].
constexpr double kLeast = 1e-4;                    // Smaller angles are none [rad].

/// Turning joints from below, and the share of the yaw of each with free arms and without.
struct Share {
    JointRole joint;
    double free, bound;
};
constexpr std::array<Share, 3> kShares{
    {{JointRole::Chest, 0.2, 0.0}, {JointRole::Neck, 0.3, 0.4}, {JointRole::Head, 0.5, 0.6}}};

void ease(double wanted, double dt, float& angle) {
    const double step = (wanted - static_cast<double>(angle)) * std::min(1.0, dt / kEaseTime);
    angle += static_cast<float>(std::clamp(step, -kFastest * dt, kFastest * dt));
}

/// By how much the head is to turn.
struct HeadTurn {
    double yaw = 0.0, pitch = 0.0;
};

HeadTurn wantedTurn(const Mover& mover, const Transform& head, Vec3 target) {
    const Vec2 away = mover.facing.applyInverse(
        Vec2{static_cast<double>(target.x), static_cast<double>(target.y)} - mover.position);
    const auto size = static_cast<double>(mover.size);
    const Vec2 left = away / size -
                      Vec2{static_cast<double>(head.translation.x), static_cast<double>(head.translation.y)};
    const double up = static_cast<double>(target.z) / size - static_cast<double>(head.translation.z);
    const Vec3 face = rotate(head.rotation, {1.0f, 0.0f, 0.0f});
    const double faceYaw = arcTangent2(static_cast<double>(face.y), static_cast<double>(face.x));
    const double flat = std::sqrt(static_cast<double>(face.x * face.x + face.y * face.y));
    const double facePitch = arcTangent2(static_cast<double>(face.z), flat);
    const double yaw = std::clamp(arcTangent2(left.y, left.x), -kMostYaw, kMostYaw);
    const double pitch = std::clamp(arcTangent2(up, length(left)), -kMostPitch, kMostPitch);
    return {wrappedAngle(yaw - faceYaw), pitch - facePitch};
}

}  // namespace

void turnHead(const Mover& mover, const std::optional<Vec3>& target, float dt, bool free, PosedBody& body) {
    const bool still = std::fabs(static_cast<double>(body.lookYaw)) < kLeast &&
                       std::fabs(static_cast<double>(body.lookPitch)) < kLeast;
    if (!target && still) {
        body.lookYaw = body.lookPitch = 0.0f;
        return;
    }
    JointTransforms joints;
    jointTransforms(body.pose, {}, joints);
    const HeadTurn turn = target ? wantedTurn(mover, joints[index(JointRole::Head)], *target) : HeadTurn{};
    ease(turn.yaw, static_cast<double>(dt), body.lookYaw);
    ease(turn.pitch, static_cast<double>(dt), body.lookPitch);
    const auto yaw = static_cast<double>(body.lookYaw), pitch = static_cast<double>(body.lookPitch);
    Quat turned{};  // What joints below have turned.
    const Vec3 face = rotate(joints[index(JointRole::Head)].rotation, {1.0f, 0.0f, 0.0f});
    const double way = arcTangent2(static_cast<double>(face.y), static_cast<double>(face.x)) + yaw;
    const Vec3 across{static_cast<float>(-sine(way)), static_cast<float>(cosine(way)), 0.0f};
    for (const Share& share : kShares) {
        const std::size_t j = index(share.joint);
        const std::size_t parent = static_cast<std::size_t>(skeleton()[j].parent);
        Quat by = yawTurn(yaw * (free ? share.free : share.bound));
        if (share.joint != JointRole::Chest) by = axisAngle(across, -0.5 * pitch) * by;
        const Quat below = turned * joints[parent].rotation;
        const Quat whole = by * turned * joints[j].rotation;
        body.pose.rotation[j] = normalized(conjugate(below) * whole);
        turned = by * turned;
    }
}

}  // namespace muster
