#include "engine/fields/cost/density.h"

#include <algorithm>
#include <array>
#include <bit>

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
    touched_.assign((count + 63) / 64, 0);
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
        const auto cell = static_cast<std::uint32_t>(cells[k]);
        density_[cell] += share;
        touched_[cell / 64] |= std::uint64_t{1} << (cell % 64);
        velocityX_[cell] += share * vx;
        velocityY_[cell] += share * vy;
    }
}

void DensityField::splat(std::span<const Vec2> positions, std::span<const Vec2> velocities) {
    MUSTER_ASSERT(positions.size() == velocities.size());
    for (const std::int32_t cell : occupied_) {
        density_[cell] = 0.0f;
        velocityX_[cell] = 0.0f;
        velocityY_[cell] = 0.0f;
    }
    const Box box = grid_.box();  // Positions in it are finite.
    for (std::size_t k = 0; k < positions.size(); ++k)
        if (box.contains(positions[k]) && isFinite(velocities[k]))
            add(splatStencil(positions[k]), velocities[k]);
    listOccupied();
    for (const std::int32_t cell : occupied_) {
        velocityX_[cell] /= density_[cell];
        velocityY_[cell] /= density_[cell];
    }
}

// Lists the occupied cells in ascending order.
void DensityField::listOccupied() {
    occupied_.clear();
    for (std::size_t word = 0; word < touched_.size(); ++word) {
        for (std::uint64_t bits = touched_[word]; bits != 0; bits &= bits - 1)
            occupied_.push_back(static_cast<std::int32_t>(64 * word) + std::countr_zero(bits));
        touched_[word] = 0;
    }
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
