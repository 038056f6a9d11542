// The free ground as a hierarchy (HPA*: Botea, Müller and Schaeffer 2004): tiles of cells, their connected
// components, and the regions that crossings between tiles join.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "engine/ground/routes/route_ground.h"
#include "engine/ground/routes/tile_components.h"
#include "engine/ground/routes/tile_detail.h"
#include "engine/ground/routes/tile_grid.h"
#include "engine/ground/routes/tile_regions.h"

namespace muster {

/// A point of the graph at which a disc at a point of the world enters it.
struct RouteAnchor {
    Cell cell;                    ///< A cell of a component.
    Vec2 point;                   ///< The cell's stand point [m].
    std::int32_t tile = 0;        ///< Its tile.
    std::int32_t component = -1;  ///< Its component in the tile.
};

/// The ground where discs of one radius can walk, moving obstacles left aside. A cache: it follows from the
/// ground alone, so that no answer depends on earlier questions. Const queries may come from several threads.
class RouteGraph : public TileSource {
public:
    RouteGraph();  ///< A graph of no ground; queries need an update() first.
    ~RouteGraph() override;
    RouteGraph(RouteGraph&&) noexcept;  ///< Moves the graph.
    RouteGraph& operator=(RouteGraph&&) noexcept;

    /// Takes over the environment, which must outlive the graph or the next update, and a radius [m]. Only
    /// tiles whose ground has changed are examined again.
    void update(const Environment& environment, double radius);

    /// The environment of the last update.
    const Environment& environment() const { return ground_.environment(); }
    const RouteGround& ground() const { return ground_; }  ///< The static ground.
    const TileGrid& tiles() const { return tiles_; }       ///< The tiles.
    /// The components of a tile.
    const TileComponents& components(std::int32_t tile) const { return components_[tile]; }
    double radius() const { return radius_; }  ///< The radius of the last update [m].
    /// Differs after every update that changed an answer.
    std::uint64_t version() const { return version_; }

    /// The region in which a disc at `p` stands, from 0; -1 where it is blocked. Two points have one region
    /// exactly where a route leads from one to the other. Numbers hold until the ground changes.
    std::int32_t region(Vec2 p) const;
    /// The region of a component of a tile.
    std::int32_t regionOf(std::int32_t tile, std::int32_t component) const {
        return regions_.of(tile, component);
    }
    std::int32_t regionCount() const { return regions_.count(); }  ///< Number of regions.
    /// True where a route leads from `a` to `b`.
    bool reachable(Vec2 a, Vec2 b) const;
    /// `p` itself where it lies in the region (in any, where that is -1); else the stand point of the
    /// region's cell that is nearest to `p`; `p` where the region has none. The cost grows with the distance.
    Vec2 nearestReachable(Vec2 p, std::int32_t region) const;
    /// The point at which a disc at `p` enters the graph: the cell of `p` or a neighbour to whose point the
    /// line is clear; where `p` is blocked, the nearest of these cells. None where there is no such cell.
    std::optional<RouteAnchor> anchor(Vec2 p) const;

    BorderTile borderTile(std::int32_t tile) const override {
        return {tiles_.cellsOf(tile), &components_[tile]};
    }
    /// The joints of a tile with its neighbours in the first four directions.
    std::span<const TileJoint> joints(std::int32_t tile) const { return joints_[tile]; }
    /// The crossings of a tile, found when they are first asked for and kept until the ground near by
    /// changes. The reference holds until trim() or update().
    TileDetail& detail(std::int32_t tile);
    /// Forgets all crossings where there are very many. Changes no answer.
    void trim();

    /// Approximate number of bytes that the graph occupies.
    std::int64_t memory() const;

private:
    void labelTiles(const CellRect& tiles);
    void joinTiles(const CellRect& tiles);
    void joinRegions();
    void forgetDetails(const CellRect& tiles);
    void reserveDetails();

    RouteGround ground_;
    double radius_ = -1.0;
    std::uint64_t instance_ = 0, staticVersion_ = 0;
    std::uint64_t version_ = 0;
    TileGrid tiles_;
    std::vector<TileComponents> components_;      // Components per tile.
    std::vector<std::vector<TileJoint>> joints_;  // Joints per tile, in the first four directions.
    TileRegions regions_;
    std::vector<std::unique_ptr<TileDetail>> details_;  // Details per tile; null until asked for.
    std::int32_t detailCount_ = 0;
    std::vector<std::unique_ptr<TileDetail>> spareDetails_;  // Memory of details to come.

    // Working memory.
    std::unique_ptr<TileLabeller> labeller_;
    std::vector<BorderCrossing> crossings_;
};

}  // namespace muster
