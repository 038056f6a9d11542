// A jump or a climb over its patch: when it begins, how far it has come (SPEC C4).
#pragma once

#include <cstdint>
#include <vector>

#include "character/motion/clip_table.h"
#include "environment/environment.h"

namespace muster {

/// The time in a clip at which a share of its way is behind, so that feet do not slide where it goes
/// unevenly.
class WayToTime {
public:
    /// Of a clip that ends.
    explicit WayToTime(const Clip& clip);
    /// [s] for a share of the way, 0 to 1; rises strictly.
    float time(float share) const;

private:
    std::vector<float> way_;  ///< Share behind, per frame.
    float rate_ = 60.0f;      ///< Frames a second.
};

/// One crossing of a patch.
struct ActionPath {
    std::uint32_t patch = 0;  ///< Patch crossed; 0 for no action.
    std::int32_t clip = -1;   ///< Clip played.
    bool timed = false;       ///< The patch moves: the clip runs by time, not by the way.
    Vec2 normal{1.0, 0.0};    ///< Direction of the crossing.
    double begin = 0.0;       ///< Along it, where the clip begins [m].
    double length = 1.0;      ///< Of the way that the clip is spread over [m] > 0.
    double farthest = 0.0;    ///< Share of the clip's way behind; never falls.
};

/// The crossing of a patch by somebody at `position` who faces `heading`, with a clip that covers
/// `clipLength` [m]. The patch is crossed at right angles to the side that makes it narrowest, where the
/// heading is within 50 degrees of that; else straight on. A clip that suits the patch within 15 % is spread
/// over all of it; in a longer one it is played in the middle; beyond a shorter one it is completed.
ActionPath crossing(const Environment& environment, std::uint32_t patch, Vec2 position, Vec2 heading,
                    double clipLength);

/// Brings the share up to date; negative while the clip's begin lies still ahead.
double shareBehind(ActionPath& path, Vec2 position);

}  // namespace muster
