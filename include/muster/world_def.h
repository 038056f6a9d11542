// Definitions from which a world is made: the data of a scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/area.h"
#include "muster/formation.h"
#include "muster/generated/enumerations.h"
#include "muster/map_import.h"
#include "muster/obstacle.h"
#include "muster/order.h"
#include "muster/parameters.h"
#include "muster/patch.h"
#include "muster/people.h"
#include "muster/unit.h"

namespace muster {

/// A group of characters with one mesh.
struct GroupDef {
    std::string name = "Group";  ///< Name for display.
    /// Number of characters, 1 to 200,000, or 0 where a source sends some; at most 5,000 in all groups with
    /// exact plans.
    std::int32_t count = 36;
    FormationDef formation;       ///< Shape and spacing of the places.
    Vec2 position;                ///< Centre of the formation [m].
    double angle = 0.0;           ///< Heading, counter-clockwise from +x [rad].
    std::vector<Vec2> starts;     ///< Initial positions of characters [m]; empty to start on their places.
    double jitter = 0.0;          ///< Largest random displacement of initial positions [m], 0 or more.
    std::vector<Body> bodies;     ///< One for all, or one for each character; empty for the parameters'.
    std::vector<RoleDef> roles;   ///< Which class stands where; empty for none.
    std::vector<double> demands;  ///< Units of supply that each place demands; empty for 1 each.
    Conduct conduct;              ///< How it behaves.
    std::vector<Order> orders;    ///< What it is to do at first, one after the other.
    bool patrols = false;         ///< True: orders that are done come last again.
    std::optional<std::uint32_t> colour;  ///< Colour for display, 0xRRGGBB; none for the palette's.
    std::optional<BodyBuild> build;    ///< Build of its drawn bodies; none for both, by the character's id.
    std::optional<MotionSet> motions;  ///< How it walks and jogs; none for the plain manner.
    /// Sorts of persons, who also come by sources; empty for none. A number that a sort draws goes before
    /// that of `bodies`; what it does not draw, and acceleration, mass and supply, is that of `bodies`.
    std::vector<PeopleDef> people;

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, count, formation, position, angle, starts, jitter);
        archive.since(2, bodies, roles, demands, conduct, orders, patrols);
        archive.optionalSince(5, colour);
        archive.optionalSince(6, build);
        archive.optionalSince(6, motions);
        archive.since(7, people);
    }
};

/// A disc that changes the formation of a group which passes it (SPEC M7).
struct FormationCheckpointDef {
    Vec2 position;            ///< Centre [m].
    double radius = 2.0;      ///< Radius [m], above 0.
    FormationDef formation;   ///< New formation of the group.
    std::int32_t group = -1;  ///< Index of the group that it applies to; -1 for all groups.
    bool once = true;         ///< True: it applies once per group. False: whenever a group enters.
    CheckpointTrigger trigger = CheckpointTrigger::Crowd;  ///< What passes it.
    double share = 0.5;                                    ///< For Crowd: share of the group, (0, 1].

    /// Lets an archive read or write the definition.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius, formation, group, once);
        archive.since(2, trigger, share);
    }
};

/// An item, which a character collects by coming within its radius.
struct ItemDef {
    Vec2 position;        ///< Centre [m].
    double radius = 0.5;  ///< Radius [m], above 0.

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

/// Definition of a world.
struct WorldDef {
    std::string name = "Untitled";  ///< Title for display.
    std::string description;        ///< Description in one or two sentences.
    std::string credit;             ///< Credit for the data it uses; may be empty.
    /// File of its gestures, in the scenario's folder or below; empty for none. World does not read it.
    std::string gestures;
    Box box{{-16, -16}, {16, 16}};                      ///< Extent of the ground [m].
    double cell = 0.25;                                 ///< Edge of a ground cell [m], above 0.
    std::uint64_t seed = 1;                             ///< Seed of all random numbers.
    std::vector<ClipFacts> clips = defaultClipFacts();  ///< Facts of clips, indexed by MotionId.
    std::vector<ObstacleDef> obstacles;                 ///< At most 20,000 obstacles.
    std::vector<PatchDef> patches;                      ///< At most 20,000 patches.
    std::optional<MapGround> map;                       ///< Map that adds obstacles and patches; may be none.
    std::vector<GroupDef> groups;                       ///< At most 20,000 groups.
    std::vector<FormationCheckpointDef> checkpoints;    ///< Discs that change formations.
    std::vector<ItemDef> items;                         ///< Items to collect.
    std::vector<AreaDef> areas;                         ///< Exits, sources and waiting areas; at most 1,000.
    /// True: the left and the right side of `box` are joined. Who walks out on one side comes in on the
    /// other.
    bool ring = false;
    Parameters parameters;  ///< Parameters of behaviour.
};

}  // namespace muster
