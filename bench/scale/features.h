// What stands in the middle of a scene: blocks, walls, trees, patches.
#pragma once

#include <cstdint>
#include <string>

#include "muster/world_def.h"

namespace muster::scale {

/// How far a scene's feature reaches from the origin.
struct FeatureSize {
    double halfLength = 0.0;  ///< Along x [m].
    double halfWidth = 0.0;   ///< Along y [m]; walls go on to the edge of the box.
};

/// Of the feature of that scene for a formation of that side [m].
FeatureSize featureSize(const std::string& scene, double side);

/// Adds the feature's obstacles and patches to a world whose box is set; trees stand by `seed`.
void addFeature(const std::string& scene, double side, std::uint64_t seed, WorldDef& world);

}  // namespace muster::scale
