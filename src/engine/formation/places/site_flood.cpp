#include "engine/formation/places/site_flood.h"

#include <cmath>
#include <utility>

namespace muster {
namespace {

// Distance of rows of points, in spacings; a little more than in a triangle.
constexpr double kRowShare = 0.87;
constexpr double kNarrowRoom = 0.5;  // Room below which centres of cells are points too [spacings].
static_assert(kTileCells == 32);     // A row of a tile is one word.

}  // namespace

void SiteFlood::begin(const RouteGraph& routes, std::int32_t region, double spacing) {
    routes_ = &routes;
    grid_ = routes.tiles().cells;
    region_ = region;
    spacing_ = spacing;
    seekers_.clear();
    rowsOfTile_.assign(routes.tiles().count(), -1);
    tiles_.clear();
    rows_.clear();
}

void SiteFlood::add(std::int32_t place, Vec2 p) {
    seekers_.push_back({grid_.index(grid_.nearestCell(p)), place});
}

void SiteFlood::sortSeekers() {
    first_ = seekers_;
    std::sort(seekers_.begin(), seekers_.end());
    met_.assign(seekers_.size(), 0);
}

bool SiteFlood::order(std::int32_t most, std::vector<std::int32_t>& places) {
    sortSeekers();
    places.clear();
    if (seekers_.empty() || !meetAll(first_.front().cell, most)) return seekers_.empty();
    const std::int32_t end = last_;
    met_.assign(seekers_.size(), 0);
    if (!meetAll(end, most)) return false;
    places = waiting_;
    return true;
}

// Floods until all places are met, over at most so many cells.
bool SiteFlood::meetAll(std::int32_t start, std::int32_t most) {
    forgetVisits();
    waiting_.clear();
    visit(start);
    for (std::size_t head = 0; head < queue_.size() && std::cmp_less(head, most); ++head) {
        last_ = queue_[head];
        meet(last_);
        // A place at a wall may lie in a cell whose centre is blocked.
        const Cell c = grid_.at(last_);
        for (const Cell step : kOffsets) {
            const Cell n{c.x + step.x, c.y + step.y};
            if (grid_.contains(n) && !inRegion(n)) meet(grid_.index(n));
        }
        if (waiting_.size() == seekers_.size()) return true;
        visitNeighbours(last_);
    }
    return false;
}

bool SiteFlood::inRegion(Cell c) const {
    const std::int32_t tile = routes_->tiles().tileOf(c);
    const std::int32_t component = routes_->components(tile).at(TileGrid::localOf(c));
    return component >= 0 && (region_ < 0 || routes_->regionOf(tile, component) == region_);
}

// Lets all places in this cell wait for points from now on.
void SiteFlood::meet(std::int32_t cell) {
    const auto before = [](const Seeker& seeker, std::int32_t c) { return seeker.cell < c; };
    for (auto at = std::lower_bound(seekers_.begin(), seekers_.end(), cell, before);
         at != seekers_.end() && at->cell == cell; ++at) {
        std::uint8_t& met = met_[at - seekers_.begin()];
        if (met == 0) waiting_.push_back(at->place);
        met = 1;
    }
}

// Lists the points of a triangular lattice in the cell, and its centre where it is so narrow that they may
// miss it.
void SiteFlood::listSites(std::int32_t cell) {
    sites_.clear();
    const Cell c = grid_.at(cell);
    const Vec2 low = grid_.origin + Vec2{c.x * grid_.cell, c.y * grid_.cell};
    const double height = kRowShare * spacing_;
    for (auto row = static_cast<std::int64_t>(std::ceil(low.y / height));; ++row) {
        const double y = static_cast<double>(row) * height;
        if (!(y < low.y + grid_.cell)) break;
        const double half = row % 2 != 0 ? 0.5 * spacing_ : 0.0;
        for (auto k = static_cast<std::int64_t>(std::ceil((low.x - half) / spacing_));; ++k) {
            const double x = static_cast<double>(k) * spacing_ + half;
            if (!(x < low.x + grid_.cell)) break;
            sites_.push_back({x, y});
        }
    }
    const double room = routes_->environment().staticClearance()[cell] - routes_->radius();
    if (room < kNarrowRoom * spacing_) sites_.push_back(grid_.centre(c));
}

void SiteFlood::visit(std::int32_t cell) {
    const Cell c = grid_.at(cell);
    const std::int32_t tile = routes_->tiles().tileOf(c);
    if (rowsOfTile_[tile] < 0) {
        rowsOfTile_[tile] = static_cast<std::int32_t>(rows_.size());
        tiles_.push_back(tile);
        rows_.resize(rows_.size() + kTileCells, 0);
    }
    std::uint32_t& row = rows_[rowsOfTile_[tile] + c.y % kTileCells];
    const std::uint32_t bit = 1u << (c.x % kTileCells);
    if ((row & bit) != 0) return;
    row |= bit;
    queue_.push_back(cell);
}

void SiteFlood::visitNeighbours(std::int32_t cell) {
    const Cell c = grid_.at(cell);
    for (const Cell step : kOffsets) {
        const Cell n{c.x + step.x, c.y + step.y};
        if (grid_.contains(n) && inRegion(n)) visit(grid_.index(n));
    }
}

void SiteFlood::forgetVisits() {
    for (const std::int32_t tile : tiles_) rowsOfTile_[tile] = -1;
    tiles_.clear();
    rows_.clear();
    queue_.clear();
}

}  // namespace muster
