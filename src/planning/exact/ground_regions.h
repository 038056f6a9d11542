// Connected parts of the ground a unit cost leaves free.
#pragma once

#include <cstdint>
#include <vector>

#include "cost/unit_cost.h"

namespace muster {

/// Labels free cells by the part they are connected with (over edges, as fast marching goes). Tells in
/// advance which places a character can never reach, so that no front floods the ground for it. Owns its
/// working memory.
class GroundRegions {
public:
    /// Labels every cell that is no wall.
    void label(const UnitCost& cost);
    /// Label of the cell under `p`, or of the free cell nearest to `p`; -1 where all is wall.
    std::int32_t at(Vec2 p) const;
    /// `p` where one of the four cells around it is free, else the centre of the nearest free cell (`p` where
    /// all is wall).
    Vec2 standing(Vec2 p) const;

private:
    std::int32_t nearestFree(Vec2 p) const;

    Grid grid_;
    std::int32_t count_ = 0;
    std::vector<std::int32_t> labels_;
    std::vector<std::int32_t> stack_;
};

}  // namespace muster
