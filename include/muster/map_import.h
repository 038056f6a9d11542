// MovingAI grid maps as ground (SPEC B7).
#pragma once

#include <string>
#include <vector>

#include "muster/obstacle.h"
#include "muster/patch.h"
#include "muster/status.h"

namespace muster {

/// A MovingAI map: rows from the top, as in the file.
struct MapGrid {
    std::int32_t width = 0;   ///< Columns.
    std::int32_t height = 0;  ///< Rows.
    std::string cells;        ///< One character per cell, row by row, the top row first.

    /// Lets an archive read or write the map.
    template <class Archive>
    void visit(Archive& archive) {
        archive(width, height, cells);
    }
};

/// Options of turning a map into obstacles and patches.
struct MapDef {
    double metresPerCell = 1.0;  ///< [m] > 0
    Vec2 origin;                 ///< Lower left corner of the map [m].
    double swampSpeed = 0.4;     ///< Travel speed of swamp `S` > 0.
};

/// Reads the text of a `.map` file (type octile). Fails with ParseError naming the line.
Result<MapGrid> parseMap(const std::string& text);

/// Blocked cells (`@ O T W`) as few convex, non-overlapping obstacles that cover exactly them;
/// cells that touch only at a corner stay joined, so nobody slips through there.
std::vector<ObstacleDef> mapObstacles(const MapGrid& map, const MapDef& def);
/// Swamp cells as few rectangular patches; `motion` is played on them.
std::vector<PatchDef> mapPatches(const MapGrid& map, const MapDef& def, MotionId motion);

}  // namespace muster
