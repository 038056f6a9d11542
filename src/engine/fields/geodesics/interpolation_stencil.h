// Interpolation of squared costs between landmarks: on uniform ground the squared distance is a quadratic of
// known curvature, so that affine weights and a constant reproduce it exactly.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "base/grid.h"
#include "muster/vec2.h"

namespace muster {

/// The free corners of the square of landmarks round a place.
struct LandmarkSquare {
    std::int32_t cell[4];  ///< Landmarks: cells of the ground's grid.
    std::int32_t count;    ///< Number of them, 0 to 4.
    bool complete;         ///< True where all four are there and none was moved off its corner.
};

/// A landmark with a solved field.
struct Landmark {
    std::int32_t slot = 0;  ///< Slot of its field in the cache.
    Vec2 position;          ///< Position of the landmark [m].
    double cost = 0.0;      ///< Cost from the landmark to the place [m].
};

/// The squared cost to a place as a weighted sum of the squared costs to landmarks.
struct InterpolationStencil {
    std::int32_t count = 0;                 ///< Number of landmarks, 0 to 4; 0 where the cost is unknown.
    std::array<std::int32_t, 4> slot = {};  ///< Slots of their fields in the cache.
    std::array<float, 4> weight = {};  ///< Weights with the sum 1; 0 for landmarks that only bound the cost.
    std::int32_t nearest = 0;          ///< Slot of the landmark of the greatest weight.
    float offset = 0.0f;  ///< Value added to the weighted sum, which is then exact on uniform ground [m^2].
    std::array<float, 4> toPlace = {};  ///< Cost from each landmark to the place [m].
    float slowUnitCost = 0.0f;          ///< Unit cost at the place where that is slow ground, else 0.

    /// Adds a landmark of weight 0, which only bounds the cost.
    void addBound(const Landmark& landmark) {
        const std::int32_t k = count++;
        slot[k] = landmark.slot;
        weight[k] = 0.0f;
        toPlace[k] = static_cast<float>(landmark.cost);
    }

    /// Lets an archive read or write the stencil.
    template <class Archive>
    void visit(Archive& archive) {
        archive(count, slot, weight, nearest, offset, toPlace, slowUnitCost);
    }
};

/// Weights with sum 1 that put the landmarks' weighted mean on `place`: bilinear where the landmarks are the
/// corners of a complete square (lower left, lower right, upper left, upper right), else the weights of the
/// least sum of squares (ridge regression, so that landmarks almost in a line get small weights too).
/// `unitCost` is that round the place.
InterpolationStencil makeStencil(std::span<const Landmark> landmarks, bool completeSquare, Vec2 place,
                                 float unitCost);

/// The value that bilinear interpolation between cell centres adds to the squared cost at `p` on ground of
/// this unit cost [m^2]: s^2 C^2 (fx (1 - fx) + fy (1 - fy)) with cells of edge s.
double interpolationBias(const Grid& grid, Vec2 p, double unitCost);

}  // namespace muster
