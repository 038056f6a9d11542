// Read access to a world except its characters: groups, obstacles, patches, stage times.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/control.h"
#include "muster/formation.h"
#include "muster/ground.h"
#include "muster/id.h"
#include "muster/order.h"
#include "muster/vec2.h"
#include "muster/walk_totals.h"

namespace muster {

/// Number of stages of a step.
inline constexpr std::size_t kStageCount = 41;

/// A stage of the step.
struct StageInfo {
    std::string_view name;    ///< "commands", "orders", "controls"...
    std::string_view reads;   ///< What it reads of the state and of the stages before it.
    std::string_view writes;  ///< What it writes.
    std::string_view about;   ///< What it does, in one sentence.
};
/// The stages of a step, in their order.
std::span<const StageInfo, kStageCount> stepStages();

/// Some stages by their index in stepStages(), for programs that time them.
enum class Stage : std::uint8_t {
    Commands = 0,         ///< Commands are applied.
    Orders = 3,           ///< Orders and marches.
    Controls = 4,         ///< Controls follow touches.
    UserMesh = 5,         ///< Vu is solved.
    FinalMesh = 6,        ///< Vf is solved.
    Places = 12,          ///< Travelling places.
    DensityAndCost = 13,  ///< Density of the crowd.
    Plan = 21,            ///< Assignment of places.
    Steering = 31,        ///< Velocities of characters.
    Contacts = 32,        ///< Contacts are resolved.
    Patches = 33,         ///< Motions by patches.
    Events = 38,          ///< Arrivals of groups.
    Count = kStageCount   ///< Number of all stages.
};
/// The name of any stage, by its index: "commands", "orders", "controls"...
const char* stageName(Stage stage);

/// Wall time of the last step by stage; it is not part of the state. WebAssembly times the stages of every
/// eighth step only.
struct StageTimes {
    std::array<double, kStageCount>
        milliseconds{};  ///< Time of each stage [ms], in the order of stepStages().
    double total = 0.0;  ///< Time of the whole step [ms].
};

/// What can be read of a group. Text and spans are valid until the world steps or ends.
struct GroupView {
    GroupId id;                           ///< Unique id; it is not reused after the group is removed.
    std::string_view name;                ///< Name for display.
    std::optional<std::uint32_t> colour;  ///< Chosen colour, 0xRRGGBB; none for the palette's.
    std::optional<BodyBuild> build;       ///< Build of its drawn bodies; none for both.
    std::optional<MotionSet> motions;     ///< How it walks and jogs; none for the plain manner.
    /// Number of characters, and of places but where they go without (Leave, Wait, Walk): then there are
    /// none.
    std::int32_t count = 0;
    FormationKind formation{};                  ///< Current shape; World::groupDef has the whole definition.
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
    double meanLag = 0.0;    ///< Mean distance of characters to the targets of their places [m] (SPEC U6).
    std::span<const QueuedOrder> orders;  ///< Its queue; the first one is carried out.
    bool held = false;                    ///< True: it waits, and its orders stay.
    bool patrols = false;                 ///< True: orders that are done come last again.
    Conduct conduct;                      ///< How it behaves.
    /// What is ahead of the way of the order that it carries out: corners up to the end [m], the next one
    /// first.
    std::span<const Vec2> way;
};

/// An obstacle and its current position. Its id is none where the world has no such obstacle.
struct ObstacleView {
    ObstacleId id;    ///< Unique id; it is not reused.
    ObstacleDef def;  ///< Definition as added or last changed.
    Polygon outline;  ///< Current corners [m]; empty for a disc.
    Vec2 centre;      ///< Current centre of the disc or of the area [m].
};

/// A patch and its current position. Its id is none where the world has no such patch.
struct PatchView {
    PatchId id;       ///< Unique id; it is not reused.
    PatchDef def;     ///< Definition as added or last changed.
    Polygon outline;  ///< Current corners [m].
};

/// An exit, a source or a waiting area.
struct AreaView {
    AreaId id;        ///< Unique id; it is not reused.
    AreaDef def;      ///< Definition as added or last changed; its `group` is not read.
    GroupId group;    ///< Of a source: whom its people join.
    AreaCount count;  ///< What it has seen.
};

}  // namespace muster
