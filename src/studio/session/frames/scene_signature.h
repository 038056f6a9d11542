// Tells whether a scene has to be sent again.
#pragma once

#include <cstdint>

#include "muster/world.h"

namespace muster {

/// A hash of the scene; it differs where the scene has to be sent again.
std::uint64_t sceneSignature(const World& world);

}  // namespace muster
