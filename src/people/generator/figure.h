// A body described by targets of its parts, and the pose that reaches them by inverse kinematics.
#pragma once

#include <array>

#include "muster/clip.h"
#include "people/generator/channels.h"

namespace muster::generator {

inline constexpr double kThigh = 0.42;               ///< Length from hip to knee [m].
inline constexpr double kShin = 0.41;                ///< Length from knee to ankle [m].
inline constexpr double kAnkleHeight = 0.08;         ///< Height of the ankle of a flat foot [m].
inline constexpr Vec3 kHeel{-0.06f, 0.0f, -0.08f};   ///< Rear end of the sole, from the ankle [m].
inline constexpr Vec3 kBall{0.13f, 0.0f, -0.05f};    ///< Joint of the toes, from the ankle [m].
inline constexpr Vec3 kToeTip{0.20f, 0.0f, -0.08f};  ///< Front end of the sole, from the ankle [m].

/// Rotation by pitch about y, then roll about x, then yaw about z [rad]. In this order roll is still roll for
/// a body that lies on its front.
Quat turned(double pitch, double roll, double yaw);

/// A leg: position of the ankle, rotation of the foot and direction of the knee.
struct Leg {
    Vec3 ankle;                   ///< Position of the ankle [m].
    Quat foot;                    ///< Rotation of the foot.
    double toe = 0.0;             ///< Flexion of the toes, downwards relative to the foot [rad].
    Vec3 knee{1.0f, 0.0f, 0.0f};  ///< Direction in which the knee points.
};

/// The target of an arm, blended with the arm given by the body's channels.
struct Reach {
    double weight = 0.0;  ///< Weight: at 0 the channels decide, at 1 the wrist is at `wrist`.
    Vec3 wrist;           ///< Target of the wrist [m].
    Quat hand;            ///< Rotation of the hand; in the rest pose fingers to the side, palm down.
    Vec3 elbow{-1.0f, 0.0f, -0.3f};  ///< Direction in which the elbow points.
    double follow = 0.0;  ///< Share by which the hand continues the forearm; at 0 it has the rotation `hand`.
};

/// All inputs of a pose, in one frame: the travelling frame or the ground frame.
struct Figure {
    ChannelValues body;          ///< Channels of trunk, head and free arms.
    std::array<Leg, 2> legs;     ///< Left and right leg.
    std::array<Reach, 2> reach;  ///< Left and right arm.
};

/// Orientation of a hand that lies flat, palm down, with its fingers towards `yaw` (0: forward), the fingers
/// raised by `tilt` [rad].
Quat flatHand(std::size_t side, double yaw, double tilt = 0.0);
/// Interpolation from `a` (`t` = 0) to `b` (`t` = 1).
Figure blend(const Figure& a, const Figure& b, double t);
/// Position of the hip joint of that side [m].
Vec3 hipJoint(const ChannelValues& body, std::size_t side);
/// The pose of a figure given in the travelling frame.
BodyPose poseOf(const Figure& figure);

}  // namespace muster::generator
