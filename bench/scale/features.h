// Features in the middle of a scene: blocks, walls, trees and patches.
#pragma once

#include <cstdint>
#include <string>

#include "muster/world.h"

namespace muster::scale {

/// Half extents of a scene's feature, which is centred on the origin.
struct FeatureSize {
    double halfLength = 0.0;  ///< Half extent along x [m].
    double halfWidth = 0.0;   ///< Half extent along y [m]; walls go on to the edge of the box.
};

/// Size of the feature of that scene for a formation of that side [m].
FeatureSize featureSize(const std::string& scene, double side);

/// Adds the feature's obstacles and patches to a world whose box is set. `seed` places the trees.
void addFeature(const std::string& scene, double side, std::uint64_t seed, WorldDef& world);

}  // namespace muster::scale
