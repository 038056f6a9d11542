// Finds the doors of a building: narrow places of the free ground between two wider rooms
// (docs/method/goals.md).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "engine/passages/key_sort.h"
#include "engine/passages/passage.h"
#include "engine/passages/walk_field.h"
#include "muster/geometry.h"

namespace muster {

/// The doors of the ground at which people have a choice, and the rooms between them.
struct DoorPlan {
    std::vector<Passage> doors;
    /// The rooms on the right and on the left of each door.
    std::vector<std::array<std::int32_t, 2>> beside;
    std::vector<std::int32_t> room;                    ///< Room of each cell; -1 for walls.
    std::vector<std::vector<std::int32_t>> exitRooms;  ///< The rooms into which each exit reaches, ascending.
    std::int32_t rooms = 0;                            ///< Number of rooms.
    WalkEdges edges;                                   ///< Edges between cells, with all doors closed.
};

/// Divides the free ground into the basins of its clearance (a watershed; Beucher and Lantuejoul 1979), and
/// joins basins that no narrower place parts. Owns the working memory.
class DoorSearch {
public:
    /// Finds the doors of a ground whose cells have this unit cost. An exit is a room in which nobody has to
    /// wait, however narrow it is. The only door of a room is left out where it belongs to an exit just
    /// behind it, or to the only exit.
    void find(const Environment& environment, const StaticGround& ground, const UnitCost& unitCost,
              std::span<const Polygon> exits, DoorPlan& plan);

private:
    void findHeights(const StaticGround& ground, const UnitCost& unitCost, std::span<const Polygon> exits);
    std::int32_t rootOf(std::int32_t cell);
    void flood(const Environment& environment, DoorPlan& plan);
    void meet(const Environment& environment, std::int32_t cell, std::int32_t other, DoorPlan& plan);
    void climb(std::int32_t cell, const DoorPlan& plan, std::vector<Vec2>& path) const;
    void closeDoors(const UnitCost& unitCost, DoorPlan& plan) const;
    void labelRooms(DoorPlan& plan);
    std::array<std::int32_t, 2> roomsBeside(const Passage& door, const DoorPlan& plan) const;
    void findExitRooms(DoorPlan& plan) const;
    bool isOfExit(const Passage& door, std::int32_t room, const DoorPlan& plan) const;
    bool drop(DoorPlan& plan, bool deadEnds);

    double radius_ = 0.0;  // Radius of a body of the usual size [m].
    Grid grid_;
    std::vector<double> height_;        // Clearance of each cell [m]; very large in exits, below 0 in walls.
    std::vector<SortKey> order_;        // Cells, the widest first.
    std::vector<std::int32_t> parent_;  // Disjoint sets of cells: basins; -1 for cells to come.
    std::vector<double> peak_;          // Greatest height of a basin, by its root.
    std::vector<std::vector<std::int32_t>> exitCells_;
    std::vector<std::int32_t> stack_;
    std::vector<Vec2> way_, part_;
    KeySort sort_;
};

}  // namespace muster
