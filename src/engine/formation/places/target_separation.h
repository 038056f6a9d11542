// Reachable targets from scratch: targets are projected onto the free space and separated from each other.
#pragma once

#include <cstdint>
#include <vector>

#include "base/cell_list.h"
#include "base/neighbour_list.h"
#include "engine/formation/places/free_space.h"
#include "engine/formation/places/site_flood.h"

namespace muster {

/// Skin of the neighbour list of reachable targets, as a share of their separation.
inline constexpr double kTargetSkin = 0.8;
/// Factor of the separation that still counts as enough, so that touching targets stay so while they move.
inline constexpr double kSeparationTolerance = 1.0 - 1e-9;
/// Spacing of points that a flood finds, in separations.
inline constexpr double kSiteSpacing = 1.01;
/// Spacing, in separations, of targets of which more than half lie in walls: places that touch each other
/// leave no room to pass.
inline constexpr double kLooseSpacing = 1.5;

/// Working memory of separateTargets().
struct SeparationMemory {
    NeighbourList neighbours;              ///< Neighbours of the targets while they are pushed apart.
    std::vector<Vec2> push;                ///< Correction of each target in this iteration [m].
    std::vector<std::uint8_t> moved;       ///< By target: 1 where the last iteration moved it.
    std::vector<NeighbourPair> conflicts;  ///< Pairs that are too close after the last iteration.
    CellList cells;                        ///< Cells of the targets while some are relocated.
    std::vector<Vec2> taken;               ///< Points that relocated targets have taken [m].
    SiteFlood flood;                       ///< Flood for targets with no free point near by.
    std::vector<Vec2> asked;               ///< Targets as they were given [m].
};

/// Moves `targets` [m] to points of the free space that are at least `separation` [m] apart:
/// 1. Each is projected onto the free space.
/// 2. Pairs that are too close are pushed apart by Jacobi iterations, and projected again.
/// 3. Of targets still too close a greedy maximal independent set, in ascending order, stays; the others are
/// relocated
///    to free points near by, or where there is none to the next points that a flood over the region finds.
/// Where more than half of the targets are not free, and there is room, all this is done with kLooseSpacing
/// separations. `fit` is set to 1 for targets that have such a point, and to 0 for the others: the region is
/// full.
void separateTargets(const FreeSpace& space, double separation, std::vector<Vec2>& targets,
                     std::vector<std::uint8_t>& fit, SeparationMemory& memory);

}  // namespace muster
