// Speed in a crowd (SPEC A4; Treuille, Cooper and Popovic 2006, section 4.1): the free speed up to
// `density.min`, the speed of the crowd's flow from `density.max` on, linear between.
#pragma once

#include <algorithm>

#include "engine/fields/cost/density.h"
#include "muster/generated/parameters.h"

namespace muster {

/// Speed f of a character at `p` that walks along the unit vector `direction`, relative to the free speed of
/// the ground, in [cost.minSpeed, 1]. Density and flow are read `density.lookAhead` metres ahead. The flow is
/// measured against the free speed on this ground, character.maxSpeed * `travelSpeed`: otherwise a crowd on
/// slow ground would count as slow twice.
inline double relativeCrowdSpeed(const Parameters& parameters, const DensityField& crowd, Vec2 p,
                                 Vec2 direction, double travelSpeed) {
    const Parameters::Density& def = parameters.density;
    const Vec2 ahead = p + direction * def.lookAhead;
    const double density = crowd.densityAt(ahead);
    if (density <= def.min) return 1.0;
    const double flow = std::max(0.0, dot(crowd.velocityAt(ahead), direction)) /
                        (parameters.character.maxSpeed * travelSpeed);
    const double share = std::min(1.0, (density - def.min) / (def.max - def.min));
    return std::max(parameters.cost.minSpeed, 1.0 + share * (std::min(1.0, flow) - 1.0));
}

}  // namespace muster
