// Progress of a character on its path, in the words of the specification's section 8.
#pragma once

#include <cstdint>

#include "muster/vec2.h"

namespace muster {

inline constexpr double kArrivedReach = 0.5;    ///< "Arrived": distance to its place [m]...
inline constexpr double kArrivedTime = 1.0;     ///< ... for this time [s].
inline constexpr double kStuckDistance = 0.25;  ///< "Stuck": movement [m]...
inline constexpr double kStuckTime = 5.0;       ///< ... below which a character has stayed for this time [s].
/// Time within reach of its place after which a character stays there [s].
inline constexpr double kStayedTime = 3.0;
/// Distance within which a character that walks to and fro camps [m].
inline constexpr double kCampReach = 2.0;

/// Progress of one character on its path.
struct WalkProgress {
    Vec2 anchor;                ///< Point from which it has not been kStuckDistance away since `movedAt` [m].
    std::uint32_t movedAt = 0;  ///< Step in which it had last moved by kStuckDistance.
    std::uint32_t since = 0;    ///< Step in which it came within reach of its place, or left it.
    bool within = false;        ///< True if it is within kArrivedReach of its place.
    bool stuckRaised = false;   ///< True if Stuck was raised, and it has not moved since.
    Vec2 camp;                  ///< Point from which it has not been kCampReach away since `campedAt` [m].
    std::uint32_t campedAt = 0;  ///< Step in which it had last been kCampReach away.

    /// Lets an archive read or write the progress.
    template <class Archive>
    void visit(Archive& archive) {
        archive(anchor, movedAt, since, within, stuckRaised, camp, campedAt);
    }
};

}  // namespace muster
