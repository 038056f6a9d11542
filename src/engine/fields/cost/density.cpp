#include "engine/fields/cost/density.h"

#include <algorithm>
#include <array>
#include <limits>

#include "base/bilinear.h"
#include "base/maths.h"
#include "muster/assert.h"

namespace muster {
namespace {

using Shares = std::array<double, 4>;

Shares raised(Shares shares, double exponent) {
    for (double& share : shares) share = power(share, exponent);
    return shares;
}

}  // namespace

DensityField::DensityField(const Box& box, const Parameters::Density& def)
    : def_(def), grid_(Grid::covering(box, def.cell)) {
    MUSTER_ASSERT(def.cell > 0.0 && def.lambda > 0.0);
    const std::int32_t count = grid_.count();
    density_.assign(count, 0.0f);
    velocityX_.assign(count, 0.0f);
    velocityY_.assign(count, 0.0f);
    occupied_.reserve(count);
}

inline DensityField::SplatStencil DensityField::splatStencil(Vec2 position) const {
    const double u = (position.x - grid_.origin.x) / grid_.cell - 0.5;
    const double v = (position.y - grid_.origin.y) / grid_.cell - 0.5;
    // The floor of u and v, which are at least -0.5, without a call of std::floor().
    const std::int32_t left = static_cast<std::int32_t>(u + 1.0) - 1;
    const std::int32_t low = static_cast<std::int32_t>(v + 1.0) - 1;
    return {{left, low}, u - left, v - low};
}

// Lower left, lower right, upper right, upper left; beyond the edge the nearest cell.
inline std::array<std::int32_t, 4> DensityField::cellsOf(Cell lowerLeft) const {
    const std::int32_t left = std::max(lowerLeft.x, 0), right = std::min(lowerLeft.x + 1, grid_.width - 1);
    const std::int32_t low = std::max(lowerLeft.y, 0) * grid_.width;
    const std::int32_t high = std::min(lowerLeft.y + 1, grid_.height - 1) * grid_.width;
    return {low + left, low + right, high + right, high + left};
}

inline void DensityField::add(const SplatStencil& stencil, Vec2 velocity) {
    const auto [low, dx, dy] = stencil;
    Shares shares{std::min(1 - dx, 1 - dy), std::min(dx, 1 - dy), std::min(dx, dy), std::min(1 - dx, dy)};
    if (def_.lambda != 1.0) shares = raised(shares, def_.lambda);
    const double scale = 1.0 / ((shares[0] + shares[1] + shares[2] + shares[3]) * grid_.cell * grid_.cell);
    const auto vx = static_cast<float>(velocity.x), vy = static_cast<float>(velocity.y);
    const std::array<std::int32_t, 4> cells = cellsOf(low);
    for (std::size_t k = 0; k < 4; ++k) {
        const auto share = static_cast<float>(shares[k] * scale);
        if (!(share > 0.0f)) continue;
        // These hold the momentum until splat() divides it by the density.
        density_[cells[k]] += share;
        velocityX_[cells[k]] += share * vx;
        velocityY_[cells[k]] += share * vy;
    }
}

void DensityField::splat(std::span<const Vec2> positions, std::span<const Vec2> velocities) {
    MUSTER_ASSERT(positions.size() == velocities.size());
    for (const std::int32_t cell : occupied_) {
        density_[cell] = 0.0f;
        velocityX_[cell] = 0.0f;
        velocityY_[cell] = 0.0f;
    }
    constexpr std::int32_t kFar = std::numeric_limits<std::int32_t>::max();
    const Box box = grid_.box();  // Positions in it are finite.
    Cell first{kFar, kFar};
    Cell last{-1, -1};
    for (std::size_t k = 0; k < positions.size(); ++k) {
        if (!box.contains(positions[k]) || !isFinite(velocities[k])) continue;
        const SplatStencil stencil = splatStencil(positions[k]);
        first = {std::min(first.x, stencil.low.x), std::min(first.y, stencil.low.y)};
        last = {std::max(last.x, stencil.low.x), std::max(last.y, stencil.low.y)};
        add(stencil, velocities[k]);
    }
    listOccupied(first, last, positions);
    for (const std::int32_t cell : occupied_) {
        velocityX_[cell] /= density_[cell];
        velocityY_[cell] /= density_[cell];
    }
}

// Lists the occupied cells in ascending order: by scanning the bounding rectangle of all stencils, or by
// sorting where that rectangle is much larger than the crowd.
void DensityField::listOccupied(Cell first, Cell last, std::span<const Vec2> positions) {
    occupied_.clear();
    if (first.x > last.x) return;  // No character was splatted.
    const Cell low{std::max(first.x, 0), std::max(first.y, 0)};
    const Cell high{std::min(last.x + 1, grid_.width - 1), std::min(last.y + 1, grid_.height - 1)};
    const auto list = [&](std::int32_t cell) {
        if (density_[cell] > 0.0f) occupied_.push_back(cell);
    };
    if ((high.x - low.x + 1.0) * (high.y - low.y + 1.0) <= 16.0 * static_cast<double>(positions.size())) {
        for (std::int32_t y = low.y; y <= high.y; ++y)
            for (std::int32_t x = low.x; x <= high.x; ++x) list(grid_.index({x, y}));
        return;
    }
    const Box box = grid_.box();
    for (const Vec2 p : positions) {
        if (!box.contains(p)) continue;
        for (const std::int32_t cell : cellsOf(splatStencil(p).low)) list(cell);
    }
    std::sort(occupied_.begin(), occupied_.end());
    occupied_.erase(std::unique(occupied_.begin(), occupied_.end()), occupied_.end());
}

float DensityField::densityAt(Vec2 p) const {
    if (density_.empty() || !isFinite(p)) return 0.0f;
    const BilinearStencil stencil = bilinearStencil(grid_, p);
    double sum = 0.0;
    for (int k = 0; k < 4; ++k) sum += stencil.weight[k] * density_[stencil.cell[k]];
    return static_cast<float>(sum);
}

Vec2 DensityField::velocityAt(Vec2 p) const {
    if (density_.empty() || !isFinite(p)) return {};
    const BilinearStencil stencil = bilinearStencil(grid_, p);
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
