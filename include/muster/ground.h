// What lies on the ground: obstacles, which nobody can walk through (SPEC M6), patches with motions of their
// own (SPEC C1), areas where people leave, come and wait, and MovingAI grid maps (Sturtevant 2012; SPEC B7).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/generated/ground_definitions.h"
#include "muster/status.h"

namespace muster {

/// The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order.
std::vector<ClipFacts> defaultClipFacts();

/// Reads the text of a `.map` file (type octile). Fails with ParseError, naming the line.
Result<MapGrid> parseMap(const std::string& text);

/// Blocked cells (`@ O T W`) as few rectangular obstacles, which do not overlap and cover exactly these
/// cells. Cells that touch only at a corner leave no gap.
std::vector<ObstacleDef> mapObstacles(const MapGrid& map, const MapDef& def);
/// Swamp cells as few rectangular patches on which `motion` is played.
std::vector<PatchDef> mapPatches(const MapGrid& map, const MapDef& def, MotionId motion);

/// What an area has seen.
struct AreaCount {
    std::uint32_t passed = 0;   ///< People who have left by an exit, or come by a source.
    std::uint32_t waiting = 0;  ///< People of a source for whom there is no room yet.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(passed, waiting);
    }
};

}  // namespace muster
