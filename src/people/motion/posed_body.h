// The pose of a whole body: the clip's pose, smoothed at switches, with feet and hands locked at their
// contacts.
#pragma once

#include <array>
#include <cstdint>

#include "people/motion/clip_table.h"
#include "people/motion/inertialisation.h"
#include "people/motion/player.h"

namespace muster {

/// The lock of one foot or hand, in the world.
struct LimbLock {
    bool locked = false;        ///< True while it is locked at its anchor.
    bool stepping = false;      ///< True during a correcting step to its free target.
    Vec2 anchor;                ///< Point to which it is locked [m].
    float anchorHeight = 0.0f;  ///< Height of the anchor [m].
    Rotation axes;              ///< Axes of the frames of its contact.
    Vec2 position;              ///< Position of the joint shown last [m].
    float height = 0.0f;        ///< Height of the joint shown last [m].
    Quat rotation;              ///< Rotation of the joint shown last.
    Vec3 offset;            ///< Offset from the target to the shown joint at the last lock or release [m].
    Quat rotationOffset;    ///< Rotation from the target to the shown joint at the last lock or release.
    float fade = 0.0f;      ///< Remaining share of these offsets, before smoothing, 0 to 1.
    float fadeTime = 0.1f;  ///< Time over which they fade [s].
};

/// State of a body from step to step.
struct PosedBody {
    std::uint32_t id = 0;                            ///< Id of the character.
    bool fresh = true;                               ///< True before its first step.
    BodyPose pose;                                   ///< Pose shown.
    BodyPose last;                                   ///< Smoothed pose one step ago, without limb locks.
    BodyPose before;                                 ///< Smoothed pose two steps ago, without limb locks.
    Inertialisation inertialisation;                 ///< Blends the pose at switches.
    std::array<LimbLock, kLockableLimbCount> limbs;  ///< Locks by index of kLockableLimbs.
    std::array<Vec3, 2> stance;                      ///< Smoothed points about which steps are scaled [m].
    std::array<float, 2> knees{};                    ///< Cosines of the knee angles shown last.
    float drop = 0.0f;       ///< Distance by which hips are lowered to reach locked feet [m].
    float lookYaw = 0.0f;    ///< How far the head is turned to the left to look at something [rad].
    float lookPitch = 0.0f;  ///< How far it is raised [rad].
};

/// Computes `body.pose` for this step. `decay` = exp(-kInertialisationRate dt).
void solveBody(const ClipTable& table, const Mover& mover, float dt, float decay, PosedBody& body);

}  // namespace muster
