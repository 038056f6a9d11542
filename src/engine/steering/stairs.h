// Speeds on stairs and ramps.
#pragma once

#include "engine/ground/environment/environment.h"
#include "muster/generated/people_definitions.h"

namespace muster {

/// Travel speed of somebody on the ground that it is on, who goes in the direction of the unit vector `way`,
/// or stands (null). On stairs its own shares go before theirs.
inline double travelSpeedOf(const GroundSample& ground, const Body& body, Vec2 way) {
    if (!ground.isStairs()) return ground.travelSpeed;
    GroundSample own = ground;
    if (body.upstairs > 0.0) own.up = body.upstairs;
    if (body.downstairs > 0.0) own.down = body.downstairs;
    return own.speedAlong(way);
}

}  // namespace muster
