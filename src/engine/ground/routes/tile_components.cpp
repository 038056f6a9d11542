#include "engine/ground/routes/tile_components.h"

namespace muster {
namespace {

// The four directions to neighbouring cells that visit each pair once.
constexpr std::int32_t kHalf = kDirections / 2;

template <class Visit>
void forCells(const CellRect& cells, const Visit& visit) {
    for (std::int32_t y = cells.low.y; y <= cells.high.y; ++y)
        for (std::int32_t x = cells.low.x; x <= cells.high.x; ++x) visit(Cell{x, y});
}

Cell neighbourOf(Cell c, std::int32_t direction) {
    return {c.x + kOffsets[direction].x, c.y + kOffsets[direction].y};
}

}  // namespace

std::int32_t TileLabeller::rootOf(std::int32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
}

void TileLabeller::joinSets(std::int32_t a, std::int32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[a > b ? a : b] = a > b ? b : a;
}

void TileLabeller::joinByRaster(const RouteGround& ground, const CellRect& cells) {
    const Grid& grid = ground.grid();
    forCells(cells, [&](Cell c) {
        const std::int32_t index = grid.index(c);
        if (!ground.isFree(index)) return;
        for (std::int32_t d = 0; d < kHalf; ++d) {
            const Cell n = neighbourOf(c, d);
            if (!contains(cells, n)) continue;
            const std::int32_t other = grid.index(n);
            if (ground.isFree(other) && ground.stepClearByRaster(index, other, d >= 2))
                joinSets(TileGrid::localOf(c), TileGrid::localOf(n));
        }
    });
}

// Where the raster does not decide, exact steps join what is not joined yet.
void TileLabeller::joinByGeometry(const RouteGround& ground, const CellRect& cells) {
    forCells(cells, [&](Cell c) {
        const std::int32_t a = TileGrid::localOf(c);
        if (parent_[a] < 0) return;
        for (std::int32_t d = 0; d < kHalf; ++d) {
            const Cell n = neighbourOf(c, d);
            if (!contains(cells, n)) continue;
            const std::int32_t b = TileGrid::localOf(n);
            if (parent_[b] < 0 || rootOf(a) == rootOf(b)) continue;
            if (ground.stepClear(c, point_[a], n, point_[b])) joinSets(a, b);
        }
    });
}

void TileLabeller::number(const CellRect& cells, TileComponents& result) {
    // Roots are the first cells of their sets, so that labels rise in row-major order.
    std::array<std::uint16_t, kTileArea> label;
    label.fill(TileComponents::kNone);
    forCells(cells, [&](Cell c) {
        const std::int32_t k = TileGrid::localOf(c);
        if (parent_[k] < 0) return;
        const std::int32_t root = rootOf(k);
        if (root == k) label[k] = static_cast<std::uint16_t>(result.count++);
        label[k] = label[root];
    });
    if (result.count > 1) result.labels.assign(label.begin(), label.end());
    if (result.count != 1) return;
    result.rows.assign(kTileCells, 0);
    for (std::int32_t k = 0; k < kTileArea; ++k)
        if (label[k] == 0) result.rows[k / kTileCells] |= 1u << (k % kTileCells);
}

void TileLabeller::run(const RouteGround& ground, const CellRect& cells, TileComponents& result) {
    result.count = 0;
    result.open = false;
    result.labels.clear();
    result.rows.clear();
    // Only whole tiles are open, because an open tile does not list its cells.
    const bool whole = cells.high.x - cells.low.x + 1 == kTileCells &&
                       cells.high.y - cells.low.y + 1 == kTileCells;
    if (whole && ground.isOpen(cells)) {
        result.count = 1;
        result.open = true;
        return;
    }
    parent_.fill(-1);
    bool any = false;
    forCells(cells, [&](Cell c) {
        const std::optional<Vec2> point = ground.standPoint(c);
        if (!point) return;
        const std::int32_t k = TileGrid::localOf(c);
        parent_[k] = k;
        point_[k] = *point;
        any = true;
    });
    if (!any) return;
    joinByRaster(ground, cells);
    joinByGeometry(ground, cells);
    number(cells, result);
}

}  // namespace muster
