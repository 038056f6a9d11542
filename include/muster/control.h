// Controls: what fingers hold of a group's mesh, and where they draw it (paper sections 4.1 and 4.2).
#pragma once

#include <cstdint>
#include <vector>

#include "muster/geometry.h"
#include "muster/id.h"

namespace muster {

/// How many points a control holds: one, two, or three and more.
enum class ControlKind : std::uint8_t { Point, Line, Area };

/// A point of a drawn trajectory.
struct Checkpoint {
    Vec2 position;      ///< [m]
    double time = 0.0;  ///< When it was drawn [s].

    /// Lets an archive read or write the checkpoint.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, time);
    }
};

/// A mesh vertex held by a finger, and the trajectory drawn for it.
struct ControlPoint {
    std::int32_t vertex = 0;  ///< Index of the mesh vertex, which is a hard constraint.
    std::uint32_t touch = 0;  ///< Number of the finger; unique per client while it is down.
    bool down = true;         ///< False once the finger has lifted.
    Vec2 offset;    ///< From the finger to the vertex at touch down; added to the whole drawing [m].
    Vec2 position;  ///< Where the vertex is held now [m].
    std::vector<Checkpoint> trajectory;  ///< Checkpoints still ahead; the last is the finger's newest point.

    /// Lets an archive read or write the point.
    template <class Archive>
    void visit(Archive& archive) {
        archive(vertex, touch, down, offset, position, trajectory);
    }
};

/// One control. All its points follow their trajectories by one clock, so that they keep their timing.
struct Control {
    ControlId id;                           ///< Never used again.
    ControlKind kind = ControlKind::Point;  ///< Follows from the number of points.
    std::uint32_t client = 0;               ///< Number of the client that touches.
    bool pinned = false;                    ///< True where it stays at the end of its trajectories.
    bool open = true;                       ///< True while touches of the same client may still join.
    double joinDeadline = -1.0;  ///< World time at which it stops being open [s]; -1 before its first step.
    double startTime = 0.0;      ///< Stamp of the first touch [s]; may lie ahead of the world's time.
    double clock = 0.0;          ///< Drawing time reached along the trajectories [s].
    std::vector<ControlPoint> points;      ///< At least one.
    std::vector<MeshPoint> supplementary;  ///< Supplementary points, which are soft constraints.
    std::vector<double> weights;           ///< Supplementary x points, row by row; each row sums to 1.

    /// Lets an archive read or write the control.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, kind, client, pinned, open, joinDeadline, startTime, clock, points, supplementary,
                weights);
    }
};

}  // namespace muster
