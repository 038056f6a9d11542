// Spreads the clip of a jump or climb over the patch that is crossed (SPEC C4).
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "people/motion/clip_table.h"

namespace muster {

/// Maps the share of a clip's length to a time in the clip, so that feet do not slide when its speed varies.
class TravelTimes {
public:
    /// The clip must not be cyclic.
    explicit TravelTimes(const Clip& clip);
    /// The time [s] at a share of the length, 0 to 1; strictly increasing.
    float time(float share) const;

private:
    std::vector<float> shares_;  ///< Share of the length at each frame.
    float rate_ = 60.0f;         ///< Frames per second.
};

/// One crossing of a patch.
struct PatchCrossing {
    std::uint32_t patch = 0;  ///< Patch crossed; 0 for none.
    std::int32_t clip = -1;   ///< Clip played.
    bool timed = false;     ///< True if the patch moves, so that the clip advances by time, not by distance.
    Vec2 normal{1.0, 0.0};  ///< Direction of the crossing.
    double begin = 0.0;     ///< Position along `normal` at which the clip begins [m].
    double length = 1.0;    ///< Distance over which the clip is stretched [m] > 0.
    double farthest = 0.0;  ///< Largest share of that distance covered to date.
};

/// Computes the crossing of a patch by a character at `position` that moves along `heading`, with a clip of
/// length `clipLength` [m]. The direction is the normal of the edge across which the polygon is narrowest if
/// the heading is within 50 degrees of it, else the heading. If the lengths of clip and patch differ by at
/// most 15 %, the clip is stretched over the patch. On a larger patch it plays in the middle; on a smaller
/// one it ends beyond the patch.
PatchCrossing crossPatch(const Environment& environment, std::uint32_t patch, Vec2 position, Vec2 heading,
                         double clipLength);

/// Updates and returns the share covered; negative before the clip begins.
double shareCrossed(PatchCrossing& path, Vec2 position);

}  // namespace muster
