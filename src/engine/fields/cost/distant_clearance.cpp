#include "engine/fields/cost/distant_clearance.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/ground/environment/environment.h"

namespace muster {
namespace {

// Clearance from which on a value is capped [m].
constexpr float kLeastCapped = static_cast<float>(Environment::kClearanceLimit) - 1e-4f;
// Difference between the distance of two blocks and the distance of their nearest points: at most the
// diagonal of a block, which holds the distances from cells to their centres too [blocks].
constexpr float kBlockDiagonal = 1.5f;

CellRect grown(const CellRect& rect, std::int32_t x, std::int32_t y, const Grid& grid) {
    const CellRect whole{{0, 0}, {grid.width - 1, grid.height - 1}};
    return whole.common({{rect.low.x - x, rect.low.y - y}, {rect.high.x + x, rect.high.y + y}});
}

}  // namespace

void DistantClearance::reset(const Grid& grid) {
    cells_ = grid;
    blocks_ = {grid.origin, kBlock * grid.cell, (grid.width + kBlock - 1) / kBlock,
               (grid.height + kBlock - 1) / kBlock};
    occupied_.assign(blocks_.count(), 0);
    alongRow_.assign(blocks_.count(), 0);
    beyond_.assign(blocks_.count(), 0.0f);
}

void DistantClearance::update(std::span<const float> clearance, const CellRect& area) {
    if (area.empty()) return;
    const CellRect changed{{area.low.x / kBlock, area.low.y / kBlock},
                           {area.high.x / kBlock, area.high.y / kBlock}};
    findOccupied(clearance, changed);
    transformRows(grown(changed, kReach, 0, blocks_));
    transformColumns(grown(changed, kReach, kReach, blocks_));
}

void DistantClearance::findOccupied(std::span<const float> clearance, const CellRect& blocks) {
    for (std::int32_t by = blocks.low.y; by <= blocks.high.y; ++by) {
        const std::int32_t top = std::min((by + 1) * kBlock, cells_.height);
        for (std::int32_t bx = blocks.low.x; bx <= blocks.high.x; ++bx) {
            const std::int32_t right = std::min((bx + 1) * kBlock, cells_.width);
            float least = kLeastCapped;
            for (std::int32_t y = by * kBlock; y < top; ++y) {
                const float* row = clearance.data() + cells_.index({0, y});
                for (std::int32_t x = bx * kBlock; x < right; ++x) least = std::min(least, row[x]);
            }
            occupied_[blocks_.index({bx, by})] = least < kLeastCapped ? 1 : 0;
        }
    }
}

void DistantClearance::transformRows(const CellRect& blocks) {
    for (std::int32_t y = blocks.low.y; y <= blocks.high.y; ++y) {
        const std::uint8_t* occupied = occupied_.data() + blocks_.index({0, y});
        std::uint8_t* out = alongRow_.data() + blocks_.index({0, y});
        // Two sweeps, which begin as far outside as a block can matter.
        std::int32_t since = kReach;
        for (std::int32_t x = std::max(0, blocks.low.x - kReach); x <= blocks.high.x; ++x) {
            since = occupied[x] != 0 ? 0 : std::min(since + 1, kReach);
            if (x >= blocks.low.x) out[x] = static_cast<std::uint8_t>(since);
        }
        since = kReach;
        for (std::int32_t x = std::min(blocks_.width - 1, blocks.high.x + kReach); x >= blocks.low.x; --x) {
            since = occupied[x] != 0 ? 0 : std::min(since + 1, kReach);
            if (x <= blocks.high.x) out[x] = static_cast<std::uint8_t>(std::min<std::int32_t>(out[x], since));
        }
    }
}

void DistantClearance::transformColumns(const CellRect& blocks) {
    std::array<float, kReach * kReach + 1> metres;
    for (std::size_t k = 0; k < metres.size(); ++k)
        metres[k] = std::max(0.0f, std::sqrt(static_cast<float>(k)) - kBlockDiagonal) *
                    static_cast<float>(blocks_.cell);
    for (std::int32_t y = blocks.low.y; y <= blocks.high.y; ++y)
        for (std::int32_t x = blocks.low.x; x <= blocks.high.x; ++x) {
            const std::uint8_t* here = alongRow_.data() + blocks_.index({x, y});
            std::int32_t least = here[0] * here[0];
            for (std::int32_t k = 1; k * k < least; ++k) {
                const std::ptrdiff_t step = static_cast<std::ptrdiff_t>(k) * blocks_.width;
                if (y + k < blocks_.height) least = std::min(least, here[step] * here[step] + k * k);
                if (y - k >= 0) least = std::min(least, here[-step] * here[-step] + k * k);
            }
            beyond_[blocks_.index({x, y})] = metres[std::min(least, kReach * kReach)];
        }
}

}  // namespace muster
