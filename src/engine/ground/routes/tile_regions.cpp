#include "engine/ground/routes/tile_regions.h"

#include <algorithm>

namespace muster {

void findJoints(const RouteGround& ground, const TileGrid& tiles, const TileSource& source, std::int32_t tile,
                std::int32_t direction, std::vector<BorderCrossing>& crossings,
                std::vector<TileJoint>& joints) {
    const std::int32_t other = tiles.neighbour(tile, direction);
    if (other < 0) return;
    const BorderTile a = source.borderTile(tile), b = source.borderTile(other);
    crossings.clear();
    if (a.components->open && b.components->open)
        crossings.push_back({});
    else
        findCrossings(ground, a, b, direction, crossings);
    for (const BorderCrossing& c : crossings) {
        const TileJoint joint{static_cast<std::uint8_t>(direction),
                              static_cast<std::uint16_t>(c.fromComponent),
                              static_cast<std::uint16_t>(c.toComponent)};
        if (std::find(joints.begin(), joints.end(), joint) == joints.end()) joints.push_back(joint);
    }
}

void TileRegions::start(std::int32_t components) {
    parent_.resize(components);
    for (std::int32_t k = 0; k < components; ++k) parent_[k] = k;
}

std::int32_t TileRegions::rootOf(std::int32_t k) {
    while (parent_[k] != k) k = parent_[k] = parent_[parent_[k]];
    return k;
}

void TileRegions::joinSets(std::int32_t a, std::int32_t b) {
    a = rootOf(a);
    b = rootOf(b);
    parent_[std::max(a, b)] = std::min(a, b);
}

void TileRegions::number() {
    region_.resize(parent_.size());
    count_ = 0;
    for (std::int32_t k = 0; k < static_cast<std::int32_t>(parent_.size()); ++k) {
        const std::int32_t root = rootOf(k);
        region_[k] = root == k ? count_++ : region_[root];
    }
}

}  // namespace muster
