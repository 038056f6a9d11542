// Obstacles: what nobody can walk through (SPEC M6).
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "muster/id.h"
#include "muster/timed_path.h"

namespace muster {

/// Describes an obstacle; the defaults other than the shape are usable as they stand.
struct ObstacleDef {
    std::string name;        ///< For people; may be empty.
    Polygon polygon;         ///< Simple, convex or not; empty for a disc.
    Vec2 centre;             ///< Centre of the disc [m].
    double radius = 0.0;     ///< Of the disc [m] > 0; 0 for a polygon.
    TimedPath path;          ///< Moves it; empty for one that stands still.
    double range = -1.0;     ///< Reach r of its potential field [m] >= 0; negative: the world's default.
    double strength = -1.0;  ///< Scale of its field >= 0; negative: the world's default.
    double height = 3.0;     ///< For the eye [m] > 0.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, centre, radius, path, range, strength, height);
    }
};

/// One convex part of an obstacle as it stands now: a polygon, or a disc where it has no corners.
struct ObstaclePiece {
    Polygon corners;        ///< Counter-clockwise [m]; empty for a disc.
    Vec2 centre;            ///< Centre of area [m].
    double radius = 0.0;    ///< Of the disc, or of the circle round the corners [m].
    Vec2 velocity;          ///< [m/s]
    double range = 0.0;     ///< Of the potential field [m].
    double strength = 0.0;  ///< Of the potential field.
    ObstacleId obstacle;    ///< Whose part it is.
    bool moving = false;    ///< Follows a path.

    /// Distance from `p` to the surface [m], negative inside.
    double signedDistance(Vec2 p) const;
    /// The nearest point of the surface to `p`.
    Vec2 closestSurface(Vec2 p) const;
    /// Smallest distance between the segment and the piece [m]; 0 where they meet.
    double segmentDistance(Vec2 a, Vec2 b) const;
};

}  // namespace muster
