#include "engine/steering/near_rows.h"

#include <cmath>

namespace muster {
namespace {

constexpr std::size_t kNearPerCharacter = 32;  // Room that is kept for them.

}  // namespace

void NearRows::build(const CrowdBodies& bodies, std::span<const Vec2> positions,
                     std::span<const NeighbourPair> pairs) {
    first_.assign(positions.size() + 2, 0);
    for (const NeighbourPair pair : pairs) {
        ++first_[pair.low + 2];
        ++first_[pair.high + 2];
    }
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    near_.reserve(kNearPerCharacter * positions.size());
    near_.resize(2 * pairs.size());
    for (const NeighbourPair pair : pairs) {
        const Vec2 between = positions[pair.high] - positions[pair.low];
        const Vec2 towards = normalized(between, {1.0, 0.0});
        const double gap = length(between) - bodies.touching(pair.low, pair.high);
        near_[first_[pair.low + 1]++] = {pair.high, towards, gap};
        near_[first_[pair.high + 1]++] = {pair.low, -towards, gap};
    }
    first_.pop_back();
}

}  // namespace muster
