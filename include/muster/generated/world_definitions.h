// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// What a world is made of: the data of a scenario.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/ground_definitions.h"
#include "muster/generated/orders_definitions.h"
#include "muster/generated/parameters.h"
#include "muster/generated/people_definitions.h"
#include "muster/ground.h"
#include "muster/vec2.h"

namespace muster {

/// A group of characters with one mesh.
struct GroupDef {
    std::string name = "Group";           ///< Name for display.
    std::int32_t count = 36;              ///< Number of characters, 1 to 200,000, or 0 where a source sends
                                          ///< some; at most 5,000 in all groups with exact plans.
    FormationDef formation;               ///< Shape and spacing of the places.
    Vec2 position;                        ///< Centre of the formation [m].
    double angle = 0.0;                   ///< Heading, counter-clockwise from +x [rad].
    std::vector<Vec2> starts;             ///< Initial positions of characters [m]; empty to start on their
                                          ///< places.
    double jitter = 0.0;                  ///< Largest random displacement of initial positions, 0 or more
                                          ///< [m].
    std::vector<Body> bodies;             ///< One for all, or one for each character; empty for the
                                          ///< parameters'.
    std::vector<RoleDef> roles;           ///< Which class stands where; empty for none.
    std::vector<double> demands;          ///< Units of supply that each place demands; empty for 1 each.
    Conduct conduct;                      ///< How it behaves.
    std::vector<Order> orders;            ///< What it is to do at first, one after the other.
    bool patrols = false;                 ///< True: orders that are done come last again.
    std::optional<std::uint32_t> colour;  ///< Colour for display, 0xRRGGBB; none for the palette's.
    std::optional<BodyBuild> build;       ///< Build of its drawn bodies; none for both, by the character's
                                          ///< id.
    std::optional<MotionSet> motions;     ///< How it walks and jogs; none for the plain manner.
    std::vector<PeopleDef> people;        ///< Sorts of persons, who also come by sources; empty for none. A
                                          ///< number that a sort draws goes before that of `bodies`; what it
                                          ///< does not draw, and acceleration, mass and supply, is that of
                                          ///< `bodies`.

    /// Lets an archive read or write it.
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

/// The colour of a group.
struct GroupColour {
    std::optional<std::uint32_t> colour;  ///< Colour for display, 0xRRGGBB; none for the palette's.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(colour);
    }
    /// Equal in all parts.
    friend bool operator==(const GroupColour&, const GroupColour&) = default;
};

/// How the people of a group look.
struct GroupLook {
    std::optional<BodyBuild> build;    ///< Build of its drawn bodies; none for both, by the character's id.
    std::optional<MotionSet> motions;  ///< How it walks and jogs; none for the plain manner.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(build, motions);
    }
    /// Equal in all parts.
    friend bool operator==(const GroupLook&, const GroupLook&) = default;
};

/// A disc that changes the formation of a group which passes it (SPEC M7).
struct FormationCheckpointDef {
    Vec2 position;                                         ///< Centre [m].
    double radius = 2.0;                                   ///< Radius, above 0 [m].
    FormationDef formation;                                ///< New formation of the group.
    std::int32_t group = -1;                               ///< Index of the group that it applies to; -1 for
                                                           ///< all groups.
    bool once = true;                                      ///< True: it applies once per group. False:
                                                           ///< whenever a group enters.
    CheckpointTrigger trigger = CheckpointTrigger::Crowd;  ///< What passes it.
    double share = 0.5;                                    ///< For Crowd: share of the group, (0, 1].

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position, radius, formation, group, once);
        archive.since(2, trigger, share);
    }
};

/// Describes a world.
struct WorldDef {
    std::string name = "Untitled";                      ///< Title for display.
    std::string description;                            ///< Description in one or two sentences.
    std::string credit;                                 ///< Credit for the data it uses; may be empty.
    std::string gestures;                               ///< File of its gestures, in the scenario's folder or
                                                        ///< below, which worlds do not read; empty for none.
    Box box{{-16, -16}, {16, 16}};                      ///< Extent of the ground [m].
    double cell = 0.25;                                 ///< Edge of a ground cell, above 0 [m].
    std::uint64_t seed = 1;                             ///< Seed of all random numbers.
    std::vector<ClipFacts> clips = defaultClipFacts();  ///< Facts of clips, which patches name by their
                                                        ///< index.
    std::vector<ObstacleDef> obstacles;                 ///< At most 20,000 obstacles.
    std::vector<PatchDef> patches;                      ///< At most 20,000 patches.
    std::optional<MapGround> map;                       ///< Map that adds obstacles and patches; none for no
                                                        ///< map.
    std::vector<GroupDef> groups;                       ///< At most 20,000 groups.
    std::vector<FormationCheckpointDef> checkpoints;    ///< Discs that change formations.
    std::vector<ItemDef> items;                         ///< Items to collect.
    std::vector<AreaDef> areas;                         ///< Exits, sources and waiting areas; at most 1,000.
    bool ring = false;                                  ///< True: the left and the right side of `box` are
                                                        ///< joined. Who walks out on one side comes in on the
                                                        ///< other.
    Parameters parameters;                              ///< Parameters of behaviour.
};

}  // namespace muster
