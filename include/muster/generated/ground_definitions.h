// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// What lies on the ground: obstacles, patches, areas, items, maps.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/geometry.h"
#include "muster/id.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// Position and angle of a moving object at one time.
struct Waypoint {
    double time = 0.0;   ///< World time, 0 to 1e7 [s].
    Vec2 position;       ///< Offset from the object's defined position [m].
    double angle = 0.0;  ///< Rotation about the object's centre of area, -1e5 to 1e5 [rad].

    /// Lets an archive read or write it.
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

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(waypoints, loop);
    }
    /// Equal in all parts.
    friend bool operator==(const TimedPath&, const TimedPath&) = default;
};

/// Describes an obstacle, which nobody can walk through: a polygon or a disc.
struct ObstacleDef {
    std::string name;        ///< Name for display; may be empty.
    Polygon polygon;         ///< Simple, convex or not [m]; empty for a disc.
    Vec2 centre;             ///< Centre of the disc [m].
    double radius = 0.0;     ///< Radius of the disc, above 0 [m]; 0 for a polygon.
    TimedPath path;          ///< Its motion; empty for an obstacle that stands still.
    double range = -1.0;     ///< Reach of its potential field, 0 or more [m]; negative for the world's
                             ///< default.
    double strength = -1.0;  ///< Factor of its potential field, 0 or more; negative for the world's default.
    double height = 3.0;     ///< Height for display only, above 0 [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, centre, radius, path, range, strength, height);
    }
    /// Equal in all parts.
    friend bool operator==(const ObstacleDef&, const ObstacleDef&) = default;
};

/// Facts of a motion clip that simulation needs (the paper's table 1).
struct ClipFacts {
    std::string name;             ///< Name of the motion: "run", "crawl", "climb"...
    std::string file;             ///< File of the clip; empty for one of Muster's own.
    double speed = 1.0;           ///< Travel speed relative to running, above 0 (running is 1).
    double length = 0.0;          ///< Ground covered by one play [m]; 0 where unknown.
    double duration = 0.0;        ///< Duration of one play, 0 or more [s].
    bool cyclic = true;           ///< False for single-step motions (jump, climb).
    double transitionTime = 0.0;  ///< Duration of the transition on entering and on leaving [s]; 0 for none.
    double reachAhead = 0.0;      ///< From the character's position to the head of a body that leans or lies
                                  ///< [m].
    double reachBehind = 0.0;     ///< From there back to its hips [m]; both are 0 for upright bodies.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, file, speed, length, duration, cyclic, transitionTime, reachAhead, reachBehind);
    }
    /// Equal in all parts.
    friend bool operator==(const ClipFacts&, const ClipFacts&) = default;
};

/// Describes a patch: ground with a motion clip of its own (SPEC C1).
struct PatchDef {
    std::string name;              ///< Name for display: "Net", "Pool"...
    Polygon polygon;               ///< Corners of a simple polygon, convex or not [m].
    TimedPath path;                ///< Its motion; empty for a patch that stands still.
    MotionId motion = 0;           ///< Clip played on it: an index into the world's clips.
    double speed = -1.0;           ///< Travel speed relative to running, above 0; negative for the clip's.
    std::optional<double> ascent;  ///< For stairs and ramps: heading of the way up, where `speed` is that of
                                   ///< going up [rad]; none for level ground.
    double speedDown = -1.0;       ///< For stairs and ramps: that of going down; negative for `speed`.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, polygon, path, motion, speed);
        archive.since(7, ascent, speedDown);
    }
    /// Equal in all parts.
    friend bool operator==(const PatchDef&, const PatchDef&) = default;
};

/// The cells of a MovingAI map.
struct MapGrid {
    std::int32_t width = 0;   ///< Columns, 1 to 4096.
    std::int32_t height = 0;  ///< Rows, 1 to 4096.
    std::string cells;        ///< One character per cell, row by row, the top row first.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(width, height, cells);
    }
};

/// Scale and position of a map.
struct MapDef {
    double metresPerCell = 1.0;  ///< Edge of a map cell, above 0 [m].
    Vec2 origin;                 ///< Lower left corner of the map [m].
    double swampSpeed = 0.4;     ///< Travel speed on swamp cells `S` relative to running, above 0.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(metresPerCell, origin, swampSpeed);
    }
};

/// A MovingAI map as ground.
struct MapGround {
    MapGrid grid;  ///< The cells.
    MapDef def;    ///< Scale and placement.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(grid, def);
    }
};

/// How many people a source has let in by a time.
struct Arrivals {
    double time = 0.0;       ///< Time of the world [s].
    std::int32_t count = 0;  ///< That come at this time.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(time, count);
    }
    /// Equal in all parts.
    friend bool operator==(const Arrivals&, const Arrivals&) = default;
};

/// Describes an area, where people leave the world, come into it, or wait. It is no obstacle.
struct AreaDef {
    std::string name;                 ///< Name for display: "Main exit".
    AreaKind kind = AreaKind::Exit;   ///< What it does.
    Polygon polygon;                  ///< Corners of a simple polygon, convex or not [m].
    bool open = true;                 ///< False: nobody leaves or comes here for now.
    double rate = 0.0;                ///< For Exit: the most people who leave in a second, 0 to 1000 [1/s]; 0
                                      ///< for as many as come. For Source: how many come in a second on
                                      ///< average, at random times by the world's seed, 0 to 1000.
    std::vector<Vec2> queue;          ///< For Exit: a line in which people queue, from who is next to the
                                      ///< last [m]; empty for a crowd.
    std::int32_t group = 0;           ///< For Source in a WorldDef: index of the group whom its people join.
    double from = 0.0;                ///< For Exit: when it opens [s]; for Source with a rate: when it
                                      ///< begins.
    double until = 1e9;               ///< For Exit: when it closes [s]; for Source with a rate: when it ends.
    std::int32_t most = 0;            ///< For Source with a rate: how many come in all; 0 for no end.
    std::vector<Arrivals> timetable;  ///< For Source: further people, by ascending times.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, kind, polygon, open, rate, queue, group, from, until, most, timetable);
    }
    /// Equal in all parts.
    friend bool operator==(const AreaDef&, const AreaDef&) = default;
};

/// An item, which a character collects by coming within its radius.
struct ItemDef {
    Vec2 position;        ///< Centre [m].
    double radius = 0.5;  ///< Radius, above 0 [m].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius);
    }
};

}  // namespace muster
