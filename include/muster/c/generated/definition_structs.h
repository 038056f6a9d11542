/* Made by schema/generate.mjs from schema/definitions.txt: change these, not this file. */
#ifndef MUSTER_C_DEFINITION_STRUCTS_H
#define MUSTER_C_DEFINITION_STRUCTS_H

#include "muster/c/values.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Position and angle of a moving object at one time.
typedef struct MusterWaypoint {
    double time;          ///< World time, 0 to 1e7 [s].
    MusterVec2 position;  ///< Offset from the object's defined position [m].
    double angle;         ///< Rotation about the object's centre of area, -1e5 to 1e5 [rad].
} MusterWaypoint;

/// Piecewise linear motion through waypoints of strictly rising time. An obstacle whose path is over becomes
/// ground: the world then holds it where it stands, without a path.
typedef struct MusterTimedPath {
    const MusterWaypoint* waypoints;  ///< At least 1e-6 s apart; none for an object that stands still.
    int32_t waypointCount;            ///< Their number.
    bool loop;                        ///< True to start again after the last waypoint; false to stay there.
} MusterTimedPath;

/// Describes an obstacle, which nobody can walk through: a polygon or a disc.
typedef struct MusterObstacleDef {
    uint32_t structVersion;  ///< Set by muster_default_obstacle_def().
    const char* name;        ///< Name for display; null for none.
    MusterPolygon polygon;   ///< Simple, convex or not [m]; empty for a disc.
    MusterVec2 centre;       ///< Centre of the disc [m].
    double radius;           ///< Radius of the disc, above 0 [m]; 0 for a polygon.
    MusterTimedPath path;    ///< Its motion; empty for an obstacle that stands still.
    double range;            ///< Reach of its potential field, 0 or more [m]; negative for the world's
                             ///< default.
    double strength;         ///< Factor of its potential field, 0 or more; negative for the world's default.
    double height;           ///< Height for display only, above 0 [m].
} MusterObstacleDef;
/// No shape yet, of the world's range and strength.
MUSTER_API MusterObstacleDef muster_default_obstacle_def(void);

/// Facts of a motion clip that simulation needs (the paper's table 1).
typedef struct MusterClipFacts {
    uint32_t structVersion;  ///< Set by muster_default_clip_facts().
    const char* name;        ///< Name of the motion: "run", "crawl", "climb"...; null for none.
    const char* file;        ///< File of the clip; empty for one of Muster's own; null for none.
    double speed;            ///< Travel speed relative to running, above 0 (running is 1).
    double length;           ///< Ground covered by one play [m]; 0 where unknown.
    double duration;         ///< Duration of one play, 0 or more [s].
    bool cyclic;             ///< False for single-step motions (jump, climb).
    double transitionTime;   ///< Duration of the transition on entering and on leaving [s]; 0 for none.
    double reachAhead;       ///< From the character's position to the head of a body that leans or lies [m].
    double reachBehind;      ///< From there back to its hips [m]; both are 0 for upright bodies.
} MusterClipFacts;
/// A cyclic clip without a name, as fast as running.
MUSTER_API MusterClipFacts muster_default_clip_facts(void);

/// Describes a patch: ground with a motion clip of its own.
typedef struct MusterPatchDef {
    uint32_t structVersion;    ///< Set by muster_default_patch_def().
    const char* name;          ///< Name for display: "Net", "Pool"...; null for none.
    MusterPolygon polygon;     ///< Corners of a simple polygon, convex or not [m].
    MusterTimedPath path;      ///< Its motion; empty for a patch that stands still.
    MusterMotionIndex motion;  ///< Clip played on it: an index into the world's clips.
    double speed;              ///< Travel speed relative to running, above 0; negative for the clip's.
    bool hasAscent;            ///< False: level ground.
    double ascent;             ///< For stairs and ramps: heading of the way up, where `speed` is that of
                               ///< going up [rad].
    double speedDown;          ///< For stairs and ramps: that of going down; negative for `speed`.
} MusterPatchDef;
/// No shape yet, on which people run.
MUSTER_API MusterPatchDef muster_default_patch_def(void);

/// How many people a source has let in by a time.
typedef struct MusterArrivals {
    double time;    ///< Time of the world [s].
    int32_t count;  ///< That come at this time.
} MusterArrivals;

/// Describes an area, where people leave the world, come into it, or wait. It is no obstacle.
typedef struct MusterAreaDef {
    uint32_t structVersion;           ///< Set by muster_default_area_def().
    const char* name;                 ///< Name for display: "Main exit"; null for none.
    MusterAreaKind kind;              ///< What it does.
    MusterPolygon polygon;            ///< Corners of a simple polygon, convex or not [m].
    bool open;                        ///< False: nobody leaves or comes here for now.
    double rate;                      ///< For Exit: the most people who leave in a second, 0 to 1000 [1/s]; 0
                                      ///< for as many as come. For Source: how many come in a second on
                                      ///< average, at random times by the world's seed, 0 to 1000.
    const MusterVec2* queue;          ///< For Exit: a line in which people queue, from who is next to the
                                      ///< last [m]; none for a crowd.
    int32_t queueCount;               ///< Their number.
    int32_t group;                    ///< For Source in a MusterWorldDef: index of the group whom its people
                                      ///< join.
    double from;                      ///< For Exit: when it opens [s]; for Source with a rate: when it
                                      ///< begins.
    double until;                     ///< For Exit: when it closes [s]; for Source with a rate: when it ends.
    int32_t most;                     ///< For Source with a rate: how many come in all; 0 for no end.
    const MusterArrivals* timetable;  ///< For Source: further people, by ascending times.
    int32_t timetableCount;           ///< Their number.
} MusterAreaDef;
/// An exit without a shape yet, open, for as many as come.
MUSTER_API MusterAreaDef muster_default_area_def(void);

/// An item, which a character collects by coming within its radius.
typedef struct MusterItemDef {
    MusterVec2 position;  ///< Centre [m].
    double radius;        ///< Radius, above 0 [m].
} MusterItemDef;
/// Half a metre round the origin.
MUSTER_API MusterItemDef muster_default_item_def(void);

/// The body of a character. A number of 0 stands for the parameter of that name.
typedef struct MusterBody {
    double radius;        ///< Radius, 0 or 0.05 to 1.5 [m].
    double maxSpeed;      ///< Top speed in the open, 0 or 0.01 to 50 [m/s].
    double acceleration;  ///< Top acceleration, 0 or 0.01 to 1000 [m/s^2].
    double mass;          ///< Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less.
    double supply;        ///< Units that it supplies to places, above 0 and at most 1000.
    uint8_t unitClass;    ///< Class, for roles; 0 for none.
    double headway;       ///< Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
    double premovement;   ///< Time from its first order until it sets out, 0 to 1e7 [s]; no parameter.
    double upstairs;      ///< Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
    double downstairs;    ///< Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
} MusterBody;
/// A body by the parameters, of mass and supply 1.
MUSTER_API MusterBody muster_default_body(void);

/// Characters of a class take their places in a part of the formation: as many as there are such characters.
/// Roles choose in their order; who is of no role takes what is left. (Ranks by class: several roles in
/// front.)
typedef struct MusterRoleDef {
    MusterRoleArea area;  ///< Where.
    uint8_t unitClass;    ///< Who, 1 or more.
} MusterRoleDef;

/// The distribution of a number over persons. What lies outside `least` to `most` is cut off: it is not
/// drawn, and what lies inside is drawn in its proportions. A constant is as it is.
typedef struct MusterDistribution {
    MusterSpread spread;  ///< Its kind.
    double a;             ///< First number, in the unit of what is drawn but for LogNormal.
    double b;             ///< Second number; not read for Constant.
    double least;         ///< The smallest value that occurs.
    double most;          ///< The largest one.
} MusterDistribution;
/// 0 for all, which stands for a parameter.
MUSTER_API MusterDistribution muster_default_distribution(void);

/// One sort of persons in a group. What is constantly 0 is not drawn: it is that of MusterGroupDef.bodies, or
/// of the parameters where that is 0, too.
typedef struct MusterPeopleDef {
    uint32_t structVersion;          ///< Set by muster_default_people_def().
    const char* name;                ///< Name for display: "Women over 50"; null for none.
    double share;                    ///< Share of the group, above 0; shares are divided by their sum.
    uint8_t unitClass;               ///< Class, for roles; 0 for none.
    MusterDistribution speed;        ///< Top speed in the open, 0 or 0.01 to 50 [m/s].
    MusterDistribution radius;       ///< Radius of the body, 0 or 0.05 to 1.5 [m].
    MusterDistribution headway;      ///< Time that it keeps from who is ahead, 0 or 0.02 to 5 [s].
    MusterDistribution premovement;  ///< Time until it sets out on its first order, 0 to 1e7 [s].
    MusterDistribution age;          ///< Age, 0 or 5 to 90 [years]; above 0 it gives the top speed in the
                                     ///< place of `speed`, as RiMEA has it.
    double upstairs;                 ///< Speed up stairs as a share of that in the open, 0 or 0.01 to 1.
    double downstairs;               ///< Speed down stairs as a share of that in the open, 0 or 0.01 to 1.
} MusterPeopleDef;
/// One sort, by the parameters.
MUSTER_API MusterPeopleDef muster_default_people_def(void);

/// Describes a formation in its local axes: it faces +x, its centre is the origin.
typedef struct MusterFormationDef {
    uint32_t structVersion;      ///< Set by muster_default_formation_def().
    MusterFormationKind kind;    ///< Shape.
    double spacing;              ///< Distance between neighbouring places, 0.05 to 100 [m].
    double opening;              ///< Full angle of Pacman's mouth or of the crescent's gap, above 0 and at
                                 ///< most 6 [rad].
    MusterPolygon outline;       ///< For Outline: the shape, in any size [m].
    const MusterPolygon* holes;  ///< Its holes, clockwise, apart from each other [m].
    int32_t holeCount;           ///< Their number.
    const MusterVec2* points;    ///< For Points: the places in this order [m]; at least as many as
                                 ///< characters.
    int32_t pointCount;          ///< Their number.
    int32_t files;               ///< For Square: how many stand abreast, 0 to 200,000; 0 for about as many as
                                 ///< there are ranks.
} MusterFormationDef;
/// A square at 1 m.
MUSTER_API MusterFormationDef muster_default_formation_def(void);

/// One order of a group.
typedef struct MusterOrder {
    uint32_t structVersion;               ///< Set by muster_default_order().
    MusterOrderKind kind;                 ///< What it asks for.
    MusterManner manner;                  ///< How it goes.
    MusterTurn turn;                      ///< How it turns on a march.
    MusterVec2 target;                    ///< Centre of the formation at the end [m]; of the rectangle for
                                          ///< Guard.
    bool hasFacing;                       ///< False: that of the last stretch.
    double facing;                        ///< Heading at the end [rad].
    double width;                         ///< Width of the front of a formation in ranks (square, line,
                                          ///< column), which becomes a square of so many files [m]; 0 for its
                                          ///< own. Other shapes keep theirs.
    const MusterVec2* route;              ///< Drawn way to the target [m]; followed as drawn, round
                                          ///< obstacles.
    int32_t routeCount;                   ///< Their number.
    const MusterFormationDef* formation;  ///< New formation, which is taken up on the way; null to keep it.
    double pace;                          ///< Speed of a march [m/s]; 0 for as fast as all can keep up with.
    double share;                         ///< Share of the group that must have arrived before the next order
                                          ///< begins, (0, 1].
    MusterGroupId group;                  ///< For Follow and Guard: the group to stay with; 0 for a character
                                          ///< or a place.
    MusterCharacterId character;          ///< For Follow and Guard: id of the character to stay with; 0 for
                                          ///< none.
    MusterVec2 offset;                    ///< For Follow: from its centre to the formation's, in its axes
                                          ///< [m].
    MusterVec2 halfSize;                  ///< For Guard: half the length and half the width of the rectangle
                                          ///< [m].
    MusterTimedPath path;                 ///< For Guard: how the rectangle moves from `target` on.
    const MusterAreaId* exits;            ///< For Leave: by which exits; none for all.
    int32_t exitCount;                    ///< Their number.
    MusterExitChoice choice;              ///< For Leave: by which of them each goes.
    const double* attractions;            ///< For Leave: seconds by which each of `exits` counts as nearer
                                          ///< than it is, -1e6 to 1e6 [s].
    int32_t attractionCount;              ///< Their number.
    double herding;                       ///< For Leave: seconds by which an exit counts as nearer if all
                                          ///< others nearby choose it, 0 to 1e6 [s].
    double misjudgement;                  ///< For Leave: deviation of the error by which each misjudges the
                                          ///< time by an exit, drawn by the world's seed, 0 to 1e6 [s].
    MusterAreaId area;                    ///< For Wait: the waiting area.
    double seconds;                       ///< For Wait: how long, from when its share has come, 0 to 1e9 [s];
                                          ///< 0 for no end.
} MusterOrder;
/// A move to the origin.
MUSTER_API MusterOrder muster_default_order(void);

/// An order in a group's queue.
typedef struct MusterQueuedOrder {
    MusterOrderId id;   ///< Unique in the world; it is not used again.
    MusterOrder order;  ///< What is to be done.
} MusterQueuedOrder;

/// How a group behaves, whatever its orders.
typedef struct MusterConduct {
    MusterStance stance;  ///< Who makes room.
    double cohesion;      ///< 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1].
    double squeeze;       ///< Share of its width that it may give up in narrow passages, [0, 1]; 0 for none.
    bool avoids;          ///< True: its mesh gives way to other meshes and to moving obstacles.
} MusterConduct;
/// Everybody at their own pace, any squeeze.
MUSTER_API MusterConduct muster_default_conduct(void);

/// A group of characters with one mesh.
typedef struct MusterGroupDef {
    uint32_t structVersion;         ///< Set by muster_default_group_def().
    const char* name;               ///< Name for display; null for none.
    int32_t count;                  ///< Number of characters, 1 to 200,000, or 0 where a source sends some;
                                    ///< at most 5,000 in all groups with exact plans.
    MusterFormationDef formation;   ///< Shape and spacing of the places.
    MusterVec2 position;            ///< Centre of the formation [m].
    double angle;                   ///< Heading, counter-clockwise from +x [rad].
    const MusterVec2* starts;       ///< Initial positions of characters [m]; none to start on their places.
    int32_t startCount;             ///< Their number.
    double jitter;                  ///< Largest random displacement of initial positions, 0 or more [m].
    const MusterBody* bodies;       ///< One for all, or one for each character; none for the parameters'.
    int32_t bodyCount;              ///< Their number.
    const MusterRoleDef* roles;     ///< Which class stands where.
    int32_t roleCount;              ///< Their number.
    const double* demands;          ///< Units of supply that each place demands; none for 1 each.
    int32_t demandCount;            ///< Their number.
    MusterConduct conduct;          ///< How it behaves.
    const MusterOrder* orders;      ///< What it is to do at first, one after the other.
    int32_t orderCount;             ///< Their number.
    bool patrols;                   ///< True: orders that are done come last again.
    bool hasColour;                 ///< False: the palette's.
    uint32_t colour;                ///< Colour for display, 0xRRGGBB.
    bool hasBuild;                  ///< False: both, by the character's id.
    MusterBodyBuild build;          ///< Build of its drawn bodies.
    bool hasMotions;                ///< False: the plain manner.
    MusterMotionSet motions;        ///< How it walks and jogs.
    const MusterPeopleDef* people;  ///< Sorts of persons, who also come by sources. A number that a sort
                                    ///< draws goes before that of `bodies`; what it does not draw, and
                                    ///< acceleration, mass and supply, is that of `bodies`.
    int32_t peopleCount;            ///< Their number.
} MusterGroupDef;
/// 36 characters in a square at the origin.
MUSTER_API MusterGroupDef muster_default_group_def(void);

/// The colour of a group.
typedef struct MusterGroupColour {
    bool hasColour;   ///< False: the palette's.
    uint32_t colour;  ///< Colour for display, 0xRRGGBB.
} MusterGroupColour;

/// How the people of a group look.
typedef struct MusterGroupLook {
    bool hasBuild;            ///< False: both, by the character's id.
    MusterBodyBuild build;    ///< Build of its drawn bodies.
    bool hasMotions;          ///< False: the plain manner.
    MusterMotionSet motions;  ///< How it walks and jogs.
} MusterGroupLook;

/// A disc that changes the formation of a group which passes it.
typedef struct MusterCheckpointDef {
    uint32_t structVersion;           ///< Set by muster_default_checkpoint_def().
    MusterVec2 position;              ///< Centre [m].
    double radius;                    ///< Radius, above 0 [m].
    MusterFormationDef formation;     ///< New formation of the group.
    int32_t group;                    ///< Index of the group that it applies to; -1 for all groups.
    bool once;                        ///< True: it applies once per group. False: whenever a group enters.
    MusterCheckpointTrigger trigger;  ///< What passes it.
    double share;                     ///< For Crowd: share of the group, (0, 1].
} MusterCheckpointDef;
/// 2 m round the origin, for half of any group.
MUSTER_API MusterCheckpointDef muster_default_checkpoint_def(void);

/// Describes a world.
typedef struct MusterWorldDef {
    uint32_t structVersion;                  ///< Set by muster_default_world_def().
    const char* name;                        ///< Title for display; null for none.
    const char* description;                 ///< Description in one or two sentences; null for none.
    const char* credit;                      ///< Credit for the data it uses; null for none.
    const char* gestures;                    ///< File of its gestures, in the scenario's folder or below,
                                             ///< which worlds do not read; null for none.
    MusterBox box;                           ///< Extent of the ground [m].
    double cell;                             ///< Edge of a ground cell, above 0 [m].
    uint64_t seed;                           ///< Seed of all random numbers.
    const MusterClipFacts* clips;            ///< Facts of clips, which patches name by their index.
    int32_t clipCount;                       ///< Their number.
    const MusterObstacleDef* obstacles;      ///< At most 20,000 obstacles.
    int32_t obstacleCount;                   ///< Their number.
    const MusterPatchDef* patches;           ///< At most 20,000 patches.
    int32_t patchCount;                      ///< Their number.
    const MusterMapDef* map;                 ///< Map that adds obstacles and patches; null for no map.
    const MusterGroupDef* groups;            ///< At most 20,000 groups.
    int32_t groupCount;                      ///< Their number.
    const MusterCheckpointDef* checkpoints;  ///< Discs that change formations.
    int32_t checkpointCount;                 ///< Their number.
    const MusterItemDef* items;              ///< Items to collect.
    int32_t itemCount;                       ///< Their number.
    const MusterAreaDef* areas;              ///< Exits, sources and waiting areas; at most 1,000.
    int32_t areaCount;                       ///< Their number.
    bool ring;                               ///< True: the left and the right side of `box` are joined. Who
                                             ///< walks out on one side comes in on the other.
    const char* preset;                      ///< Preset of parameters, "units", "people" or "paper"; null for
                                             ///< "units".
    const MusterParameterValue* parameters;  ///< Parameters that differ from the preset, set in this order.
    int32_t parameterCount;                  ///< Their number.
} MusterWorldDef;
/// 32 m by 32 m of empty ground round the origin, with Muster's own clips.
MUSTER_API MusterWorldDef muster_default_world_def(void);

#ifdef __cplusplus
}
#endif

#endif
