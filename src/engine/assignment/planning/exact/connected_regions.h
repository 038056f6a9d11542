// Connected-component labelling of the free ground.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/fields/cost/unit_cost.h"

namespace muster {

/// Labels free cells by region: cells are connected over their edges, as in fast marching. A plan thus knows
/// in advance which places a character can never reach, so that no front floods the ground in search of it.
/// Owns its working memory.
class ConnectedRegions {
public:
    /// Labels every cell that is no wall.
    void label(const UnitCost& cost);
    /// Label of the cell under `p`, or of the free cell nearest to `p`; -1 where all is wall.
    std::int32_t at(Vec2 p) const;
    /// `p` where one of the four cells around it is free, else the centre of the nearest free cell; `p` where
    /// all is wall.
    Vec2 nearestFreePoint(Vec2 p) const;

private:
    std::int32_t nearestFreeCell(Vec2 p) const;

    Grid grid_;
    std::int32_t count_ = 0;            // Number of regions.
    std::vector<std::int32_t> labels_;  // Label per cell, -1 for walls.
    std::vector<std::int32_t> stack_;   // Working memory.
};

}  // namespace muster
