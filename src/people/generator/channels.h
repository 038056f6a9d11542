// Pose parameters of trunk, head and free arms. Gaits compute them and transitions blend them.
#pragma once

#include <array>
#include <cstddef>

namespace muster::generator {

/// Pose parameters: angles [rad] and positions [m] in the travelling frame (x forward, y left, z up).
/// Positive pitch tilts forwards and down, positive roll lifts the left side, positive yaw turns to the left.
/// Arm angles are relative to the chest; at zero the arms hang down.
enum class Channel : std::size_t {
    HipsX,
    HipsY,
    HipsZ,
    PelvisPitch,
    PelvisRoll,
    PelvisYaw,
    ChestPitch,
    ChestRoll,
    ChestYaw,
    HeadPitch,
    HeadRoll,
    HeadYaw,
    LeftArmForward,  ///< Angle of an arm raised forwards.
    LeftArmOut,      ///< Angle away from the body.
    LeftArmTurn,     ///< Rotation inwards about the arm's own axis.
    LeftElbow,       ///< Flexion of the elbow; 0 is straight.
    LeftWrist,       ///< Flexion of the wrist towards the palm.
    RightArmForward,
    RightArmOut,
    RightArmTurn,
    RightElbow,
    RightWrist,
    Count
};
inline constexpr std::size_t kArmChannels = 5;

/// A value for each channel.
struct ChannelValues {
    std::array<double, static_cast<std::size_t>(Channel::Count)> values{};

    double& operator[](Channel channel) { return values[static_cast<std::size_t>(channel)]; }
    double operator[](Channel channel) const { return values[static_cast<std::size_t>(channel)]; }
    /// The channel of one arm, given as the left arm's channel; `side` is 0 for left, 1 for right.
    double& arm(std::size_t side, Channel left) {
        return values[static_cast<std::size_t>(left) + side * kArmChannels];
    }
    double arm(std::size_t side, Channel left) const {
        return values[static_cast<std::size_t>(left) + side * kArmChannels];
    }
};

/// Linear interpolation from `a` (`t` = 0) to `b` (`t` = 1).
inline ChannelValues blend(const ChannelValues& a, const ChannelValues& b, double t) {
    ChannelValues out;
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = a.values[i] + (b.values[i] - a.values[i]) * t;
    return out;
}

}  // namespace muster::generator
