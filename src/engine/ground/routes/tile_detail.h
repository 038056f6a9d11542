// Details of one tile for searches: its crossings to neighbours, and the paths between them.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/ground/routes/tile_paths.h"

namespace muster {

/// A crossing as one of the two tiles sees it.
struct TileCrossing {
    Cell cell;                   ///< The tile's own cell.
    Vec2 point;                  ///< Its stand point [m].
    std::int32_t component = 0;  ///< Its component.
    std::int32_t direction = 0;  ///< Direction to the neighbour.
};

/// Crossings by direction, in the order in which the neighbour lists them too.
struct TileDetail {
    std::vector<TileCrossing> crossings;
    std::array<std::int32_t, kDirections + 1> first{};  ///< Index of the first crossing in each direction.
    bool open = false;                                  ///< True if all paths are straight.

    /// A path between two crossings. Its corners lie in `corners`.
    struct Edge {
        double length = -1.0;  ///< Length [m]; negative for unknown.
        std::int32_t first = 0;
        std::int32_t count = 0;
    };
    std::vector<Edge> edges;          ///< Crossings x crossings; none for an open tile.
    std::vector<Vec2> corners;        ///< Corners of all edges [m].
    std::vector<std::uint8_t> known;  ///< 1 for crossings whose edges are all known.
    TileSteps steps;

    /// Allocates the memory that most tiles need.
    void reserve() {
        crossings.reserve(24);
        edges.reserve(24 * 24);
        known.reserve(24);
        corners.reserve(256);
        steps.reserve(kTileArea);
    }
    /// Forgets all crossings, but keeps the memory.
    void clear() {
        crossings.clear();
        first.fill(0);
        open = false;
        edges.clear();
        corners.clear();
        known.clear();
        steps.clear();
    }
};

/// Gives the components of a tile, and its cells.
class TileSource {
public:
    virtual ~TileSource() = default;
    /// The tile with its components.
    virtual BorderTile borderTile(std::int32_t tile) const = 0;
};

/// Finds the crossings of a tile. `found` is working memory.
void describeTile(const RouteGround& ground, const TileGrid& tiles, std::int32_t tile,
                  const TileSource& source, std::vector<BorderCrossing>& found, TileDetail& detail);
/// Finds the paths from a crossing to all others of its component. The path back is found apart, so that no
/// answer depends on the order of questions. `corners` is working memory.
void describePaths(const RouteGround& ground, const BorderTile& tile, std::int32_t crossing, TilePaths& paths,
                   std::vector<Vec2>& corners, TileDetail& detail);

}  // namespace muster
