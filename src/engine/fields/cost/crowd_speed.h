// Speed in a crowd (SPEC A4; Treuille, Cooper and Popovic 2006, section 4.1): the free speed up to
// densityMin, the speed of the crowd's flow from densityMax on, linear between.
#pragma once

#include <algorithm>

#include "engine/fields/cost/density.h"
#include "engine/fields/cost/unit_cost.h"

namespace muster {

/// Speed f of a character at `p` that walks along the unit vector `direction`, relative to the free speed of
/// the ground, in [minSpeed, 1]. Density and flow are read `lookAhead` metres ahead. The flow is measured
/// against the free speed on this ground, freeSpeed * `travelSpeed`: otherwise a crowd on slow ground would
/// count as slow twice.
inline double relativeCrowdSpeed(const UnitCostDef& def, const DensityField& density, Vec2 p, Vec2 direction,
                                 double travelSpeed) {
    const Vec2 ahead = p + direction * def.lookAhead;
    const double crowd = density.densityAt(ahead);
    if (crowd <= def.densityMin) return 1.0;
    const double flow = std::max(0.0, dot(density.velocityAt(ahead), direction)) /
                        (def.freeSpeed * travelSpeed);
    const double share = std::min(1.0, (crowd - def.densityMin) / (def.densityMax - def.densityMin));
    return std::max(def.minSpeed, 1.0 + share * (std::min(1.0, flow) - 1.0));
}

}  // namespace muster
