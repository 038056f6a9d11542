// Inertialisation (Bollo 2016): after a switch of motion the offset from the played to the shown pose decays.
#pragma once

#include <array>

#include "muster/clip.h"

namespace muster {

/// The decaying offset between the shown pose and the played pose.
class Inertialisation {
public:
    /// Drops the offset.
    void clear() { active_ = false; }
    /// True while the offset has not decayed.
    bool active() const { return active_; }
    /// Starts the blend to a new motion. The new motion plays `playedBefore` and, `dt` [s] later, `played`.
    /// The poses shown last were `before` and, `dt` later, `shown`, one step ago.
    void begin(const BodyPose& before, const BodyPose& shown, const BodyPose& playedBefore,
               const BodyPose& played, float dt);
    /// Advances the decay by `dt` [s], where `decay` = exp(-kInertialisationRate dt), and adds the offset to
    /// `pose`.
    void apply(float dt, float decay, BodyPose& pose);

private:
    /// Vector part of the rotation of each joint; the last entry is the hips' offset [m].
    std::array<Vec3, kJointCount + 1> offset_{};
    std::array<Vec3, kJointCount + 1> velocity_{};  ///< Velocity of the offset [1/s, m/s].
    bool active_ = false;
};

/// Rate of the critically damped decay, which halves an offset in about 0.1 s [1/s].
inline constexpr float kInertialisationRate = 16.0f;

}  // namespace muster
