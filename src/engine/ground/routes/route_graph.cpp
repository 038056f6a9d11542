#include "engine/ground/routes/route_graph.h"

#include <algorithm>
#include <limits>

#include "engine/ground/routes/nearest_cell.h"

namespace muster {
namespace {

constexpr std::int32_t kMostDetails = 4096;  // Greatest number of tiles whose crossings are kept.
// Number of tiles for whose crossings there is memory from the first.
constexpr std::int32_t kSpareDetails = 128;

}  // namespace

RouteGraph::RouteGraph() = default;
RouteGraph::~RouteGraph() = default;
RouteGraph::RouteGraph(RouteGraph&&) noexcept = default;
RouteGraph& RouteGraph::operator=(RouteGraph&&) noexcept = default;

void RouteGraph::update(const Environment& environment, double radius) {
    const bool same = instance_ == environment.instance() && radius_ == radius;
    // The environment may have moved in memory; its rasters too.
    ground_ = RouteGround(environment, radius);
    if (same && staticVersion_ == environment.staticVersion()) return;
    std::vector<CellRect> areas;
    const CellRect whole{{0, 0}, {environment.grid().width - 1, environment.grid().height - 1}};
    if (!same || !environment.staticChangesSince(staticVersion_, areas)) areas.assign(1, whole);
    if (!same) {
        tiles_ = TileGrid::over(environment.grid());
        components_.assign(tiles_.count(), {});
        joints_.assign(tiles_.count(), {});
        details_.clear();
        details_.resize(tiles_.count());
        detailCount_ = 0;
    }
    instance_ = environment.instance();
    staticVersion_ = environment.staticVersion();
    radius_ = radius;
    ++version_;
    if (labeller_ == nullptr) labeller_ = std::make_unique<TileLabeller>();
    for (const CellRect& area : areas) labelTiles(tiles_.tilesOf(area));
    for (const CellRect& area : areas) {
        // Joints are kept by the tile to the left and below.
        const CellRect rect = tiles_.tilesOf(area);
        const CellRect all{{0, 0}, {tiles_.width - 1, tiles_.height - 1}};
        if (rect.empty()) continue;
        joinTiles(CellRect{{rect.low.x - 1, rect.low.y - 1}, {rect.high.x + 1, rect.high.y}}.common(all));
        forgetDetails(
            CellRect{{rect.low.x - 1, rect.low.y - 1}, {rect.high.x + 1, rect.high.y + 1}}.common(all));
    }
    joinRegions();
    labeller_.reset();
    reserveDetails();
}

// Reserves memory, so that searches allocate nothing until they have seen very many tiles.
void RouteGraph::reserveDetails() {
    crossings_.reserve(kTileArea);
    spareDetails_.reserve(kSpareDetails);
    const std::int32_t most = std::min(kSpareDetails, tiles_.count());
    while (detailCount_ + static_cast<std::int32_t>(spareDetails_.size()) < most) {
        spareDetails_.push_back(std::make_unique<TileDetail>());
        spareDetails_.back()->reserve();
    }
}

TileDetail& RouteGraph::detail(std::int32_t tile) {
    std::unique_ptr<TileDetail>& detail = details_[tile];
    if (detail == nullptr) {
        if (spareDetails_.empty()) {
            detail = std::make_unique<TileDetail>();
        } else {
            detail = std::move(spareDetails_.back());
            spareDetails_.pop_back();
        }
        describeTile(ground_, tiles_, tile, *this, crossings_, *detail);
        ++detailCount_;
    }
    return *detail;
}

void RouteGraph::trim() {
    if (detailCount_ > kMostDetails) forgetDetails({{0, 0}, {tiles_.width - 1, tiles_.height - 1}});
}

void RouteGraph::forgetDetails(const CellRect& rect) {
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y)
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            std::unique_ptr<TileDetail>& detail = details_[y * tiles_.width + x];
            if (detail != nullptr) --detailCount_;
            detail.reset();
        }
}

void RouteGraph::labelTiles(const CellRect& rect) {
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y)
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            const std::int32_t tile = y * tiles_.width + x;
            labeller_->run(ground_, tiles_.cellsOf(tile), components_[tile]);
        }
}

void RouteGraph::joinTiles(const CellRect& rect) {
    for (std::int32_t y = rect.low.y; y <= rect.high.y; ++y) {
        for (std::int32_t x = rect.low.x; x <= rect.high.x; ++x) {
            const std::int32_t tile = y * tiles_.width + x;
            joints_[tile].clear();
            for (std::int32_t d = 0; d < kDirections / 2; ++d)
                findJoints(ground_, tiles_, *this, tile, d, crossings_, joints_[tile]);
        }
    }
}

void RouteGraph::joinRegions() {
    regions_.join(
        tiles_, [&](std::int32_t tile) { return components_[tile].count; },
        [&](std::int32_t tile, const auto& visit) {
            for (const TileJoint& joint : joints_[tile]) visit(joint);
        });
}

std::optional<RouteAnchor> RouteGraph::anchor(Vec2 p) const {
    return anchorOf(ground_, p, [&](Cell c, std::int32_t& tile) {
        tile = tiles_.tileOf(c);
        return components_[tile].at(TileGrid::localOf(c));
    });
}

std::int32_t RouteGraph::region(Vec2 p) const {
    const Grid& grid = tiles_.cells;
    const Cell c = grid.cellOf(p);
    if (!grid.contains(c)) return -1;
    const std::int32_t tile = tiles_.tileOf(c);
    const TileComponents& components = components_[tile];
    if (components.open) return regionOf(tile, 0);
    const std::int32_t label = components.at(TileGrid::localOf(c));
    // In an undivided tile the cell's component is that of the point.
    if (label >= 0 && components.count == 1) return regionOf(tile, 0);
    const std::optional<RouteAnchor> found = anchor(p);
    return found ? regionOf(found->tile, found->component) : -1;
}

bool RouteGraph::reachable(Vec2 a, Vec2 b) const {
    const std::int32_t region = this->region(a);
    return region >= 0 && region == this->region(b);
}

std::int64_t RouteGraph::memory() const {
    std::size_t bytes = components_.size() * (sizeof(TileComponents) + sizeof(std::vector<TileJoint>)) +
                        regions_.memory();
    for (const TileComponents& tile : components_) bytes += 4 * tile.rows.size() + 2 * tile.labels.size();
    for (const std::vector<TileJoint>& joints : joints_) bytes += joints.size() * sizeof(TileJoint);
    return static_cast<std::int64_t>(bytes);
}

}  // namespace muster
