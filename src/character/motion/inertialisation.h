// Switching between motions without a jump: the difference at the switch dies away (inertialisation).
#pragma once

#include <array>

#include "muster/clip.h"

namespace muster {

/// What is left of the differences between what was shown and what is played.
class Inertialisation {
public:
    /// Nothing is left.
    void clear() { active_ = false; }
    /// True while something is left.
    bool active() const { return active_; }
    /// From now on the poses played are such that `played` follows `playedBefore` by `dt` [s]; shown were
    /// `before` and `shown`, equally far apart, the latter one step ago.
    void begin(const BodyPose& before, const BodyPose& shown, const BodyPose& playedBefore,
               const BodyPose& played, float dt);
    /// Goes on by a step of `dt` [s] whose decay is `decay` = exp(-kInertialisationRate dt), and adds what is
    /// left to `pose`.
    void apply(float dt, float decay, BodyPose& pose);

private:
    std::array<Vec3, kJointCount + 1>
        offset_{};  ///< Vector part of a rotation per joint; last, of the hips [m].
    std::array<Vec3, kJointCount + 1> velocity_{};  ///< Of these [1/s, m/s].
    bool active_ = false;
};

/// Rate of a critically damped decay that halves what is left in a tenth of a second or so [1/s].
inline constexpr float kInertialisationRate = 16.0f;

}  // namespace muster
