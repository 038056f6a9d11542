// Regions: the components of tiles that crossings between neighbouring tiles join.
#pragma once

#include <cstdint>
#include <vector>

#include "engine/ground/routes/tile_detail.h"

namespace muster {

/// A joint of a component of a tile with one of a neighbour.
struct TileJoint {
    std::uint8_t direction = 0;  ///< Direction to the neighbour; one of the first four.
    std::uint16_t from = 0;      ///< Component of the tile.
    std::uint16_t to = 0;        ///< Component of the neighbour.
    /// Equal in all parts.
    friend bool operator==(const TileJoint&, const TileJoint&) = default;
};

/// Appends the joints of a tile with its neighbour in one of the first four directions. `crossings` is
/// working memory.
void findJoints(const RouteGround& ground, const TileGrid& tiles, const TileSource& source, std::int32_t tile,
                std::int32_t direction, std::vector<BorderCrossing>& crossings,
                std::vector<TileJoint>& joints);

/// The region of each component of each tile. Regions are numbered in the order of their first components,
/// so that the numbers depend on components and joints alone.
class TileRegions {
public:
    /// Joins the components of all tiles: `countOf(tile)` of them, by the joints that
    /// `forJoints(tile, visit)` visits.
    template <class CountOf, class ForJoints>
    void join(const TileGrid& tiles, const CountOf& countOf, const ForJoints& forJoints) {
        first_.resize(tiles.count());
        std::int32_t count = 0;
        for (std::int32_t tile = 0; tile < tiles.count(); ++tile) {
            first_[tile] = count;
            count += countOf(tile);
        }
        start(count);
        for (std::int32_t tile = 0; tile < tiles.count(); ++tile)
            forJoints(tile, [&](const TileJoint& joint) {
                const std::int32_t other = tiles.neighbour(tile, joint.direction);
                joinSets(first_[tile] + joint.from, first_[other] + joint.to);
            });
        number();
    }

    std::int32_t count() const { return count_; }  ///< Number of regions.
    /// The region of a component of a tile.
    std::int32_t of(std::int32_t tile, std::int32_t component) const {
        return region_[first_[tile] + component];
    }
    /// Bytes that the numbers occupy.
    std::size_t memory() const { return 4 * (first_.size() + region_.size() + parent_.size()); }

private:
    void start(std::int32_t components);
    std::int32_t rootOf(std::int32_t k);
    void joinSets(std::int32_t a, std::int32_t b);
    void number();

    std::vector<std::int32_t> first_;   // Per tile, index of its first component among all.
    std::vector<std::int32_t> region_;  // Region of each component.
    std::vector<std::int32_t> parent_;  // Per component: disjoint sets.
    std::int32_t count_ = 0;
};

}  // namespace muster
