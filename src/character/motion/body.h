// The pose of a whole body: the clip's pose, smoothed at switches, with feet and hands locked where they
// touch.
#pragma once

#include <array>
#include <cstdint>

#include "character/motion/clip_table.h"
#include "character/motion/inertialisation.h"
#include "character/motion/player.h"

namespace muster {

/// The lock of one foot or hand, in the world.
struct LimbLock {
    bool locked = false;    ///< It stays at its anchor.
    bool stepping = false;  ///< It was released because the body had moved on, and steps to its free target.
    Vec2 anchor;            ///< Point to which it is locked [m].
    float anchorHeight = 0.0f;  ///< Height of the anchor [m].
    Rotation axes;              ///< Axes in which its contact's frames are given.
    Vec2 position;              ///< Position of the joint as shown last [m].
    float height = 0.0f;        ///< Height of the joint as shown last [m].
    Quat rotation;              ///< Rotation of the joint as shown last.
    Vec3 offset;                ///< Of the shown joint from its target when it was locked or released [m].
    Quat rotationOffset;        ///< The same of its rotation.
    float fade = 0.0f;          ///< Share of these offsets still shown, before smoothing, 0 to 1.
    float fadeTime = 0.1f;      ///< Over which they fade [s].
};

/// State of a body from step to step.
struct Body {
    std::uint32_t id = 0;  ///< Of the character.
    bool fresh = true;     ///< It has had no step yet.
    BodyPose pose;         ///< As shown.
    BodyPose last;         ///< Played one step ago, smoothed, before limbs were locked.
    BodyPose before;       ///< The same two steps ago.
    Inertialisation inertialisation;
    std::array<LimbLock, kLockableLimbCount> limbs;  ///< By index of kLockableLimbs.
    std::array<Vec3, 2> stance;    ///< Points about which steps are scaled: those of the clip, smoothed [m].
    std::array<float, 2> knees{};  ///< Cosines of the angles in the knees as shown last.
    float drop = 0.0f;  ///< Distance by which the hips are lowered so that locked feet are reached [m].
};

/// Makes `body.pose` for this step. `decay` = exp(-kInertialisationRate dt).
void solveBody(const ClipTable& table, const Mover& mover, float dt, float decay, Body& body);

}  // namespace muster
