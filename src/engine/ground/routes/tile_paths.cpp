#include "engine/ground/routes/tile_paths.h"

#include <algorithm>
#include <limits>

namespace muster {
namespace {

constexpr float kDiagonal = 1.41421356f;
// Bit that is set in the steps of a cell once they are found.
constexpr std::uint16_t kKnown = 1u << kDirections;
constexpr float kUnreached = std::numeric_limits<float>::infinity();

// Directions 0, 1, 4 and 5 are straight.
bool isDiagonal(std::int32_t direction) {
    return direction % (kDirections / 2) >= 2;
}

}  // namespace

std::uint32_t TilePaths::stepsOf(const RouteGround& ground, const BorderTile& tile, Cell c,
                                 TileSteps& steps) const {
    std::uint16_t& mask = steps[TileGrid::localOf(c)];
    if (mask & kKnown) return mask;
    mask = kKnown;
    const std::optional<Vec2> point = ground.standPoint(c);
    for (std::int32_t d = 0; point && d < kDirections; ++d) {
        const Cell n{c.x + kOffsets[d].x, c.y + kOffsets[d].y};
        if (!contains(tile.cells, n) || tile.components->at(TileGrid::localOf(n)) < 0) continue;
        const std::optional<Vec2> other = ground.standPoint(n);
        if (other && ground.stepClear(c, *point, n, *other)) mask |= static_cast<std::uint16_t>(1u << d);
    }
    return mask;
}

void TilePaths::run(const RouteGround& ground, const BorderTile& tile, Cell from, TileSteps& steps) {
    if (steps.empty()) steps.assign(kTileArea, 0);
    known_ = true;
    origin_ = tile.cells.low;
    cost_.assign(kTileArea, kUnreached);
    back_.assign(kTileArea, -1);
    open_.clear();
    cost_[TileGrid::localOf(from)] = 0.0f;
    open_.push_back({0.0f, TileGrid::localOf(from)});
    while (!open_.empty()) {
        const Open at = open_.front();
        std::pop_heap(open_.begin(), open_.end());
        open_.pop_back();
        if (at.cost > cost_[at.cell]) continue;
        const Cell c{origin_.x + at.cell % kTileCells, origin_.y + at.cell / kTileCells};
        const std::uint32_t mask = stepsOf(ground, tile, c, steps);
        for (std::int32_t d = 0; d < kDirections; ++d) {
            if ((mask >> d & 1u) == 0) continue;
            const std::int32_t n = at.cell + kOffsets[d].y * kTileCells + kOffsets[d].x;
            const float cost = at.cost + (isDiagonal(d) ? kDiagonal : 1.0f);
            if (!(cost < cost_[n])) continue;
            cost_[n] = cost;
            back_[n] = static_cast<std::int8_t>((d + kDirections / 2) % kDirections);
            open_.push_back({cost, n});
            std::push_heap(open_.begin(), open_.end());
        }
    }
}

double TilePaths::trace(const RouteGround& ground, Vec2 start, Cell to, Vec2 end,
                        std::vector<Vec2>& corners) const {
    corners.clear();
    std::int32_t at = TileGrid::localOf(to);
    if (cost_[at] == kUnreached) return std::numeric_limits<double>::infinity();
    const auto add = [&](Vec2 p) {
        if (corners.empty() || !(corners.back() == p)) corners.push_back(p);
    };
    add(end);
    for (;;) {
        const Cell c{origin_.x + at % kTileCells, origin_.y + at / kTileCells};
        const std::optional<Vec2> point = ground.standPoint(c);
        if (!point) break;
        add(*point);
        if (back_[at] < 0) break;
        const Cell before{c.x + kOffsets[back_[at]].x, c.y + kOffsets[back_[at]].y};
        const std::optional<Vec2> other = ground.standPoint(before);
        const std::optional<Vec2> over = other ? ground.stepPoint(c, *point, before, *other) : other;
        if (over) add(*over);
        at = TileGrid::localOf(before);
    }
    add(start);
    std::reverse(corners.begin(), corners.end());
    skipCorners(ground, corners);
    const double length = pathLength(corners);
    corners.erase(corners.begin());
    if (!corners.empty()) corners.pop_back();
    return length;
}

}  // namespace muster
