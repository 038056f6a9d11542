// Density and average velocity of the crowd (SPEC A4; Treuille, Cooper and Popovic 2006, section 4.1).
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Density [characters per m^2] and average velocity of the crowd on a grid of its own.
class DensityField {
public:
    DensityField() = default;  ///< An empty field.
    /// An empty field over `box`.
    DensityField(const Box& box, const Parameters::Density& def);

    /// Replaces the contents by these characters. Each gives the four cells around it shares in the
    /// proportion min(1-dx,1-dy)^l : min(dx,1-dy)^l : min(dx,dy)^l : min(1-dx,dy)^l, with l = lambda, that
    /// add up to one character. At the edge of the box the share of a missing cell goes to its neighbour.
    /// Characters outside the box, and positions or velocities that are not finite, are left out.
    void splat(std::span<const Vec2> positions, std::span<const Vec2> velocities);

    const Grid& grid() const { return grid_; }                      ///< The cells of the density.
    const std::vector<float>& density() const { return density_; }  ///< Density per cell [1/m^2].
    /// Average velocity along x, per cell [m/s]; 0 where the density is 0.
    const std::vector<float>& velocityX() const { return velocityX_; }
    /// Average velocity along y, per cell [m/s]; 0 where the density is 0.
    const std::vector<float>& velocityY() const { return velocityY_; }
    /// Cells with density above zero, ascending.
    const std::vector<std::int32_t>& occupied() const { return occupied_; }
    /// Density at `p`, bilinear [1/m^2].
    float densityAt(Vec2 p) const;
    /// Average velocity at `p`: bilinear momentum over bilinear density [m/s].
    Vec2 velocityAt(Vec2 p) const;

private:
    // The four cells that a character is splatted to. Unlike a bilinear stencil it reaches beyond the edge of
    // the grid, where cells stand for their missing neighbours, so that the whole character counts.
    struct SplatStencil {
        Cell low;   // The lower left cell; may have column or row -1.
        double dx;  // Distance from the centre of that cell along x [cells], 0 to 1.
        double dy;  // Distance from the centre of that cell along y [cells], 0 to 1.
    };
    SplatStencil splatStencil(Vec2 position) const;
    std::array<std::int32_t, 4> cellsOf(Cell lowerLeft) const;
    void add(const SplatStencil& stencil, Vec2 velocity);
    void listOccupied();

    Parameters::Density def_;
    Grid grid_;
    std::vector<float> density_;
    std::vector<float> velocityX_;
    std::vector<float> velocityY_;
    std::vector<std::int32_t> occupied_;
    std::vector<std::uint64_t> touched_;  // A bit per cell, set if it has got a share since it was listed.
};

}  // namespace muster
