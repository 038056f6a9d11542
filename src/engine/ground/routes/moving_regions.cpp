#include "engine/ground/routes/moving_regions.h"

#include <algorithm>

#include "engine/ground/routes/nearest_cell.h"

namespace muster {

void MovingRegions::update(const RouteGraph& graph) {
    graph_ = &graph;
    ground_ = RouteGround(graph.environment(), graph.radius(), {}, true);
    labelTiles();
    joinTiles();
}

void MovingRegions::labelTiles() {
    const TileGrid& tiles = graph_->tiles();
    changed_.clear();
    for (const CellRect& area : graph_->environment().movingObstacleAreas()) {
        const CellRect rect = tiles.tilesOf(area);
        for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y)
            for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) changed_.push_back(y * tiles.width + x);
    }
    std::sort(changed_.begin(), changed_.end());
    changed_.erase(std::unique(changed_.begin(), changed_.end()), changed_.end());
    tiles_.resize(changed_.size());
    for (std::size_t k = 0; k < changed_.size(); ++k) {
        tiles_[k].tile = changed_[k];
        labeller_.run(ground_, tiles.cellsOf(changed_[k]), tiles_[k].components);
    }
}

// Borders of the tiles near moving obstacles are examined; all others are joined as in the graph.
void MovingRegions::joinTiles() {
    const TileGrid& tiles = graph_->tiles();
    const auto countOf = [&](std::int32_t tile) { return borderTile(tile).components->count; };
    regions_.join(tiles, countOf, [&](std::int32_t tile, const auto& visit) {
        const bool own = ownTile(tile) != nullptr;
        joints_.clear();
        for (std::int32_t d = 0; d < kDirections / 2; ++d) {
            const std::int32_t other = tiles.neighbour(tile, d);
            if (other >= 0 && (own || ownTile(other) != nullptr))
                findJoints(ground_, tiles, *this, tile, d, crossings_, joints_);
        }
        for (const TileJoint& joint : joints_) visit(joint);
        for (const TileJoint& joint : graph_->joints(tile))
            if (!own && ownTile(tiles.neighbour(tile, joint.direction)) == nullptr) visit(joint);
    });
}

const MovingRegions::OwnTile* MovingRegions::ownTile(std::int32_t tile) const {
    const auto at = std::lower_bound(tiles_.begin(), tiles_.end(), tile,
                                     [](const OwnTile& own, std::int32_t t) { return own.tile < t; });
    return at != tiles_.end() && at->tile == tile ? &*at : nullptr;
}

BorderTile MovingRegions::borderTile(std::int32_t tile) const {
    const OwnTile* const own = ownTile(tile);
    return own != nullptr ? BorderTile{graph_->tiles().cellsOf(tile), &own->components}
                          : graph_->borderTile(tile);
}

std::int32_t MovingRegions::region(Vec2 p) const {
    const TileGrid& tiles = graph_->tiles();
    if (!tiles.cells.contains(tiles.cells.cellOf(p))) return -1;
    const std::optional<RouteAnchor> found = anchorOf(ground_, p, [&](Cell c, std::int32_t& tile) {
        tile = tiles.tileOf(c);
        return borderTile(tile).components->at(TileGrid::localOf(c));
    });
    return found ? regions_.of(found->tile, found->component) : -1;
}

}  // namespace muster
