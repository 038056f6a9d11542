// What a world is made from: plain data, as scenarios hold it.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/formation.h"
#include "muster/map_import.h"
#include "muster/obstacle.h"
#include "muster/parameters.h"
#include "muster/patch.h"

namespace muster {

/// A group of characters with one mesh.
struct GroupDef {
    std::string name = "Group";  ///< Shown on its chip.
    std::int32_t count = 36;     ///< Characters, 1 to 200,000; with exact plans 5,000 in all groups.
    FormationDef formation;      ///< Kind and spacing.
    Vec2 position;               ///< Centre of the formation [m].
    double angle = 0.0;          ///< Where it faces, from +x counter-clockwise [rad].
    std::vector<Vec2> starts;    ///< Where characters stand at first [m]; empty: on their places.
    double jitter = 0.0;         ///< Start positions are moved by up to this, by the seed [m] >= 0.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, count, formation, position, angle, starts, jitter);
    }
};

/// A spot that changes the formation of a group whose mesh centre comes within its radius (SPEC M7).
struct FormationCheckpointDef {
    Vec2 position;            ///< [m]
    double radius = 2.0;      ///< [m] > 0
    FormationDef formation;   ///< What the group becomes.
    std::int32_t group = -1;  ///< Index of the group it concerns; -1 for any.
    bool once = true;         ///< Works once per group; else each time the group comes anew.

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius, formation, group, once);
    }
};

/// Something to collect: gone when a character comes within the radius.
struct ItemDef {
    Vec2 position;        ///< [m]
    double radius = 0.5;  ///< [m] > 0

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius);
    }
};

/// A MovingAI map as ground.
struct MapGround {
    MapGrid grid;  ///< The cells.
    MapDef def;    ///< Scale and placement.

    /// Lets an archive read or write the ground.
    template <class Archive>
    void visit(Archive& archive) {
        archive(grid, def.metresPerCell, def.origin, def.swampSpeed);
    }
};

/// Everything a world starts from.
struct WorldDef {
    std::string name = "Untitled";  ///< Shown in the studio.
    std::string description;        ///< One or two sentences.
    std::string credit;             ///< Whose data it uses; may be empty.
    /// File of its gestures, in the scenario's folder or below; empty for none. World does not read it.
    std::string gestures;
    Box box{{-16, -16}, {16, 16}};                      ///< [m]
    double cell = 0.25;                                 ///< Edge of a ground cell [m] > 0.
    std::uint64_t seed = 1;                             ///< Of all random numbers.
    std::vector<ClipFacts> clips = defaultClipFacts();  ///< Indexed by MotionId.
    std::vector<ObstacleDef> obstacles;                 ///< At most 20,000.
    std::vector<PatchDef> patches;                      ///< At most 20,000.
    std::optional<MapGround> map;                       ///< Adds obstacles and patches.
    std::vector<GroupDef> groups;                       ///< At most 200.
    std::vector<FormationCheckpointDef> checkpoints;    ///< Spots that change formations.
    std::vector<ItemDef> items;                         ///< Things to collect.
    Parameters parameters;                              ///< How it behaves.
};

}  // namespace muster
