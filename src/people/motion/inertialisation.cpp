#include "people/motion/inertialisation.h"

#include <algorithm>

namespace muster {
namespace {

constexpr float kLeastOffset = 2.0e-4f;  // Offset below which the blend ends.
constexpr float kMostVelocity = 5.0f;    // Limit of the offset's velocity, against outliers [1/s].

// Vector part of the rotation from `a` to `b`: b = r * a.
Vec3 difference(Quat b, Quat a) {
    const Quat r = b * conjugate(a);
    return r.w < 0.0f ? Vec3{-r.x, -r.y, -r.z} : Vec3{r.x, r.y, r.z};
}

Vec3 limited(Vec3 v, float most) {
    const float l2 = lengthSquared(v);
    return l2 > most * most ? v * (most / std::sqrt(l2)) : v;
}

}  // namespace

void Inertialisation::begin(const BodyPose& before, const BodyPose& shown, const BodyPose& playedBefore,
                            const BodyPose& played, float dt) {
    const float perStep = 1.0f / dt;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Vec3 moved = difference(shown.rotation[j], before.rotation[j]);
        const Vec3 plays = difference(played.rotation[j], playedBefore.rotation[j]);
        offset_[j] = difference(shown.rotation[j], playedBefore.rotation[j]);
        velocity_[j] = limited((moved - plays) * perStep, kMostVelocity);
    }
    offset_[kJointCount] = shown.hips - playedBefore.hips;
    velocity_[kJointCount] = limited((shown.hips - before.hips - played.hips + playedBefore.hips) * perStep,
                                     kMostVelocity);
    active_ = true;
}

void Inertialisation::apply(float dt, float decay, BodyPose& pose) {
    if (!active_) return;
    float most = 0.0f;
    for (std::size_t j = 0; j <= kJointCount; ++j) {
        const Vec3 pull = velocity_[j] + offset_[j] * kInertialisationRate;
        offset_[j] = (offset_[j] + pull * dt) * decay;
        velocity_[j] = (velocity_[j] - pull * (kInertialisationRate * dt)) * decay;
        most = std::max(most, lengthSquared(offset_[j]) + 0.01f * lengthSquared(velocity_[j]));
    }
    active_ = most > kLeastOffset * kLeastOffset;
    for (std::size_t j = 0; j < kJointCount; ++j) {
        const Vec3 v = offset_[j];
        const float l2 = std::min(0.99f, lengthSquared(v));
        pose.rotation[j] = normalized(Quat{v.x, v.y, v.z, std::sqrt(1.0f - l2)} * pose.rotation[j]);
    }
    pose.hips += offset_[kJointCount];
}

}  // namespace muster
