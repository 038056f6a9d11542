// Turns head, neck and chest of a body towards a point.
#pragma once

#include <optional>

#include "people/motion/player.h"
#include "people/motion/posed_body.h"

namespace muster {

/// Turns the head of the body that solveBody() has posed towards `target` [m in the world], by its limits,
/// and smoothly back where there is none. `free`: the arms are, so that the chest may turn, too.
void turnHead(const Mover& mover, const std::optional<Vec3>& target, float dt, bool free, PosedBody& body);

}  // namespace muster
