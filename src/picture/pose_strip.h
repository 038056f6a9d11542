// Clips as strips of poses, to judge motion by eye.
#pragma once

#include <cstdint>
#include <string>

#include "muster/clip.h"

namespace muster {

/// What a strip shows. The defaults are usable as they stand.
struct PoseStripDef {
    std::int32_t poses = 12;            ///< Columns, evenly over the clip, 1 to 60.
    double begin = 0.0;                 ///< Where the strip begins, share of the clip, 0 to 1.
    double end = 1.0;                   ///< Where it ends, share of the clip, above `begin`.
    std::int32_t pixelsPerMetre = 110;  ///< 20 to 1000.
    double columnWidth = 1.35;          ///< [m] > 0.
    bool side = true;                   ///< A row seen from the right.
    bool front = true;                  ///< A row seen from ahead.
    bool oblique = true;                ///< A row seen from ahead on the right, from above.
};

/// Poses of the clip from the side, from ahead and aslant, with the ground, the wall or hurdle it goes over,
/// the water it swims in, and a mark at each contact; as an SVG document, or as the bytes of a PNG file.
std::string poseStrip(const Clip& clip, const PoseStripDef& def, bool png);

}  // namespace muster
