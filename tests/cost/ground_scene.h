// Environments for tests of costs between points.
#pragma once

#include <doctest.h>

#include <vector>

#include "base/random.h"
#include "cost/static_ground.h"
#include "environment/environment.h"

namespace muster::test {

/// A box-shaped obstacle.
inline ObstacleDef rectangle(double x0, double y0, double x1, double y1) {
    ObstacleDef def;
    def.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    return def;
}

/// A patch on which one moves at `speed` of running.
inline PatchDef slowBox(double x0, double y0, double x1, double y1, double speed) {
    PatchDef def;
    def.polygon = {{x0, y0}, {x1, y0}, {x1, y1}, {x0, y1}};
    def.motion = 2;
    def.speed = speed;
    return def;
}

/// A square world of 2 x `half` metres.
inline Environment squareWorld(double half) {
    EnvironmentDef def;
    def.box = {{-half, -half}, {half, half}};
    Result<Environment> environment = Environment::create(def);
    REQUIRE(environment.ok());
    return std::move(environment).value();
}

/// Its still ground, for characters of 0.25 m.
inline StaticGround groundOf(const Environment& environment) {
    StaticGround ground;
    ground.update(environment, 1.0, 0.25);
    return ground;
}

/// A free spot within `half` of the middle.
inline Vec2 freeSpot(const Environment& environment, Random& random, double half) {
    for (;;) {
        const Vec2 p{random.uniform(-half, half), random.uniform(-half, half)};
        if (environment.distanceToObstacle(p) >= 0.27) return p;
    }
}

}  // namespace muster::test
