// The static facts of a world as JSON, for the page.
#pragma once

#include <string>

#include "muster/world.h"

namespace muster {

/// The JSON of a Scene message (docs/protocol.md). `name` is the scenario's file name, `def` gives title,
/// description and credit, and the world gives everything that may have changed. `demonstration` is true
/// where the scenario carries touches that can be watched.
std::string buildSceneJson(const std::string& name, const WorldDef& def, const World& world,
                           bool demonstration);
/// A hash of the scene; it differs where the scene has to be sent again.
std::uint64_t sceneSignature(const World& world);

}  // namespace muster
