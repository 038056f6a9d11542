/* Made by schema/generate.mjs from schema/commands.txt: change these, not this file. */
#ifndef MUSTER_C_COMMAND_BODIES_H
#define MUSTER_C_COMMAND_BODIES_H

#include "muster/c/definitions.h"

#ifdef __cplusplus
extern "C" {
#endif

/// A finger touches down, moves or lifts, or its control ends at once. One that comes down edits the group
/// whose mesh is nearest within `input.reach`, or `group` if given; when it has lifted, its trajectory is
/// still followed.
typedef struct MusterTouch {
    MusterTouchPhase phase;  ///< What it does.
    uint32_t touch;          ///< Number of the finger, unique per client while it is down.
    MusterVec2 position;     ///< For Down and Move: position in the world [m].
    double time;             ///< World time stamp [s]; not read for Cancel.
    MusterGroupId group;     ///< For Down: group to edit; 0 to pick it by position.
} MusterTouch;

/// Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted
/// like touches.
typedef struct MusterAddControl {
    MusterGroupId group;          ///< Group whose mesh it controls.
    MusterControlKind kind;       ///< Kind of control, which must fit the number of touches.
    const uint32_t* touches;      ///< Numbers of its fingers, 1 to 64.
    int32_t touchCount;           ///< Their number.
    const MusterVec2* positions;  ///< Positions in the world, one per touch [m].
    int32_t positionCount;        ///< Their number.
    double time;                  ///< World time stamp [s].
} MusterAddControl;

/// Pins a control at the end of its trajectory, releases it, or ends it at once.
typedef struct MusterEditControl {
    MusterGroupId group;      ///< Group that the control belongs to.
    MusterControlId control;  ///< Its id.
    MusterControlEdit edit;   ///< What is done to it.
} MusterEditControl;

/// A client has disconnected: all its fingers lift.
typedef struct MusterReleaseClient {
    uint8_t unused;  ///< Not used; 0.
} MusterReleaseClient;

/// Changes what a group is. What is not given stays as it is. First comes the formation with its number of
/// places, then the sorts of people, who joins or leaves, and all else. Where one of them cannot be, none is
/// changed.
typedef struct MusterChangeGroup {
    MusterGroupId group;                  ///< Group to change.
    const MusterFormationDef* formation;  ///< Its formation; null for the one that it has.
    bool hasCount;                        ///< False: the number that it has.
    int32_t count;                        ///< Its number of characters: new ones join behind the mesh, those
                                          ///< with the highest ids leave first.
    bool hasPeople;                       ///< False: the sorts that it has.
    const MusterPeopleDef* people;        ///< Its sorts of persons, none where all are as GroupDef::bodies
                                          ///< say. Persons who join it are drawn by them from now on. Its
                                          ///< present members are drawn again, as those who come at once:
                                          ///< each number that neither the sorts before nor these draw stays
                                          ///< as it is. A person who has heard an order sets out when it was
                                          ///< to.
    int32_t peopleCount;                  ///< Their number.
    const MusterConduct* conduct;         ///< How it behaves; null for as it does.
    bool hasRoles;                        ///< False: the roles that it has.
    const MusterRoleDef* roles;           ///< Which class stands where, in the order in which they choose
                                          ///< places.
    int32_t roleCount;                    ///< Their number.
    bool hasDemands;                      ///< False: the demands that these have.
    const double* demands;                ///< How many units of supply each place demands (SPEC A1), 0 to
                                          ///< 1000, of each place, or none for 1 each.
    int32_t demandCount;                  ///< Their number.
    bool hasName;                         ///< False: the one that it has.
    const char* name;                     ///< Its name, of at most 4,096 bytes.
    const MusterGroupColour* colour;      ///< Its colour; null for the one that it has.
    const MusterGroupLook* look;          ///< How its people look; null for as they do.
} MusterChangeGroup;

/// Moves the mesh of a group at once; its places and its characters walk there, or stand there at once. Its
/// orders and controls end.
typedef struct MusterSetPose {
    MusterGroupId group;  ///< Group to move.
    MusterVec2 position;  ///< New centre of the mesh in the world [m].
    double angle;         ///< New heading, counter-clockwise from +x [rad].
    bool characters;      ///< True: its places and characters are there at once, and stand still.
} MusterSetPose;

/// Adds a group.
typedef struct MusterAddGroup {
    MusterGroupDef group;  ///< Its definition.
} MusterAddGroup;

/// Removes a group and its characters.
typedef struct MusterRemoveGroup {
    MusterGroupId group;  ///< Group to remove.
} MusterRemoveGroup;

/// Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says
/// what it is. An item that is collected stays so, and a checkpoint stays passed by the groups that have
/// passed it.
typedef struct MusterPutThing {
    uint32_t id;                            ///< Thing that gets another definition; 0 to add one.
    const MusterObstacleDef* obstacle;      ///< An obstacle; null for other things.
    const MusterPatchDef* patch;            ///< A patch; null for other things.
    const MusterItemDef* item;              ///< An item to collect; null for other things.
    const MusterCheckpointDef* checkpoint;  ///< A formation checkpoint (SPEC M7), whose `group` is not read;
                                            ///< null for other things.
    const MusterAreaDef* area;              ///< An area, whose `group` is not read; null for other things.
    MusterGroupId group;                    ///< Group that a checkpoint concerns, 0 for any, or that people
                                            ///< of a source join.
} MusterPutThing;

/// Removes a thing. People on their way to an area that is removed go to the other areas of their order, or
/// stand.
typedef struct MusterRemoveThing {
    MusterThingKind thing;  ///< What it is.
    uint32_t id;            ///< Its id.
} MusterRemoveThing;

/// Changes the value of a parameter.
typedef struct MusterSetParameter {
    const char* name;  ///< Name in parameterTable(): "plan.exponent"; null for none.
    double value;      ///< New value, in the range of the parameter.
} MusterSetParameter;

/// Puts an order into a group's queue. The event OrderGiven tells its id.
typedef struct MusterGiveOrder {
    MusterGroupId group;   ///< The group.
    MusterQueueMode mode;  ///< Where the order stands in the queue.
    uint32_t index;        ///< For Insert: before which order, counted from 0.
    MusterOrder order;     ///< The order.
} MusterGiveOrder;

/// Changes a group's queue.
typedef struct MusterEditQueue {
    MusterGroupId group;   ///< The group.
    MusterQueueEdit edit;  ///< What is done to the queue.
    MusterOrderId order;   ///< For Cancel: the id of the order; 0 for all.
} MusterEditQueue;

/// Characters join a group where they stand; places are added to its formation. Events Joined tell their ids.
typedef struct MusterAddCharacters {
    MusterGroupId group;          ///< Group that they join.
    const MusterVec2* positions;  ///< Where they stand [m]; they part where they would stand in each other.
    int32_t positionCount;        ///< Their number.
    const MusterBody* bodies;     ///< One for each, or one for all; none for that of the group.
    int32_t bodyCount;            ///< Their number.
} MusterAddCharacters;

/// Characters leave their groups for another one, or leave the world. Ids, positions and velocities stay. The
/// ranks behind them close up; a group may become empty, and stays.
typedef struct MusterTransferCharacters {
    const MusterCharacterId* ids;  ///< Their ids.
    int32_t idCount;               ///< Their number.
    MusterGroupId group;           ///< Group that they join; 0 to leave the world.
} MusterTransferCharacters;

/// Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops,
/// and all parts go on with the orders of the whole.
typedef struct MusterSplitGroup {
    MusterGroupId group;           ///< The group.
    MusterSplitBy by;              ///< How it is divided.
    const MusterCharacterId* ids;  ///< For Ids: the characters that leave.
    int32_t idCount;               ///< Their number.
    const MusterVec2* points;      ///< For Line: two points [m]; for Lasso: the corners of the polygon.
    int32_t pointCount;            ///< Their number.
    const double* shares;          ///< For Shares: of all parts, above 0; their sum counts as the whole.
    int32_t shareCount;            ///< Their number.
    bool abreast;                  ///< For Shares: parts lie side by side, not one behind the other.
    MusterPartShape shape;         ///< Formation of the parts.
} MusterSplitGroup;

/// Joins groups to the first of them; the others end.
typedef struct MusterMergeGroups {
    const MusterGroupId* groups;  ///< Two or more.
    int32_t groupCount;           ///< Their number.
    MusterPartShape shape;        ///< Smaller: the formation of the first for all; AsHeld: all places stay.
} MusterMergeGroups;

/// Changes what characters are. What is not given stays as it is.
typedef struct MusterChangeCharacters {
    const MusterCharacterId* ids;  ///< Their ids.
    int32_t idCount;               ///< Their number.
    bool hasBodies;                ///< False: those that they have.
    const MusterBody* bodies;      ///< Their bodies, one for each or one for all.
    int32_t bodyCount;             ///< Their number.
    bool hasDriver;                ///< False: what moves them now.
    MusterDriver driver;           ///< What moves them.
} MusterChangeCharacters;

/// Where characters that are moved from outside are after this step.
typedef struct MusterWriteMotion {
    const MusterCharacterId* ids;  ///< Their ids.
    int32_t idCount;               ///< Their number.
    const MusterVec2* positions;   ///< Where they are [m].
    int32_t positionCount;         ///< Their number.
    const MusterVec2* velocities;  ///< Their velocities [m/s]; none for what follows from the last positions.
    int32_t velocityCount;         ///< Their number.
} MusterWriteMotion;

/// Reverses the orders of a group's queue: the last one begins, and what is under way comes last.
typedef struct MusterReverseQueue {
    MusterGroupId group;  ///< The group.
} MusterReverseQueue;

/// Kinds of commands.
typedef int32_t MusterCommandKind;
/// Values of MusterCommandKind.
enum MusterCommandKindValue {
    MUSTER_COMMAND_TOUCH = 0,                 ///< Its body is `touch`.
    MUSTER_COMMAND_ADD_CONTROL = 1,           ///< Its body is `addControl`.
    MUSTER_COMMAND_EDIT_CONTROL = 2,          ///< Its body is `editControl`.
    MUSTER_COMMAND_RELEASE_CLIENT = 3,        ///< Its body is `releaseClient`.
    MUSTER_COMMAND_CHANGE_GROUP = 4,          ///< Its body is `changeGroup`.
    MUSTER_COMMAND_SET_POSE = 5,              ///< Its body is `setPose`.
    MUSTER_COMMAND_ADD_GROUP = 6,             ///< Its body is `addGroup`.
    MUSTER_COMMAND_REMOVE_GROUP = 7,          ///< Its body is `removeGroup`.
    MUSTER_COMMAND_PUT_THING = 8,             ///< Its body is `putThing`.
    MUSTER_COMMAND_REMOVE_THING = 9,          ///< Its body is `removeThing`.
    MUSTER_COMMAND_SET_PARAMETER = 10,        ///< Its body is `setParameter`.
    MUSTER_COMMAND_GIVE_ORDER = 11,           ///< Its body is `giveOrder`.
    MUSTER_COMMAND_EDIT_QUEUE = 12,           ///< Its body is `editQueue`.
    MUSTER_COMMAND_ADD_CHARACTERS = 13,       ///< Its body is `addCharacters`.
    MUSTER_COMMAND_TRANSFER_CHARACTERS = 14,  ///< Its body is `transferCharacters`.
    MUSTER_COMMAND_SPLIT_GROUP = 15,          ///< Its body is `splitGroup`.
    MUSTER_COMMAND_MERGE_GROUPS = 16,         ///< Its body is `mergeGroups`.
    MUSTER_COMMAND_CHANGE_CHARACTERS = 17,    ///< Its body is `changeCharacters`.
    MUSTER_COMMAND_WRITE_MOTION = 18,         ///< Its body is `writeMotion`.
    MUSTER_COMMAND_REVERSE_QUEUE = 19,        ///< Its body is `reverseQueue`.
    MUSTER_COMMAND_COUNT = 20                 ///< Number of kinds.
};

/// What a command of each kind says. Only the member of the command's kind is read.
typedef union MusterCommandBody {
    MusterTouch touch;                            ///< For MUSTER_COMMAND_TOUCH.
    MusterAddControl addControl;                  ///< For MUSTER_COMMAND_ADD_CONTROL.
    MusterEditControl editControl;                ///< For MUSTER_COMMAND_EDIT_CONTROL.
    MusterReleaseClient releaseClient;            ///< For MUSTER_COMMAND_RELEASE_CLIENT.
    MusterChangeGroup changeGroup;                ///< For MUSTER_COMMAND_CHANGE_GROUP.
    MusterSetPose setPose;                        ///< For MUSTER_COMMAND_SET_POSE.
    MusterAddGroup addGroup;                      ///< For MUSTER_COMMAND_ADD_GROUP.
    MusterRemoveGroup removeGroup;                ///< For MUSTER_COMMAND_REMOVE_GROUP.
    MusterPutThing putThing;                      ///< For MUSTER_COMMAND_PUT_THING.
    MusterRemoveThing removeThing;                ///< For MUSTER_COMMAND_REMOVE_THING.
    MusterSetParameter setParameter;              ///< For MUSTER_COMMAND_SET_PARAMETER.
    MusterGiveOrder giveOrder;                    ///< For MUSTER_COMMAND_GIVE_ORDER.
    MusterEditQueue editQueue;                    ///< For MUSTER_COMMAND_EDIT_QUEUE.
    MusterAddCharacters addCharacters;            ///< For MUSTER_COMMAND_ADD_CHARACTERS.
    MusterTransferCharacters transferCharacters;  ///< For MUSTER_COMMAND_TRANSFER_CHARACTERS.
    MusterSplitGroup splitGroup;                  ///< For MUSTER_COMMAND_SPLIT_GROUP.
    MusterMergeGroups mergeGroups;                ///< For MUSTER_COMMAND_MERGE_GROUPS.
    MusterChangeCharacters changeCharacters;      ///< For MUSTER_COMMAND_CHANGE_CHARACTERS.
    MusterWriteMotion writeMotion;                ///< For MUSTER_COMMAND_WRITE_MOTION.
    MusterReverseQueue reverseQueue;              ///< For MUSTER_COMMAND_REVERSE_QUEUE.
} MusterCommandBody;

#ifdef __cplusplus
}
#endif

#endif
