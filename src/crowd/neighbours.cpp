#include "crowd/neighbours.h"

namespace muster {

void NeighbourGrid::findPairs(std::span<const Vec2> positions, double reach, std::vector<NearPair>& pairs) {
    pairs.clear();
    if (positions.size() < 2) return;
    cells_.sort(positions, reach);
    cells_.forPairs(reach, [&](std::int32_t i, std::int32_t j) { pairs.push_back({i, j}); });
}

}  // namespace muster
