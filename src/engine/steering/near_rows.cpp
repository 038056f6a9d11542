#include "engine/steering/near_rows.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

constexpr std::size_t kNearPerCharacter = 32;  // Reserved number of neighbours per character.

}  // namespace

void NearRows::build(const CrowdBodies& bodies, std::span<const Vec2> positions,
                     std::span<const NeighbourPair> pairs) {
    bodies_ = &bodies;
    positions_ = positions;
    first_.assign(positions.size() + 2, 0);
    for (const NeighbourPair pair : pairs) {
        ++first_[pair.low + 2];
        ++first_[pair.high + 2];
    }
    for (std::size_t i = 2; i < first_.size(); ++i) first_[i] += first_[i - 1];
    other_.reserve(kNearPerCharacter * positions.size());
    other_.resize(2 * pairs.size());
    for (const NeighbourPair pair : pairs) {
        other_[first_[pair.low + 1]++] = pair.high;
        other_[first_[pair.high + 1]++] = pair.low;
    }
    first_.pop_back();
}

Near NearRows::near(std::int32_t character, std::int32_t other) const {
    const std::int32_t low = std::min(character, other), high = std::max(character, other);
    const Vec2 between = bodies_->between(positions_[low], positions_[high]);
    const Vec2 towards = normalized(between, {1.0, 0.0});
    const double gap = length(between) - bodies_->touching(low, high);
    return {other, character == low ? towards : -towards, gap};
}

}  // namespace muster
