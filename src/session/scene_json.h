// The static facts of a world, for the page.
#pragma once

#include <string>

#include "muster/world.h"

namespace muster {

/// The JSON of a Scene message (docs/protocol.md). `name` is the scenario's file name; `def` gives title,
/// description and credit, the world everything that may have changed; `demonstration`: there are touches to
/// watch.
std::string buildSceneJson(const std::string& name, const WorldDef& def, const World& world,
                           bool demonstration);
/// A number that differs where another scene would have to be sent.
std::uint64_t sceneSignature(const World& world);

}  // namespace muster
