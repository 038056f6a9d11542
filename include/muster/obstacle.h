// Obstacles, which nobody can walk through (SPEC M6), and the paths along which obstacles and patches move.
#pragma once

#include <string>
#include <vector>

#include "muster/geometry.h"
#include "muster/status.h"

namespace muster {

/// Position and angle of a moving object at one time.
struct Waypoint {
    double time = 0.0;   ///< World time [s], -1e7 to 1e7.
    Vec2 position;       ///< Offset from the object's defined position [m], each coordinate -1e7 to 1e7.
    double angle = 0.0;  ///< Rotation about the object's centre of area [rad], -1e5 to 1e5.

    /// Lets an archive read or write the waypoint.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, position, angle);
    }
    /// Equal in all parts.
    friend bool operator==(const Waypoint&, const Waypoint&) = default;
};

/// Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes
/// ground: the world then holds it where it stands, without a path.
struct TimedPath {
    std::vector<Waypoint> waypoints;  ///< At least 1e-6 s apart; empty for an object that stands still.
    bool loop = false;                ///< True to start again after the last waypoint; false to stay there.

    /// True where it never moves.
    bool still() const { return waypoints.empty(); }
    /// Position and angle at `time` [s].
    Waypoint at(double time) const;
    /// Velocity at `time` [m/s].
    Vec2 velocity(double time) const;
    /// Angular velocity at `time` [rad/s].
    double angularVelocity(double time) const;
    /// Fails with InvalidArgument, naming the waypoint, where times do not rise or a number is out of range.
    Status validate() const;

    /// Lets an archive read or write the path.
    template <class Archive>
    void visit(Archive& archive) {
        archive(waypoints, loop);
    }
    /// Equal in all parts.
    friend bool operator==(const TimedPath&, const TimedPath&) = default;
};

/// Describes an obstacle: a polygon or a disc.
struct ObstacleDef {
    std::string name;     ///< Name for display; may be empty.
    Polygon polygon;      ///< Simple, convex or not [m]; empty for a disc.
    Vec2 centre;          ///< Centre of the disc [m].
    double radius = 0.0;  ///< Radius of the disc [m], above 0; 0 for a polygon.
    TimedPath path;       ///< Its motion; empty for an obstacle that stands still.
    /// Reach r of its potential field [m], 0 or more; negative for the world's default.
    double range = -1.0;
    double strength = -1.0;  ///< Factor of its potential field, 0 or more; negative for the world's default.
    double height = 3.0;     ///< Height for display only [m], above 0.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, centre, radius, path, range, strength, height);
    }
    /// Equal in all parts.
    friend bool operator==(const ObstacleDef&, const ObstacleDef&) = default;
};

}  // namespace muster
