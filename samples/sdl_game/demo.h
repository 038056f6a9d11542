// A player for runs without one: clicks and keys by frame, which go the way of real ones.
#pragma once

#include <cstdint>

#include "camera.h"

namespace game {

/// Puts the events of this frame into SDL's queue.
void playDemo(std::int32_t frame, const Camera& camera);

}  // namespace game
