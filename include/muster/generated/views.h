// Made by schema/generate.mjs from schema/api/views.txt: change these, not this file.
// Read access to a world except its characters: groups, obstacles, patches, areas.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "muster/generated/control.h"
#include "muster/generated/orders_definitions.h"
#include "muster/generated/walk_totals.h"
#include "muster/ground.h"
#include "muster/id.h"
#include "muster/vec2.h"

namespace muster {

/// What can be read of a group without a copy. Texts and arrays are valid until the world steps or ends.
struct GroupView {
    GroupId id;                           ///< Unique id; it is not reused after the group is removed.
    std::string_view name;                ///< Name for display.
    std::optional<std::uint32_t> colour;  ///< Chosen colour, 0xRRGGBB; none for the palette's colour.
    /// Build of its drawn bodies; none for bodies of both builds.
    std::optional<BodyBuild> build;
    std::optional<MotionSet> motions;  ///< How it walks and jogs; none for the plain manner.
    /// Number of characters, and of places but where they go without (Leave, Wait, Walk): then there are
    /// none.
    std::int32_t count = 0;
    FormationKind formation{};                  ///< Current shape. Its whole definition is read separately.
    std::uint32_t formationVersion = 0;         ///< Increases whenever the mesh is replaced.
    Pose pose;                                  ///< Transforms the rest mesh to the world.
    std::span<const std::int32_t> members;      ///< Indices of its characters, ascending.
    std::span<const Vec2> restMesh;             ///< Vertices of the rest shape, in the group's axes [m].
    std::span<const Vec2> userMesh;             ///< Vertices of Vu, deformed by controls [m].
    std::span<const Vec2> finalMesh;            ///< Vertices of Vf: Vu deformed by the environment [m].
    std::span<const Triangle> triangles;        ///< Vertex indices, counter-clockwise.
    std::span<const Control> controls;          ///< Controls in the order of creation.
    std::span<const MeshPoint> meshPlaces;      ///< Each place as a point of the mesh.
    std::span<const Vec2> placePositions;       ///< Current position of each place [m].
    std::span<const Vec2> placeVelocities;      ///< Current velocity of each place [m/s].
    std::span<const Vec2> placeTargets;         ///< Reachable target of each place [m].
    std::span<const std::uint8_t> placeUsable;  ///< 1 where a character can stand at the place, else 0.
    /// Class of each place by the group's roles, 0 for whoever is left; empty without roles.
    std::span<const std::uint8_t> placeClasses;
    double objective = 0.0;  ///< Objective of the last plan [cost^p].
    double gapBound = 0.0;   ///< Upper bound of its duality gap [cost^p].
    WalkTotals walk;         ///< Path costs by the last plan.
    /// Mean distance of characters to the targets of their places (SPEC U6) [m].
    double meanLag = 0.0;
    std::span<const QueuedOrder> orders;  ///< Its queue; the first one is carried out.
    bool held = false;                    ///< True: it was ordered to hold, and its orders stay.
    bool patrols = false;                 ///< True: orders that are done come last again.
    Conduct conduct;                      ///< How it behaves.
    /// What is ahead of the way of the order that it carries out: corners up to the end, the next one first
    /// [m].
    std::span<const Vec2> way;
};

/// An obstacle and its current position. Its id is none where the world has no such obstacle.
struct ObstacleView {
    ObstacleId id;              ///< Unique id; it is not reused.
    ObstacleDef def;            ///< Definition as added or last changed.
    std::vector<Vec2> outline;  ///< Current corners [m]; empty for a disc.
    Vec2 centre;                ///< Current centre of the disc or of the area [m].
};

/// A patch and its current position. Its id is none where the world has no such patch.
struct PatchView {
    PatchId id;                 ///< Unique id; it is not reused.
    PatchDef def;               ///< Definition as added or last changed.
    std::vector<Vec2> outline;  ///< Current corners [m].
};

/// An exit, a source or a waiting area, and what it has seen.
struct AreaView {
    AreaId id;        ///< Unique id; it is not reused.
    AreaDef def;      ///< Definition as added or last changed; its `group` is not read.
    GroupId group;    ///< Of a source: whom its people join.
    AreaCount count;  ///< What it has seen.
};

}  // namespace muster
