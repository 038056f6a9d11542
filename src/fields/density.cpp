#include "muster/fields/density.h"

#include <algorithm>

#include "muster/base/assert.h"
#include "muster/base/maths.h"

namespace muster {

DensityField::DensityField(const Box& box, const DensityDef& def) : def_(def), grid_(Grid::covering(box, def.cell)) {
    MUSTER_ASSERT(def.cell > 0.0 && def.lambda > 0.0);
    const auto count = static_cast<std::size_t>(grid_.count());
    density_.assign(count, 0.0f);
    velocityX_.assign(count, 0.0f);
    velocityY_.assign(count, 0.0f);
    occupied_.reserve(count);
}

void DensityField::splat(std::span<const Vec2> positions, std::span<const Vec2> velocities) {
    MUSTER_ASSERT(positions.size() == velocities.size());
    for (const std::int32_t cell : occupied_) {
        density_[cell] = 0.0f;
        velocityX_[cell] = 0.0f;
        velocityY_[cell] = 0.0f;
    }
    occupied_.clear();
    const Box box = grid_.box();
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (isFinite(positions[k]) && isFinite(velocities[k]) && box.contains(positions[k])) {
            add(positions[k], velocities[k]);
        }
    }
    sortOccupied();
    for (const std::int32_t cell : occupied_) {
        velocityX_[cell] /= density_[cell];
        velocityY_[cell] /= density_[cell];
    }
}

// Listing the cells of their box in order is faster than sorting, unless they lie far apart.
void DensityField::sortOccupied() {
    if (occupied_.empty()) return;
    Cell low = grid_.at(occupied_[0]);
    Cell high = low;
    for (const std::int32_t index : occupied_) {
        const Cell c = grid_.at(index);
        low = {std::min(low.x, c.x), std::min(low.y, c.y)};
        high = {std::max(high.x, c.x), std::max(high.y, c.y)};
    }
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

void DensityField::add(Vec2 position, Vec2 velocity) {
    const double u = (position.x - grid_.origin.x) / grid_.cell - 0.5;
    const double v = (position.y - grid_.origin.y) / grid_.cell - 0.5;
    // As floor(), which is a call; u and v are at least -0.5.
    const std::int32_t left = static_cast<std::int32_t>(u + 1.0) - 1;
    const std::int32_t low = static_cast<std::int32_t>(v + 1.0) - 1;
    const double dx = u - left;
    const double dy = v - low;
    double shares[4] = {std::min(1 - dx, 1 - dy), std::min(dx, 1 - dy), std::min(dx, dy), std::min(1 - dx, dy)};
    if (def_.lambda != 1.0)
        for (double& share : shares) share = power(share, def_.lambda);
    const double scale = 1.0 / ((shares[0] + shares[1] + shares[2] + shares[3]) * grid_.cell * grid_.cell);
    constexpr std::int32_t kRight[4] = {0, 1, 1, 0};
    constexpr std::int32_t kUp[4] = {0, 0, 1, 1};
    for (int k = 0; k < 4; ++k) {
        const auto share = static_cast<float>(shares[k] * scale);
        if (!(share > 0.0f)) continue;
        const Cell cell{std::clamp(left + kRight[k], 0, grid_.width - 1),
                        std::clamp(low + kUp[k], 0, grid_.height - 1)};
        const std::int32_t index = grid_.index(cell);
        if (density_[index] == 0.0f) occupied_.push_back(index);
        // Momentum until splat() divides it by the density.
        density_[index] += share;
        velocityX_[index] += share * static_cast<float>(velocity.x);
        velocityY_[index] += share * static_cast<float>(velocity.y);
    }
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
