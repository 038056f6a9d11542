// Speeds on stairs and ramps.
#pragma once

#include "engine/ground/environment/environment.h"
#include "muster/generated/people_definitions.h"

namespace muster {

/// Travel speed of a character on its ground, in the direction of the unit vector `way`, or standing (null).
/// On stairs the shares of its body go before those of the ground.
inline double travelSpeedOf(const GroundSample& ground, const Body& body, Vec2 way) {
    if (!ground.isStairs()) return ground.travelSpeed;
    GroundSample own = ground;
    if (body.upstairs > 0.0) own.up = body.upstairs;
    if (body.downstairs > 0.0) own.down = body.downstairs;
    return own.speedAlong(way);
}

}  // namespace muster
