// MovingAI grid maps (Sturtevant 2012) as ground (SPEC B7).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/obstacle.h"
#include "muster/patch.h"

namespace muster {

/// The cells of a MovingAI map.
struct MapGrid {
    std::int32_t width = 0;   ///< Columns, 1 to 4096.
    std::int32_t height = 0;  ///< Rows, 1 to 4096.
    std::string cells;        ///< One character per cell, row by row, the top row first.

    /// Lets an archive read or write the map.
    template <class Archive>
    void visit(Archive& archive) {
        archive(width, height, cells);
    }
};

/// Scale and position of a map.
struct MapDef {
    double metresPerCell = 1.0;  ///< Edge of a map cell [m], above 0.
    Vec2 origin;                 ///< Lower left corner of the map [m].
    double swampSpeed = 0.4;     ///< Travel speed on swamp cells `S` relative to running, above 0.
};

/// Reads the text of a `.map` file (type octile). Fails with ParseError, naming the line.
Result<MapGrid> parseMap(const std::string& text);

/// Blocked cells (`@ O T W`) as few rectangular obstacles, which do not overlap and cover exactly these
/// cells. Cells that touch only at a corner leave no gap.
std::vector<ObstacleDef> mapObstacles(const MapGrid& map, const MapDef& def);
/// Swamp cells as few rectangular patches on which `motion` is played.
std::vector<PatchDef> mapPatches(const MapGrid& map, const MapDef& def, MotionId motion);

}  // namespace muster
