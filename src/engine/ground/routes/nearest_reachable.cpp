// The ground of a region that is nearest to a point: rings of tiles, and the cells of tiles that may hold it.
#include "engine/ground/routes/nearest_reachable.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace muster {
namespace {

constexpr std::size_t kTableEntries = 4096;  // Number of entries: the shift below leaves 12 bits.

// The cell of a region whose centre is nearest to a point, the lowest index among equals.
class NearestCell {
public:
    NearestCell(const RouteGraph& graph, Vec2 p, std::int32_t region)
        : graph_(graph), grid_(graph.tiles().cells), p_(p), region_(region) {}

    std::int32_t run() {
        const TileGrid& tiles = graph_.tiles();
        const Cell start = grid_.nearestCell(p_);
        const Cell first{start.x / kTileCells, start.y / kTileCells};
        const double tileEdge = kTileCells * grid_.cell;
        for (std::int32_t k = 0; k <= std::max(tiles.width, tiles.height); ++k) {
            // Distance from which on tiles of this ring lie.
            const double bound = (k - 1) * tileEdge;
            if (k > 1 && bound * bound > least_) break;
            for (std::int32_t x = first.x - k; x <= first.x + k; ++x) {
                lookAtTile({x, first.y - k});
                if (k > 0) lookAtTile({x, first.y + k});
            }
            for (std::int32_t y = first.y - k + 1; y < first.y + k; ++y) {
                lookAtTile({first.x - k, y});
                lookAtTile({first.x + k, y});
            }
        }
        return best_;
    }

private:
    bool fits(std::int32_t tile, std::int32_t component) const {
        return component >= 0 && (region_ < 0 || graph_.regionOf(tile, component) == region_);
    }

    void lookAtTile(Cell at) {
        const TileGrid& tiles = graph_.tiles();
        if (at.x < 0 || at.y < 0 || at.x >= tiles.width || at.y >= tiles.height) return;
        const std::int32_t tile = at.y * tiles.width + at.x;
        const TileComponents& components = graph_.components(tile);
        bool any = false;
        for (std::int32_t k = 0; k < components.count && !any; ++k) any = fits(tile, k);
        const CellRect cells = tiles.cellsOf(tile);
        const Box centres{grid_.centre(cells.low), grid_.centre(cells.high)};
        if (!any || lengthSquared(centres.clamp(p_) - p_) > least_) return;
        if (components.open) {
            lookAtCell(grid_.nearestCell(centres.clamp(p_)));
            return;
        }
        for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y)
            for (std::int32_t x = cells.low.x; x <= cells.high.x; ++x)
                if (fits(tile, components.at(TileGrid::localOf({x, y})))) lookAtCell({x, y});
    }

    void lookAtCell(Cell c) {
        const std::int32_t index = grid_.index(c);
        const double squared = lengthSquared(grid_.centre(c) - p_);
        if (squared > least_ || (squared == least_ && index > best_)) return;
        least_ = squared;
        best_ = index;
    }

    const RouteGraph& graph_;
    const Grid& grid_;
    Vec2 p_;
    std::int32_t region_;
    double least_ = std::numeric_limits<double>::infinity();
    std::int32_t best_ = -1;
};

}  // namespace

Vec2 RouteGraph::nearestReachable(Vec2 p, std::int32_t region) const {
    const std::int32_t here = this->region(p);
    if (here >= 0 && (region < 0 || here == region)) return p;
    const std::int32_t cell = NearestCell(*this, p, region).run();
    if (cell < 0) return p;
    const Cell c = tiles_.cells.at(cell);
    const std::optional<Vec2> point = ground_.standPoint(c);
    return point ? *point : tiles_.cells.centre(c);
}

Vec2 NearestReachable::find(const RouteGraph& graph, Vec2 p, std::int32_t region) {
    const Environment& environment = graph.environment();
    if (instance_ != environment.instance() || version_ != environment.staticVersion() ||
        radius_ != graph.radius()) {
        entries_.assign(kTableEntries, {});
        instance_ = environment.instance();
        version_ = environment.staticVersion();
        radius_ = graph.radius();
    }
    const Grid& grid = graph.tiles().cells;
    const Cell c = grid.nearestCell(p);
    const std::int32_t cell = grid.index(c);
    const std::uint32_t key = static_cast<std::uint32_t>(cell) * 2u + (region < 0 ? 1u : 0u);
    Entry& entry = entries_[(key * 2654435761u) >> 20];
    if (entry.cell != cell || entry.region != region)
        entry = {cell, region, graph.nearestReachable(grid.centre(c), region)};
    return entry.point;
}

}  // namespace muster
