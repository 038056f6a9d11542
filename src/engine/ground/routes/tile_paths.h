// Shortest paths within one tile: Dijkstra 1959 over its cells, then pulled taut.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/tile_components.h"

namespace muster {

/// The clear steps of each cell of a tile to its neighbours, found when they are first needed.
using TileSteps = std::vector<std::uint16_t>;

/// The paths from one cell of a tile to all others of its component.
class TilePaths {
public:
    /// Searches from `from`. `steps` belongs to the tile and the ground; it starts empty.
    void run(const RouteGround& ground, const BorderTile& tile, Cell from, TileSteps& steps);
    /// Allocates memory for searches.
    void reserve() {
        cost_.reserve(kTileArea);
        back_.reserve(kTileArea);
        open_.reserve(2 * kTileArea);
    }
    /// Forgets the search.
    void clear() { known_ = false; }
    bool known() const { return known_; }  ///< True after run().
    /// Length of the taut path from `start`, a point in sight of the first cell's stand point, to `end`, a
    /// point in sight of the stand point of `to` [m]; infinite where there is none. `corners` gets the points
    /// between both.
    double trace(const RouteGround& ground, Vec2 start, Cell to, Vec2 end, std::vector<Vec2>& corners) const;

private:
    struct Open {
        float cost;  // Cost of the path [cells].
        std::int32_t cell;
        friend bool operator<(const Open& a, const Open& b) {
            return a.cost != b.cost ? a.cost > b.cost : a.cell > b.cell;
        }
    };
    std::uint32_t stepsOf(const RouteGround& ground, const BorderTile& tile, Cell c, TileSteps& steps) const;

    bool known_ = false;
    Cell origin_;                    // Lower left cell of the tile.
    std::vector<float> cost_;        // Cost of each cell of the tile [cells].
    std::vector<std::int8_t> back_;  // Direction to the cell before; -1 at the first and where none.
    std::vector<Open> open_;
};

}  // namespace muster
