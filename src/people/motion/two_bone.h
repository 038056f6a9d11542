// Two-bone inverse kinematics for legs and arms.
#pragma once

#include "muster/quat.h"

namespace muster {

/// The present joint positions of a limb of two bones, all in one frame.
struct TwoBones {
    Vec3 root;           ///< Hip or shoulder [m].
    Vec3 middle;         ///< Knee or elbow [m].
    Vec3 end;            ///< Ankle or wrist [m].
    float upper = 0.0f;  ///< Length of the bone from root to middle [m] > 0.
    float lower = 0.0f;  ///< Length of the bone from middle to end [m] > 0.
};

/// Rotations that move the end of the limb to the target.
struct TwoBoneRotation {
    Quat upper;  ///< Rotation multiplied to the left of the upper bone's rotation.
    Quat lower;  ///< Rotation multiplied to the left of the lower bone's rotation.
    Vec3 end;    ///< Position of the end: the target or the nearest reachable point [m].
};

/// Share of a limb's full length beyond which it straightens more slowly, so that the knee does not snap.
inline constexpr float kSoftReach = 0.99f;

/// The distance to which a limb of full length `reach` stretches for a target at `distance` [m]. It equals
/// `distance` up to kSoftReach of the length, then approaches a limit just below `reach`.
float softReach(float distance, float reach);

/// Solves for both bones. `pole` is the direction of the middle joint; it need not be a unit vector or
/// perpendicular to the limb.
TwoBoneRotation reach(const TwoBones& limb, Vec3 target, Vec3 pole);

/// Cosine of the angle between the bones at the middle joint for a distance [m] from root to end.
float middleCosine(const TwoBones& limb, float distance);

/// The target, moved along its line to the root so that the angle of the middle joint changes by at most
/// `most` [rad], which is below a right angle. `before` is the cosine of the present angle.
Vec3 pacedTarget(const TwoBones& limb, Vec3 target, float before, float most);

}  // namespace muster
