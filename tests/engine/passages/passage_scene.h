// Walls with gaps, as the tests of passages need them.
#pragma once

#include <initializer_list>
#include <utility>

#include "engine/fields/cost/static_ground.h"
#include "engine/ground/environment/environment.h"

namespace muster::testing {

/// A floor of 40 x 40 m with a wall of 1 m along the y axis, open from and to these y [m].
inline Environment walledFloor(std::initializer_list<std::pair<double, double>> openings) {
    Environment environment = Environment::create({.box = {{-20, -20}, {20, 20}}}).value();
    double from = -20.0;
    const auto add = [&](double low, double high) {
        (void)environment.addObstacle({.polygon = {{-0.5, low}, {0.5, low}, {0.5, high}, {-0.5, high}}});
    };
    for (const auto& [low, high] : openings) {
        add(from, low);
        from = high;
    }
    if (from < 20.0) add(from, 20.0);
    environment.setTime(0.0);
    return environment;
}

/// The static ground of an environment for bodies of 0.25 m.
inline StaticGround groundOf(const Environment& environment) {
    StaticGround ground;
    ground.update(environment, 1.0, 0.25);
    return ground;
}

}  // namespace muster::testing
