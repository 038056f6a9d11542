// Draws the battle.
#pragma once

#include "camera.h"
#include "game_battle.h"
#include "mouse.h"
#include "painter.h"

namespace game {

/// Everything, with units a share of a step on from the step before.
void drawScene(Painter& painter, const Camera& camera, const Battle& battle, const Mouse& mouse,
               double share);

}  // namespace game
