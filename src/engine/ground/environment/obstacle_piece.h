// Convex parts of obstacles, and distances to them.
#pragma once

#include "engine/geometry/polygon.h"
#include "muster/id.h"

namespace muster {

/// One convex part of an obstacle as it stands now: a polygon, or a disc where it has no corners.
struct ObstaclePiece {
    Polygon corners;  ///< Counter-clockwise [m]; empty for a disc.
    Vec2 centre;      ///< Centre of area [m].
    /// Radius of the disc, or of the circle about the centre that holds all corners [m].
    double radius = 0.0;
    Vec2 velocity;          ///< Velocity of the centre [m/s].
    double range = 0.0;     ///< Range of the potential field [m].
    double strength = 0.0;  ///< Factor of the potential field.
    ObstacleId obstacle;    ///< The obstacle it is a part of.
    bool moving = false;    ///< True where the obstacle follows a path.

    /// Distance from `p` to the surface [m], negative inside.
    double signedDistance(Vec2 p) const;
    /// The point of the surface nearest to `p`.
    Vec2 closestSurface(Vec2 p) const;
    /// Smallest distance between the segment and the piece [m]; 0 where they meet.
    double segmentDistance(Vec2 a, Vec2 b) const;
};

/// The surface point of a piece nearest to a query point.
struct SurfacePoint {
    double distance = 0.0;  ///< Distance from the query point [m], negative inside the piece.
    Vec2 point;             ///< Nearest point of the surface [m].
};

/// signedDistance() and closestSurface() of a piece at once.
SurfacePoint closestSurfacePoint(const ObstaclePiece& piece, Vec2 p);

}  // namespace muster
