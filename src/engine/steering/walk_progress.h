// How a character gets on with its way, in the words of the specification's section 8.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

inline constexpr double kArrivedReach = 0.5;  ///< "Arrived": within this of its place [m]...
inline constexpr double kArrivedFor = 1.0;    ///< ... for this long [s].
inline constexpr double kStuckMove = 0.25;    ///< "Stuck": moved less than this [m]...
inline constexpr double kStuckFor = 5.0;      ///< ... for this long [s].
inline constexpr double kStayedFor = 3.0;  ///< Who is within reach of its place for so long stays there [s].
inline constexpr double kCampReach = 2.0;  ///< Who walks to and fro within this distance camps [m].

/// How one character gets on with its way.
struct WalkProgress {
    Vec2 anchor;                 ///< It has not been kStuckMove away from here since `movedAt` [m].
    std::uint32_t movedAt = 0;   ///< Step in which it last had moved by kStuckMove.
    std::uint32_t since = 0;     ///< Step in which it came within reach of its place, or left it.
    bool within = false;         ///< It is within kArrivedReach of its place.
    bool stuckRaised = false;    ///< Stuck was raised, and it has not moved since.
    Vec2 camp;                   ///< It has not been kCampReach away from here since `campedAt` [m].
    std::uint32_t campedAt = 0;  ///< Step in which it last had been so far away.

    /// Lets an archive read or write the progress.
    template <class Archive>
    void visit(Archive& archive) {
        archive(anchor, movedAt, since, within, stuckRaised, camp, campedAt);
    }
};

}  // namespace muster
