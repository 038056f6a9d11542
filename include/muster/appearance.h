// How the people of a group look and move: for the eye only, no step of the simulation depends on it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace muster {

/// The build of drawn bodies.
enum class BodyBuild : std::uint8_t {
    Broad,   ///< Wide shoulders, short hair.
    Narrow,  ///< Narrow shoulders, wider hips, tied hair.
};
inline constexpr BodyBuild kLastBodyBuild = BodyBuild::Narrow;  ///< The last one.

/// A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in
/// all.
enum class MotionSet : std::uint8_t {
    March,  ///< Upright, with high knees and stiff arms.
    Weary,  ///< Stooped, with hanging arms and feet that are hardly lifted.
};
inline constexpr MotionSet kLastMotionSet = MotionSet::Weary;  ///< The last one.
/// Number of motion sets beside the plain one.
inline constexpr std::size_t kMotionSetCount = static_cast<std::size_t>(kLastMotionSet) + 1;

}  // namespace muster
