#include "muster/fields/density.h"

#include <algorithm>
#include <array>
#include <limits>

#include "muster/base/assert.h"
#include "muster/base/maths.h"

namespace muster {
namespace {

using Shares = std::array<double, 4>;

Shares raised(Shares shares, double exponent) {
    for (double& share : shares) share = power(share, exponent);
    return shares;
}

}  // namespace

DensityField::DensityField(const Box& box, const DensityDef& def) : def_(def), grid_(Grid::covering(box, def.cell)) {
    MUSTER_ASSERT(def.cell > 0.0 && def.lambda > 0.0);
    const auto count = static_cast<std::size_t>(grid_.count());
    density_.assign(count, 0.0f);
    velocityX_.assign(count, 0.0f);
    velocityY_.assign(count, 0.0f);
    occupied_.reserve(count);
}

inline DensityField::Stencil DensityField::stencilOf(Vec2 position) const {
    const double u = (position.x - grid_.origin.x) / grid_.cell - 0.5;
    const double v = (position.y - grid_.origin.y) / grid_.cell - 0.5;
    // As floor(), which is a call; u and v are at least -0.5.
    const std::int32_t left = static_cast<std::int32_t>(u + 1.0) - 1;
    const std::int32_t low = static_cast<std::int32_t>(v + 1.0) - 1;
    return {{left, low}, u - left, v - low};
}

inline void DensityField::add(const Stencil& stencil, Vec2 velocity) {
    const auto [cell, dx, dy] = stencil;
    Shares shares{std::min(1 - dx, 1 - dy), std::min(dx, 1 - dy), std::min(dx, dy), std::min(1 - dx, dy)};
    if (def_.lambda != 1.0) shares = raised(shares, def_.lambda);
    const double scale = 1.0 / ((shares[0] + shares[1] + shares[2] + shares[3]) * grid_.cell * grid_.cell);
    const auto vx = static_cast<float>(velocity.x), vy = static_cast<float>(velocity.y);
    const auto give = [&](std::int32_t index, double part) {
        const auto share = static_cast<float>(part * scale);
        if (!(share > 0.0f)) return;
        if (!(density_[index] > 0.0f)) occupied_.push_back(index);
        // Momentum until splat() divides it by the density.
        density_[index] += share;
        velocityX_[index] += share * vx;
        velocityY_[index] += share * vy;
    };
    // At the rim the neighbour takes the share of a missing cell.
    const std::int32_t left = std::max(cell.x, 0), right = std::min(cell.x + 1, grid_.width - 1);
    const std::int32_t low = std::max(cell.y, 0) * grid_.width;
    const std::int32_t high = std::min(cell.y + 1, grid_.height - 1) * grid_.width;
    give(low + left, shares[0]);
    give(low + right, shares[1]);
    give(high + right, shares[2]);
    give(high + left, shares[3]);
}

void DensityField::splat(std::span<const Vec2> positions, std::span<const Vec2> velocities) {
    MUSTER_ASSERT(positions.size() == velocities.size());
    for (const std::int32_t cell : occupied_) {
        density_[cell] = 0.0f;
        velocityX_[cell] = 0.0f;
        velocityY_[cell] = 0.0f;
    }
    occupied_.clear();
    const Box box = grid_.box();  // What lies in it is finite.
    constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
    Cell first{kFar, kFar};
    Cell last{-1, -1};
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (!box.contains(positions[k]) || !isFinite(velocities[k])) continue;
        const Stencil stencil = stencilOf(positions[k]);
        first = {std::min(first.x, stencil.cell.x), std::min(first.y, stencil.cell.y)};
        last = {std::max(last.x, stencil.cell.x), std::max(last.y, stencil.cell.y)};
        add(stencil, velocities[k]);
    }
    sortOccupied(first, last);
    for (const std::int32_t cell : occupied_) {
        velocityX_[cell] /= density_[cell];
        velocityY_[cell] /= density_[cell];
    }
}

// Listing all cells between the first and the last stencil in order is faster than sorting, unless they lie far apart.
void DensityField::sortOccupied(Cell first, Cell last) {
    if (occupied_.empty()) return;
    const Cell low{std::max(first.x, 0), std::max(first.y, 0)};
    const Cell high{std::min(last.x + 1, grid_.width - 1), std::min(last.y + 1, grid_.height - 1)};
    const double box = (high.x - low.x + 1.0) * (high.y - low.y + 1.0);
    if (box > 16.0 * static_cast<double>(occupied_.size())) {
        std::sort(occupied_.begin(), occupied_.end());
        return;
    }
    occupied_.clear();
    for (std::int32_t y = low.y; y <= high.y; ++y)
        for (std::int32_t x = low.x; x <= high.x; ++x)
            if (density_[grid_.index({x, y})] > 0.0f) occupied_.push_back(grid_.index({x, y}));
}

float DensityField::densityAt(Vec2 p) const {
    if (density_.empty() || !isFinite(p)) return 0.0f;
    const BilinearStencil stencil = grid_.bilinear(p);
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += stencil.weight[k] * density_[stencil.cell[k]];
    return static_cast<float>(sum);
}

Vec2 DensityField::velocityAt(Vec2 p) const {
    if (density_.empty() || !isFinite(p)) return {};
    const BilinearStencil stencil = grid_.bilinear(p);
    double mass = 0.0;
    Vec2 momentum;
    for (int k = 0; k < 4; ++k) {
        const std::int32_t cell = stencil.cell[k];
        const double share = stencil.weight[k] * density_[cell];
        mass += share;
        momentum += Vec2{velocityX_[cell], velocityY_[cell]} * share;
    }
    return mass > 0.0 ? momentum / mass : Vec2{};
}

}  // namespace muster
