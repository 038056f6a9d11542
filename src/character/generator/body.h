// How trunk, head and free arms are held: numbers that gaits compute and transitions blend.
#pragma once

#include <array>
#include <cstddef>

namespace muster::generator {

/// Angles [rad] and places [m] in the travelling frame (x forward, y left, z up). Pitch is positive forwards
/// and down, roll lifts the left side, yaw turns to the left. Arms are relative to the chest, hanging at
/// zero.
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
    LeftArmForward,  ///< Raised forwards.
    LeftArmOut,      ///< Away from the body.
    LeftArmTurn,     ///< Turned inwards about its own length.
    LeftElbow,       ///< Bent; 0 is straight.
    LeftWrist,       ///< Bent towards the palm.
    RightArmForward,
    RightArmOut,
    RightArmTurn,
    RightElbow,
    RightWrist,
    Count
};
inline constexpr std::size_t kArmChannels = 5;

/// A value for each channel.
struct Body {
    std::array<double, static_cast<std::size_t>(Channel::Count)> values{};

    double& operator[](Channel channel) { return values[static_cast<std::size_t>(channel)]; }
    double operator[](Channel channel) const { return values[static_cast<std::size_t>(channel)]; }
    /// An arm's channel by that of the left arm; `side` 0 is left, 1 right.
    double& arm(std::size_t side, Channel left) {
        return values[static_cast<std::size_t>(left) + side * kArmChannels];
    }
    double arm(std::size_t side, Channel left) const {
        return values[static_cast<std::size_t>(left) + side * kArmChannels];
    }
};

/// At share `t` of the way from `a` to `b`.
inline Body blend(const Body& a, const Body& b, double t) {
    Body out;
    for (std::size_t i = 0; i < out.values.size(); ++i)
        out.values[i] = a.values[i] + (b.values[i] - a.values[i]) * t;
    return out;
}

}  // namespace muster::generator
