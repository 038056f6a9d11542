// A body described by where its parts should be, and the pose that puts them there.
#pragma once

#include <array>

#include "character/generator/body.h"
#include "muster/clip.h"

namespace muster::generator {

inline constexpr double kThigh = 0.42;               ///< Hip to knee [m].
inline constexpr double kShin = 0.41;                ///< Knee to ankle [m].
inline constexpr double kAnkleHeight = 0.08;         ///< Of a flat foot [m].
inline constexpr Vec3 kHeel{-0.06f, 0.0f, -0.08f};   ///< Where the sole begins, from the ankle [m].
inline constexpr Vec3 kBall{0.13f, 0.0f, -0.05f};    ///< Where toes bend: the joint, from the ankle [m].
inline constexpr Vec3 kToeTip{0.20f, 0.0f, -0.08f};  ///< Where the sole ends, from the ankle [m].

/// Turns by pitch about y, then roll about x, then yaw about z [rad]: roll stays roll for a body laid on its
/// front.
Quat turned(double pitch, double roll, double yaw);

/// A leg: the ankle's place and how the foot is held.
struct Leg {
    Vec3 ankle;
    Quat foot;
    double toe = 0.0;             ///< Toes bent down against the foot [rad].
    Vec3 knee{1.0f, 0.0f, 0.0f};  ///< Where the knee points.
};

/// An arm's hold: as the body's channels say, or its wrist somewhere, or between the two.
struct Reach {
    double weight = 0.0;  ///< 0: by the channels; 1: the wrist is where this says.
    Vec3 wrist;
    Quat hand;                       ///< Rest: fingers to the side, palm down.
    Vec3 elbow{-1.0f, 0.0f, -0.3f};  ///< Where the elbow points.
    double follow = 0.0;  ///< 0: the hand is held as `hand` says; 1: it goes on straight from the forearm.
};

/// All that makes a pose, in one frame: the travelling one, or the ground's.
struct Figure {
    Body body;
    std::array<Leg, 2> legs;     ///< Left, right.
    std::array<Reach, 2> reach;  ///< Left, right.
};

/// The rest orientation of a hand laid flat, palm down, its fingers towards `yaw` (0: forward), tilted
/// fingers up.
Quat flatHand(std::size_t side, double yaw, double tilt = 0.0);
/// At share `t` of the way from `a` to `b`.
Figure blend(const Figure& a, const Figure& b, double t);
/// Where the hip joint of that side is.
Vec3 hipJoint(const Body& body, std::size_t side);
/// The pose of a figure given in the travelling frame.
BodyPose poseOf(const Figure& figure);

}  // namespace muster::generator
