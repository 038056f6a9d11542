// The scene "city": streets of a real city.
#pragma once

#include "scale/crowd_scenes.h"

namespace muster::scale {

/// Fills the world, course and crowd of the scene "city": a part of the map Berlin_0_256 of `def.maps`,
/// scaled so that its streets suit the crowd. Fails with NotFound where the map is missing.
Status makeCity(const SceneDef& def, Scene& scene);

}  // namespace muster::scale
