#include "engine/ground/routes/tile_detail.h"

namespace muster {

void describeTile(const RouteGround& ground, const TileGrid& tiles, std::int32_t tile,
                  const TileSource& source, std::vector<BorderCrossing>& found, TileDetail& detail) {
    detail.clear();
    const BorderTile own = source.borderTile(tile);
    detail.open = own.components->open;
    for (std::int32_t d = 0; d < kDirections; ++d) {
        detail.first[d] = static_cast<std::int32_t>(detail.crossings.size());
        const std::int32_t other = tiles.neighbour(tile, d);
        if (other < 0) continue;
        found.clear();
        const bool forward = d < kDirections / 2;
        const BorderTile there = source.borderTile(other);
        if (forward)
            findCrossings(ground, own, there, d, found);
        else
            findCrossings(ground, there, own, d - kDirections / 2, found);
        for (const BorderCrossing& c : found) {
            const Cell cell = forward ? c.from : c.to;
            const std::optional<Vec2> point = ground.standPoint(cell);
            detail.crossings.push_back({cell, point ? *point : ground.grid().centre(cell),
                                        forward ? c.fromComponent : c.toComponent, d});
        }
    }
    detail.first[kDirections] = static_cast<std::int32_t>(detail.crossings.size());
    if (detail.open) return;
    detail.edges.assign(detail.crossings.size() * detail.crossings.size(), {});
    detail.known.assign(detail.crossings.size(), 0);
}

void describePaths(const RouteGround& ground, const BorderTile& tile, std::int32_t crossing, TilePaths& paths,
                   std::vector<Vec2>& corners, TileDetail& detail) {
    detail.known[crossing] = 1;
    const TileCrossing& from = detail.crossings[crossing];
    const auto n = static_cast<std::int32_t>(detail.crossings.size());
    bool ran = false;
    for (std::int32_t k = 0; k < n; ++k) {
        const TileCrossing& to = detail.crossings[k];
        TileDetail::Edge& edge = detail.edges[crossing * n + k];
        if (edge.length >= 0.0 || to.component != from.component) continue;
        corners.clear();
        if (ground.lineClear(from.point, to.point)) {
            edge.length = distance(from.point, to.point);
        } else {
            if (!ran) paths.run(ground, tile, from.cell, detail.steps);
            ran = true;
            edge.length = paths.trace(ground, from.point, to.cell, to.point, corners);
        }
        edge.first = static_cast<std::int32_t>(detail.corners.size());
        edge.count = static_cast<std::int32_t>(corners.size());
        detail.corners.insert(detail.corners.end(), corners.begin(), corners.end());
    }
}

}  // namespace muster
