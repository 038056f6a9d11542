// Regions of the ground as moving obstacles divide it at present.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_graph.h"

namespace muster {

/// The answers of RouteGraph::region() if all moving things stood still where they are. A cache of one
/// moment.
class MovingRegions : private TileSource {
public:
    /// Looks at the tiles near the present positions of moving obstacles, and joins regions again. Both must
    /// outlive the answers, and the graph must be up to date.
    void update(const RouteGraph& graph);
    /// The region in which a disc at `p` stands; -1 where it is blocked.
    std::int32_t region(Vec2 p) const;

private:
    struct OwnTile {
        std::int32_t tile = 0;
        TileComponents components;
    };

    BorderTile borderTile(std::int32_t tile) const override;
    const OwnTile* ownTile(std::int32_t tile) const;
    void labelTiles();
    void joinTiles();

    const RouteGraph* graph_ = nullptr;
    RouteGround ground_;          // Ground with moving obstacles.
    std::vector<OwnTile> tiles_;  // Tiles near moving obstacles, ascending.
    TileRegions regions_;

    // Working memory.
    TileLabeller labeller_;
    std::vector<std::int32_t> changed_;
    std::vector<BorderCrossing> crossings_;
    std::vector<TileJoint> joints_;
};

}  // namespace muster
