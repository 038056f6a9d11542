// Paths along which obstacles and patches move.
#pragma once

#include <vector>

#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// A place at a time.
struct Waypoint {
    double time = 0.0;   ///< [s] from the start of the world.
    Vec2 position;       ///< Offset from the thing's defined placement [m].
    double angle = 0.0;  ///< Turn about its centre [rad].

    /// Lets an archive read or write the waypoint.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, position, angle);
    }
};

/// Linear motion through waypoints of strictly rising time; still where it has none.
struct TimedPath {
    std::vector<Waypoint> waypoints;  ///< Empty for a thing that stands still.
    bool loop = false;                ///< Starts again after the last; else it stays there.

    /// True where it never moves.
    bool still() const { return waypoints.empty(); }
    /// The waypoint reached at `time` [s].
    Waypoint at(double time) const;
    /// Velocity at `time` [m/s].
    Vec2 velocity(double time) const;
    /// Rate of turn at `time` [rad/s].
    double spin(double time) const;
    /// InvalidArgument, naming the waypoint, where times do not rise or a number is not finite.
    Status validate() const;

    /// Lets an archive read or write the path.
    template <class Archive>
    void visit(Archive& archive) {
        archive(waypoints, loop);
    }
};

}  // namespace muster
