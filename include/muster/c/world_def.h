/* Definitions from which a world is made, and its parameters by name. */
#ifndef MUSTER_C_WORLD_DEF_H
#define MUSTER_C_WORLD_DEF_H

#include "muster/c/people.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A group of characters with one mesh.
typedef struct MusterGroupDef {
    uint32_t structVersion;  ///< Set by muster_default_group_def().
    const char* name;        ///< Name for display; null or empty for none.
    int32_t count;  ///< Number of characters, 1 to 200,000, or 0 where a source sends some; in all at
                    ///< most 5,000 with exact plans.
    MusterFormationDef formation;   ///< Shape and spacing of the places.
    MusterVec2 position;            ///< Centre of the formation [m].
    double angle;                   ///< Heading, counter-clockwise from +x [rad].
    const MusterVec2* starts;       ///< Initial positions of characters [m]; none to start on their places.
    int32_t startCount;             ///< Their number: 0 or `count`.
    double jitter;                  ///< Largest random displacement of initial positions [m], 0 or more.
    const MusterBody* bodies;       ///< One for all, or one for each character; none for the parameters'.
    int32_t bodyCount;              ///< Their number.
    const MusterRoleDef* roles;     ///< Which class stands where; none for no roles.
    int32_t roleCount;              ///< Their number.
    const double* demands;          ///< Units of supply that each place demands; none for 1 each.
    int32_t demandCount;            ///< Their number.
    MusterConduct conduct;          ///< How it behaves.
    const MusterOrder* orders;      ///< What it is to do at first, one after the other.
    int32_t orderCount;             ///< Their number.
    bool patrols;                   ///< True: orders that are done come last again.
    bool hasColour;                 ///< False: the palette's colour.
    uint32_t colour;                ///< Colour for display, 0xRRGGBB.
    bool hasBuild;                  ///< False: bodies of both builds, by the character's id.
    MusterBodyBuild build;          ///< Build of its drawn bodies.
    bool hasMotions;                ///< False: they walk in the plain manner.
    MusterMotionSet motions;        ///< How they walk and jog.
    const MusterPeopleDef* people;  ///< Sorts of persons, who also come by sources; none for no sorts.
    int32_t peopleCount;            ///< Their number. Their numbers go before those of `bodies`.
} MusterGroupDef;

/// 36 characters in a square at the origin.
MUSTER_API MusterGroupDef muster_default_group_def(void);

/// A disc that changes the formation of a group which passes it.
typedef struct MusterCheckpointDef {
    uint32_t structVersion;           ///< Set by muster_default_checkpoint_def().
    MusterVec2 position;              ///< Centre [m].
    double radius;                    ///< Radius [m], above 0.
    MusterFormationDef formation;     ///< New formation of the group.
    int32_t group;                    ///< Index of the group that it applies to; -1 for all groups.
    bool once;                        ///< True: it applies once per group. False: whenever a group enters.
    MusterCheckpointTrigger trigger;  ///< What passes it.
    double share;                     ///< For Crowd: share of the group, (0, 1].
} MusterCheckpointDef;

/// 2 m round the origin, for half of any group.
MUSTER_API MusterCheckpointDef muster_default_checkpoint_def(void);

/// An item, which a character collects by coming within its radius.
typedef struct MusterItemDef {
    MusterVec2 position;  ///< Centre [m].
    double radius;        ///< Radius [m], above 0.
} MusterItemDef;

/// Half a metre round the origin.
MUSTER_API MusterItemDef muster_default_item_def(void);

/// The value of a parameter.
typedef struct MusterParameterValue {
    const char* name;  ///< Name as muster_parameter_info() gives it: "plan.exponent".
    double value;      ///< Value in the range of the parameter.
} MusterParameterValue;

/// Describes one parameter.
typedef struct MusterParameterInfo {
    const char* name;         ///< Name in files and messages: "plan.exponent".
    const char* unit;         ///< "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
    double minimum;           ///< Smallest allowed value.
    double maximum;           ///< Largest allowed value.
    double standard;          ///< Value of the preset "muster".
    bool whole;               ///< True where only whole numbers are valid: switches, modes, steps and counts.
    const char* description;  ///< One sentence.
} MusterParameterInfo;

/// Number of parameters.
MUSTER_API int32_t muster_parameter_count(void);
/// The parameter of an index. Its texts are valid for ever. Fails with InvalidArgument for other indices.
MUSTER_API MusterStatus muster_parameter_info(int32_t index, MusterParameterInfo* outInfo);
/// The value of a parameter in a preset: "units" (the defaults), "people" or "paper". Fails with NotFound.
MUSTER_API MusterStatus muster_preset_value(const char* preset, const char* name, double* outValue);

/// Definition of a world.
typedef struct MusterWorldDef {
    uint32_t structVersion;        ///< Set by muster_default_world_def().
    const char* name;              ///< Title for display; null or empty for none.
    const char* description;       ///< Description in one or two sentences; null or empty for none.
    const char* credit;            ///< Credit for the data it uses; null or empty for none.
    const char* gestures;          ///< File of its gestures; null or empty for none. Worlds do not read it.
    MusterBox box;                 ///< Extent of the ground [m].
    double cell;                   ///< Edge of a ground cell [m], above 0.
    uint64_t seed;                 ///< Seed of all random numbers.
    const MusterClipFacts* clips;  ///< Facts of clips, indexed by MusterMotionIndex.
    int32_t clipCount;             ///< Their number.
    const MusterObstacleDef* obstacles;      ///< At most 20,000 obstacles.
    int32_t obstacleCount;                   ///< Their number.
    const MusterPatchDef* patches;           ///< At most 20,000 patches.
    int32_t patchCount;                      ///< Their number.
    const MusterMapDef* map;                 ///< Map that adds obstacles and patches; null for none.
    const MusterGroupDef* groups;            ///< At most 20,000 groups.
    int32_t groupCount;                      ///< Their number.
    const MusterCheckpointDef* checkpoints;  ///< Discs that change formations.
    int32_t checkpointCount;                 ///< Their number.
    const MusterItemDef* items;              ///< Items to collect.
    int32_t itemCount;                       ///< Their number.
    const MusterAreaDef* areas;              ///< Exits, sources and waiting areas; at most 1,000.
    int32_t areaCount;                       ///< Their number.
    bool ring;                               ///< True: the left and the right side of `box` are joined.
    const char* preset;  ///< Preset of parameters, "units", "people" or "paper"; null for "units".
    const MusterParameterValue* parameters;  ///< Parameters that differ from the preset, set in this order.
    int32_t parameterCount;                  ///< Their number.
} MusterWorldDef;

/// 32 m by 32 m of empty ground round the origin, with Muster's own clips.
MUSTER_API MusterWorldDef muster_default_world_def(void);

#ifdef __cplusplus
}
#endif

#endif
