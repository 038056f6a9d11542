// A whole body: the pose played, with feet and hands held where they touch (SPEC C6).
#pragma once

#include <array>
#include <cstdint>

#include "character/motion/clip_table.h"
#include "character/motion/inertia.h"
#include "character/motion/player.h"

namespace muster {

/// A foot or a hand between world and body.
struct HeldLimb {
    bool held = false;         ///< It stays where it is.
    bool steps = false;        ///< It was let go because the body had moved on; it is on its way to where it
                               ///< belongs.
    bool used = false;         ///< `place` and `rotation` are of the last step.
    Vec2 anchor;               ///< Where it is held [m], in the world.
    float height = 0.0f;       ///< Of the anchor [m].
    Rotation frame;            ///< To which its contact's frames are turned, in the world.
    Vec2 place;                ///< Where the joint was shown last [m], in the world...
    float placeHeight = 0.0f;  ///< ... and how high [m].
    Quat rotation;             ///< ... and how it was turned, in the world.
    Vec3 offset;               ///< Left of a difference when it was taken or let go [m], in the world.
    Quat turned;               ///< Left of a difference of rotation.
    float left = 0.0f;         ///< Share of these still there, before smoothing.
    float fadeTime = 0.1f;     ///< In which they go [s].
};

/// State of a body from step to step.
struct Body {
    std::uint32_t id = 0;
    bool fresh = true;
    BodyPose pose;    ///< Shown.
    BodyPose last;    ///< Played, with inertia, before feet were held; one step ago.
    BodyPose before;  ///< ... two steps ago.
    Inertia inertia;
    std::array<HeldLimb, kHeldLimbCount> limbs;
    std::array<Vec3, 2> stance;    ///< About which steps are stretched: those of the clip, smoothed [m].
    std::array<float, 2> knees{};  ///< Cosines of the angles in the knees, as shown last.
    float drop = 0.0f;             ///< By which the hips are lowered so that held feet are reached [m].
};

/// Makes `body.pose` for this step. `decay` = exp(-kInertiaRate dt).
void holdBody(const ClipTable& table, const Mover& mover, float dt, float decay, Body& body);

}  // namespace muster
