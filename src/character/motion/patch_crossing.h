// A jump or a climb over its patch: when the clip begins and how far it has come (SPEC C4).
#pragma once

#include <cstdint>
#include <vector>

#include "character/motion/clip_table.h"
#include "environment/environment.h"

namespace muster {

/// Maps the share of a clip's length to the time in it, so that feet do not slide where its speed varies.
class TravelTimes {
public:
    /// For a clip that is not cyclic.
    explicit TravelTimes(const Clip& clip);
    /// The time [s] at a share of the length, 0 to 1; rises strictly.
    float time(float share) const;

private:
    std::vector<float> shares_;  ///< Of the length, per frame.
    float rate_ = 60.0f;         ///< Frames a second.
};

/// One crossing of a patch.
struct PatchCrossing {
    std::uint32_t patch = 0;  ///< Patch crossed; 0 for no action.
    std::int32_t clip = -1;   ///< Clip played.
    bool timed = false;       ///< The patch moves: the clip runs by time, not by distance.
    Vec2 normal{1.0, 0.0};    ///< Direction of the crossing.
    double begin = 0.0;       ///< Along it, where the clip begins [m].
    double length = 1.0;      ///< Distance that the clip is stretched over [m] > 0.
    double farthest = 0.0;    ///< Largest share of that distance covered so far.
};

/// The crossing of a patch by a character at `position` with direction `heading`, with a clip that covers
/// `clipLength` [m]. The direction is the normal of the polygon's edge across which the polygon is narrowest
/// where the heading is within 50 degrees of it, else the heading. A clip within 15 % of the patch's extent
/// is stretched over all of it; on a larger patch it plays in the middle; beyond a smaller one it is
/// completed.
PatchCrossing crossPatch(const Environment& environment, std::uint32_t patch, Vec2 position, Vec2 heading,
                         double clipLength);

/// Updates the share covered; negative while the clip's begin lies ahead.
double shareCrossed(PatchCrossing& path, Vec2 position);

}  // namespace muster
