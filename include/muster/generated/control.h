// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// Controls: points of a mesh that fingers move along trajectories (paper sections 4.1 and 4.2).
#pragma once

#include <cstdint>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/geometry.h"
#include "muster/id.h"
#include "muster/vec2.h"

namespace muster {

/// A point of a drawn trajectory.
struct Checkpoint {
    Vec2 position;      ///< Position in the world [m].
    double time = 0.0;  ///< When it was drawn [s].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, time);
    }
};

/// A mesh vertex that a finger controls, and the trajectory drawn for it.
struct ControlPoint {
    std::int32_t vertex = 0;  ///< Index of the mesh vertex, which is a hard constraint.
    std::uint32_t touch = 0;  ///< Number of the finger; unique per client while it is down.
    bool down = true;         ///< False once the finger has lifted.
    /// From the finger to the vertex at touch down [m]; added to all drawn points.
    Vec2 offset;
    Vec2 position;                       ///< Current position of the vertex in the world [m].
    std::vector<Checkpoint> trajectory;  ///< Checkpoints still ahead; the last is the finger's newest point.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(vertex, touch, down, offset, position, trajectory);
    }
};

/// One control of a mesh. All its points follow their trajectories by a common clock, which preserves their
/// relative timing.
struct Control {
    ControlId id;                           ///< Unique id, which is not reused.
    ControlKind kind = ControlKind::Point;  ///< Follows from the number of points.
    std::uint32_t client = 0;               ///< Number of the client that touches.
    bool pinned = false;                    ///< True where it stays at the end of its trajectories.
    bool open = true;                       ///< True while touches of the same client may still join.
    /// World time at which it stops being open [s]; -1 before its first step.
    double joinDeadline = -1.0;
    /// Time stamp of the first touch [s]; may be later than the world's time.
    double startTime = 0.0;
    double clock = 0.0;                    ///< Time of the drawing that the points have reached [s].
    std::vector<ControlPoint> points;      ///< Controlled vertices, at least one.
    std::vector<MeshPoint> supplementary;  ///< Supplementary points, which are soft constraints.
    /// Row-major weights, supplementary points x points; each row sums to 1.
    std::vector<double> weights;

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, kind, client, pinned, open, joinDeadline, startTime, clock, points, supplementary,
                weights);
    }
};

}  // namespace muster
