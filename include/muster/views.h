// What can be read of a world besides its characters: groups, obstacles, patches, stage times.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/control.h"
#include "muster/formation.h"
#include "muster/id.h"
#include "muster/obstacle.h"
#include "muster/patch.h"
#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// The stages of a step, in order.
enum class Stage : std::uint8_t {
    Commands,
    Controls,
    UserMesh,
    FinalMesh,
    Places,
    DensityAndCost,
    Plan,
    Steering,
    Contacts,
    Patches,
    Events,
    Count
};
/// "commands", "controls", "user mesh"...
const char* stageName(Stage stage);

/// Milliseconds of the last step by stage: for reports only.
struct StageTimes {
    std::array<double, static_cast<std::size_t>(Stage::Count)> milliseconds{};  ///< By Stage.
    double total = 0.0;                                                         ///< Whole step [ms].
};

/// A command that could not be applied, and why.
struct Rejection {
    Command command;  ///< As it was submitted.
    Status status;    ///< Why it was refused.
};

/// Costs of the paths from characters to their places, over those that have one.
struct WalkTotals {
    double sum = 0.0;      ///< [m] where the ground is plain.
    double squares = 0.0;  ///< [m^2].
    double longest = 0.0;  ///< [m].

    /// Adds one path; infinite ones do not count.
    void add(double walk);
    /// Adds the paths of others.
    void add(const WalkTotals& others);

    /// Lets an archive read or write the totals.
    template <class Archive>
    void visit(Archive& archive) {
        archive(sum, squares, longest);
    }
};

/// What can be read of a group. Text and spans are valid until the world steps or ends.
struct GroupView {
    GroupId id;                             ///< Never used again once the group is gone.
    std::string_view name;                  ///< Shown on its chip.
    std::int32_t count = 0;                 ///< Characters and places.
    FormationKind formation{};              ///< Shape as it is now; World::groupDef has all of it.
    std::uint32_t formationVersion = 0;     ///< Grows when the mesh is exchanged.
    Pose pose;                              ///< Puts the rest mesh into the world.
    std::span<const std::int32_t> members;  ///< Indices of its characters, ascending.
    std::span<const Vec2> restMesh;         ///< Vertices of the rest shape, in the group's axes [m].
    std::span<const Vec2> userMesh;         ///< Vertices of Vu: as the controls bend it [m].
    std::span<const Vec2> finalMesh;        ///< Vertices of Vf: as the environment bends Vu [m].
    std::span<const Triangle> triangles;    ///< Vertex indices, counter-clockwise.
    std::span<const Control> controls;      ///< In the order they were made.
    std::span<const MeshPoint> meshPlaces;  ///< Each place as a point of the mesh.
    std::span<const Vec2> placePositions;   ///< Where each place is now [m].
    std::span<const Vec2> placeVelocities;  ///< [m/s]
    std::span<const Vec2> placeTargets;     ///< Reachable target of each place, where it is bound for [m].
    std::span<const std::uint8_t> placeUsable;  ///< 0 where nobody can stand, else 1.
    double objective = 0.0;                     ///< Of the last plan [cost^p].
    double gapBound = 0.0;                      ///< Bound on its duality gap [cost^p].
    WalkTotals walk;                            ///< Path costs by the last plan.
    double meanLag = 0.0;  ///< Mean distance of characters to the targets of their places [m] (SPEC U6).
};

/// An obstacle and where it stands now. Its id is none where the world has no such obstacle.
struct ObstacleView {
    ObstacleId id;    ///< Never used again once the obstacle is gone.
    ObstacleDef def;  ///< As it was added or last changed.
    Polygon outline;  ///< Corners where they are now [m]; empty for a disc.
    Vec2 centre;      ///< Of the area, or of the disc, now [m].
};

/// A patch and where it lies now. Its id is none where the world has no such patch.
struct PatchView {
    PatchId id;       ///< Never used again once the patch is gone.
    PatchDef def;     ///< As it was added or last changed.
    Polygon outline;  ///< Corners where they are now [m].
};

}  // namespace muster
