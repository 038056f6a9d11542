// Two-bone inverse kinematics for legs and arms.
#pragma once

#include "muster/quat.h"

namespace muster {

/// A limb of two bones as it hangs now, in any one frame.
struct TwoBones {
    Vec3 root;           ///< Hip or shoulder [m].
    Vec3 middle;         ///< Knee or elbow [m].
    Vec3 end;            ///< Ankle or wrist [m].
    float upper = 0.0f;  ///< Length of the bone from root to middle [m] > 0.
    float lower = 0.0f;  ///< Length of the bone from middle to end [m] > 0.
};

/// Rotations that bring the end to the target.
struct TwoBoneRotation {
    Quat upper;  ///< Put before the rotation of the upper bone.
    Quat lower;  ///< Put before the rotation of the lower bone.
    Vec3 end;    ///< Where the end comes to: the target, or as near to it as the limb reaches [m].
};

/// Share of a limb's full length from which on it straightens ever more slowly, so that the knee does not
/// snap.
inline constexpr float kSoftReach = 0.99f;

/// The distance to which a limb of full length `reach` stretches for a target at `distance` [m]: the same up
/// to kSoftReach of it, then ever less, never quite `reach`.
float softReach(float distance, float reach);

/// Solves for both bones; `pole` is where the middle joint points (need be neither of unit length nor at
/// right angles).
TwoBoneRotation reach(const TwoBones& limb, Vec3 target, Vec3 pole);

/// Cosine of the angle between the bones at the middle joint, where root and end are `distance` apart [m].
float middleCosine(const TwoBones& limb, float distance);

/// The target, drawn nearer to the root or away from it so that the middle joint's angle, of which `before`
/// is the cosine, changes by at most `most` [rad], below a right angle.
Vec3 pacedTarget(const TwoBones& limb, Vec3 target, float before, float most);

}  // namespace muster
