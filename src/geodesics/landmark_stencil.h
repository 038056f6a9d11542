// How the squared cost to a place follows from those to landmarks round it.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "muster/vec2.h"

namespace muster {

/// A landmark that may take part.
struct Landmark {
    std::int32_t slot = 0;  ///< Of its field.
    Vec2 at;                ///< [m]
    double cost = 0.0;      ///< From it to the place.
};

/// Fields and their weights.
struct LandmarkStencil {
    std::int32_t count = 0;  ///< 0 where nothing is known.
    std::array<std::int32_t, 4> slot = {};
    std::array<float, 4> weight = {};
    std::int32_t nearest = 0;       ///< Slot of the field whose landmark weighs most.
    float shift = 0.0f;             ///< Added to the weighted sum of squares: exact on uniform ground.
    std::array<float, 4> own = {};  ///< Cost from each landmark to the place.
    float unit = 0.0f;              ///< Cost of a metre at the place where that is slow ground, else 0.

    /// Takes up one more landmark, which has no weight.
    void addBound(const Landmark& landmark) {
        const auto k = static_cast<std::size_t>(count++);
        slot[k] = landmark.slot;
        weight[k] = 0.0f;
        own[k] = static_cast<float>(landmark.cost);
    }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(count, slot, weight, nearest, shift, own, unit);
    }
};

/// Weights that add up to 1 and put the landmarks' weighted mean on `place`: bilinear where `square` says
/// that the four are the corners of a square (lower left, lower right, upper left, upper right), else the
/// smallest such weights; landmarks that lie in a line or alone put it as near as they can. `unit` is the
/// cost of a metre round the place.
LandmarkStencil weighLandmarks(std::span<const Landmark> landmarks, bool square, Vec2 place, float unit);

}  // namespace muster
