// Environments for tests of the static ground and of costs on it.
#pragma once

#include <doctest.h>

#include <vector>

#include "base/random.h"
#include "engine/fields/cost/ground_level.h"
#include "engine/ground/environment/environment.h"

namespace muster::test {

/// A box-shaped obstacle.
inline ObstacleDef rectangle(double x0, double y0, double x1, double y1) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}};
}

/// A patch of this travel speed, relative to running.
inline PatchDef slowBox(double x0, double y0, double x1, double y1, double speed) {
    return {.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}}, .motion = 2, .speed = speed};
}

/// An environment without obstacles on a square of 2 x `half` metres.
inline Environment squareWorld(double half) {
    Result<Environment> environment = Environment::create({.box = {{-half, -half}, {half, half}}});
    REQUIRE(environment.ok());
    return std::move(environment).value();
}

/// The static ground of an environment for characters of radius 0.25 m.
inline StaticGround groundOf(const Environment& environment) {
    StaticGround ground;
    ground.update(environment, 1.0, 0.25);
    return ground;
}

/// A random point within `half` of the origin at which a character can stand.
inline Vec2 freeSpot(const Environment& environment, Random& random, double half) {
    for (;;) {
        const Vec2 p{random.uniform(-half, half), random.uniform(-half, half)};
        if (environment.distanceToObstacle(p) >= 0.27) return p;
    }
}

}  // namespace muster::test
