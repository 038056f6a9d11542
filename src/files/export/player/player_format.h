// The file that the web component <muster-player> plays: its layout and the units of its numbers. The page's
// reader has the same (web/src/player/file).
#pragma once

#include <cstdint>
#include <string>
#include <string_view>

namespace muster {

inline constexpr std::string_view kPlayerMagic = "MUSTERPL";
inline constexpr std::uint32_t kPlayerVersion = 2;
inline constexpr std::size_t kPlayerHeadBytes = 20;  ///< Magic, version, length, checksum.

// Units of whole numbers in the file.
inline constexpr double kPositionUnit = 0.005;    ///< Of characters and moving things [m].
inline constexpr double kShapeUnit = 0.002;       ///< Of ground, obstacles and patches [m].
inline constexpr double kBodyUnit = 0.0005;       ///< Of bodies, and of hips in poses [m].
inline constexpr std::int32_t kTurn = 512;        ///< Headings in one turn.
inline constexpr std::int32_t kThingTurn = 4096;  ///< Angles of moving things in one turn.
inline constexpr std::int32_t kClipSecond = 256;  ///< Clip times in one second.
inline constexpr std::int32_t kFadeSteps = 15;    ///< A whole clip before that still fades.
inline constexpr std::int32_t
    kRotationSteps = 1023;                         ///< Of a part of a rotation from -sqrt(1/2) to sqrt(1/2).
inline constexpr std::int32_t kWeightSteps = 255;  ///< Weights of a vertex sum up to it.
inline constexpr double kPosesPerSecond = 24.0;    ///< Of clips, at least.

/// Characters in all frames together, at most: what pages can hold.
inline constexpr std::uint64_t kMostPlayerSamples = 8u << 20;

/// The nearest whole number of units.
std::int32_t unitsOf(double value, double unit);

/// Collects the parts of a file.
class PlayerFile {
public:
    /// Adds a part with a tag of four letters.
    void add(std::string_view tag, std::string_view bytes);
    /// The whole file.
    std::string bytes() const;

private:
    std::string parts_;
};

}  // namespace muster
