// The nearest surface of a piece, distance and point at once.
#pragma once

#include "muster/obstacle.h"

namespace muster {

/// What of a piece's surface is nearest to a point.
struct NearestSurface {
    double distance = 0.0;  ///< [m], negative inside.
    Vec2 point;             ///< On the surface [m].
};

/// As ObstaclePiece::signedDistance() and closestSurface() tell it.
NearestSurface nearestSurface(const ObstaclePiece& piece, Vec2 p);

}  // namespace muster
