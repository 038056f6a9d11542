// Draws clips as strips of poses, for judging motion by eye.
#pragma once

#include <cstdint>
#include <string>

#include "muster/clip.h"

namespace muster {

/// Options of a strip.
struct PoseStripDef {
    std::int32_t poses = 12;            ///< Number of columns, evenly distributed over the clip, 1 to 60.
    double begin = 0.0;                 ///< Begin of the strip as a share of the clip, 0 to 1.
    double end = 1.0;                   ///< End of the strip as a share of the clip, above `begin`.
    std::int32_t pixelsPerMetre = 110;  ///< Scale of the picture [px/m], 20 to 1000.
    double columnWidth = 1.35;          ///< Width of a column [m], > 0.
    bool side = true;                   ///< Whether there is a row seen from the right.
    bool front = true;                  ///< Whether there is a row seen from the front.
    bool oblique = true;                ///< Whether there is a row seen from the front right and above.
};

/// Poses of the clip from the side, from the front and obliquely, with the ground, a wall, hurdle or water
/// where the clip has one, and a mark at each contact. The result is an SVG document or the bytes of a PNG
/// file.
std::string poseStrip(const Clip& clip, const PoseStripDef& def, bool png);

}  // namespace muster
