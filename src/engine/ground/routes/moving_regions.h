// Regions of the ground as moving obstacles divide it just now.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/route_graph.h"

namespace muster {

/// What RouteGraph::region() would tell if all that moves stood still where it is. A cache of one moment.
class MovingRegions : private TileSource {
public:
    /// Looks at the tiles near moving obstacles, where these stand now, and joins regions again. Both must
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
    RouteGround ground_;          // With moving obstacles.
    std::vector<OwnTile> tiles_;  // Near moving obstacles, ascending.
    TileRegions regions_;

    // Working memory.
    TileLabeller labeller_;
    std::vector<std::int32_t> changed_;
    std::vector<BorderCrossing> crossings_;
    std::vector<TileJoint> joints_;
};

}  // namespace muster
