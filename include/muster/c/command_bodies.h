/* What the commands of each kind say. */
#ifndef MUSTER_C_COMMAND_BODIES_H
#define MUSTER_C_COMMAND_BODIES_H

#include "muster/c/world_def.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Kind of a control by its number of points.
typedef uint8_t MusterControlKind;
/// Values of MusterControlKind.
enum MusterControlKindValue {
    MUSTER_CONTROL_POINT = 0,  ///< One point.
    MUSTER_CONTROL_LINE = 1,   ///< Two.
    MUSTER_CONTROL_AREA = 2    ///< Three and more.
};

/// A finger touches down. It edits the group whose mesh is nearest within `input.reach`, or `group` if given.
typedef struct MusterTouchDown {
    uint32_t touch;       ///< Number of the finger, unique per client while it is down.
    MusterVec2 position;  ///< Position in the world [m].
    double time;          ///< World time stamp [s].
    MusterGroupId group;  ///< Group to edit; 0 to pick it by position.
} MusterTouchDown;

/// A finger moves.
typedef struct MusterTouchMove {
    uint32_t touch;       ///< Number of the finger.
    MusterVec2 position;  ///< Position in the world [m].
    double time;          ///< World time stamp [s].
} MusterTouchMove;

/// A finger lifts; its trajectory is still followed.
typedef struct MusterTouchUp {
    uint32_t touch;  ///< Number of the finger.
    double time;     ///< World time stamp [s].
} MusterTouchUp;

/// The control of a finger ends at once.
typedef struct MusterTouchCancel {
    uint32_t touch;  ///< Number of the finger.
} MusterTouchCancel;

/// Makes a control of all its points at once. Its points are then moved and lifted like touches.
typedef struct MusterAddControl {
    MusterGroupId group;          ///< Group whose mesh it controls.
    MusterControlKind kind;       ///< Kind of control, which must fit the number of touches.
    const uint32_t* touches;      ///< Numbers of its fingers.
    int32_t touchCount;           ///< Their number, 1 to 64.
    const MusterVec2* positions;  ///< Positions in the world [m], one per touch.
    int32_t positionCount;        ///< Their number.
    double time;                  ///< World time stamp [s].
} MusterAddControl;

/// Pins a control at the end of its trajectory, or releases it.
typedef struct MusterPinControl {
    MusterGroupId group;      ///< Group that the control belongs to.
    MusterControlId control;  ///< Its id.
    bool pinned;              ///< False to release it.
} MusterPinControl;

/// Ends a control at once.
typedef struct MusterRemoveControl {
    MusterGroupId group;      ///< Group that the control belongs to.
    MusterControlId control;  ///< Its id.
} MusterRemoveControl;

/// A client has disconnected: all its fingers lift.
typedef struct MusterReleaseClient {
    uint8_t unused;  ///< Not used; 0.
} MusterReleaseClient;

/// The group takes another formation.
typedef struct MusterSetFormation {
    MusterGroupId group;           ///< Group to change.
    MusterFormationDef formation;  ///< Its new definition.
} MusterSetFormation;

/// Changes the number of characters. New ones join behind the mesh; the highest ids leave first.
typedef struct MusterSetCount {
    MusterGroupId group;  ///< Group to change.
    int32_t count;        ///< New number of characters, 1 to 200,000.
} MusterSetCount;

/// Moves the mesh at once; its places travel there.
typedef struct MusterSetPose {
    MusterGroupId group;  ///< Group to move.
    MusterVec2 position;  ///< New centre of the mesh in the world [m].
    double angle;         ///< New heading, counter-clockwise from +x [rad].
} MusterSetPose;

/// Adds a group.
typedef struct MusterAddGroup {
    MusterGroupDef group;  ///< Its definition.
} MusterAddGroup;

/// Removes a group and its characters.
typedef struct MusterRemoveGroup {
    MusterGroupId group;  ///< Group to remove.
} MusterRemoveGroup;

/// Adds an obstacle.
typedef struct MusterAddObstacle {
    MusterObstacleDef obstacle;  ///< Its definition.
} MusterAddObstacle;

/// Changes shape, position, path or field of an obstacle.
typedef struct MusterChangeObstacle {
    MusterObstacleId id;         ///< Its id.
    MusterObstacleDef obstacle;  ///< Its new definition.
} MusterChangeObstacle;

/// Removes an obstacle.
typedef struct MusterRemoveObstacle {
    MusterObstacleId id;  ///< Its id.
} MusterRemoveObstacle;

/// Adds a patch.
typedef struct MusterAddPatch {
    MusterPatchDef patch;  ///< Its definition.
} MusterAddPatch;

/// Changes shape, position, path or motion of a patch.
typedef struct MusterChangePatch {
    MusterPatchId id;      ///< Its id.
    MusterPatchDef patch;  ///< Its new definition.
} MusterChangePatch;

/// Removes a patch.
typedef struct MusterRemovePatch {
    MusterPatchId id;  ///< Its id.
} MusterRemovePatch;

/// Changes the value of a parameter.
typedef struct MusterSetParameter {
    const char* name;  ///< Name as muster_parameter_info() gives it: "plan.exponent".
    double value;      ///< New value, in the range of the parameter.
} MusterSetParameter;

/// Puts an order into a group's queue. The event OrderGiven gives its id.
typedef struct MusterGiveOrder {
    MusterGroupId group;   ///< Who.
    MusterQueueMode mode;  ///< Where it stands in the queue.
    uint32_t index;        ///< For Insert: before which order, counted from 0.
    MusterOrder order;     ///< What.
} MusterGiveOrder;

/// Changes a group's queue.
typedef struct MusterEditQueue {
    MusterGroupId group;   ///< Whose.
    MusterQueueEdit edit;  ///< What is done to it.
    MusterOrderId order;   ///< For Cancel: the id of the order; 0 for all.
} MusterEditQueue;

/// Tells a group how to behave.
typedef struct MusterSetConduct {
    MusterGroupId group;    ///< Whom.
    MusterConduct conduct;  ///< How.
} MusterSetConduct;

/// Characters join a group where they stand. Events Joined give their ids.
typedef struct MusterAddCharacters {
    MusterGroupId group;          ///< Which they join.
    const MusterVec2* positions;  ///< Where they stand [m]; they part where they would stand in each other.
    int32_t positionCount;        ///< Their number.
    const MusterBody* bodies;     ///< One for each, or one for all; none for that of the group.
    int32_t bodyCount;            ///< Their number.
} MusterAddCharacters;

/// Characters leave the world; the ranks behind them close up. A group may become empty, and stays.
typedef struct MusterRemoveCharacters {
    const MusterCharacterId* ids;  ///< Who.
    int32_t idCount;               ///< Their number.
} MusterRemoveCharacters;

/// Characters leave their groups for another one. Ids, positions and velocities stay.
typedef struct MusterTransferCharacters {
    const MusterCharacterId* ids;  ///< Who.
    int32_t idCount;               ///< Their number.
    MusterGroupId group;           ///< Which they join.
} MusterTransferCharacters;

/// Divides a group. The part that leaves is a new group, whose id the event GroupAdded gives.
typedef struct MusterSplitGroup {
    MusterGroupId group;           ///< Which.
    MusterSplitBy by;              ///< How.
    const MusterCharacterId* ids;  ///< For Ids: who leaves.
    int32_t idCount;               ///< Their number.
    const MusterVec2* points;      ///< For Line: two points; for Lasso: the corners of the polygon [m].
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

/// Gives characters other bodies.
typedef struct MusterSetBodies {
    const MusterCharacterId* ids;  ///< Whose.
    int32_t idCount;               ///< Their number.
    const MusterBody* bodies;      ///< One for each, or one for all.
    int32_t bodyCount;             ///< Their number.
} MusterSetBodies;

/// Says which class stands where in a formation.
typedef struct MusterSetRoles {
    MusterGroupId group;         ///< Whose.
    const MusterRoleDef* roles;  ///< In the order in which they choose places; none for no roles.
    int32_t roleCount;           ///< Their number.
} MusterSetRoles;

/// Says how many units of supply each place demands.
typedef struct MusterSetDemands {
    MusterGroupId group;    ///< Whose.
    const double* demands;  ///< Of each place, 0 to 1000; none for 1 each.
    int32_t demandCount;    ///< Their number.
} MusterSetDemands;

/// Says who moves characters.
typedef struct MusterSetDriver {
    const MusterCharacterId* ids;  ///< Whom.
    int32_t idCount;               ///< Their number.
    MusterDriver driver;           ///< Who moves them.
} MusterSetDriver;

/// Where characters that are moved from outside are after this step.
typedef struct MusterWriteMotion {
    const MusterCharacterId* ids;  ///< Who.
    int32_t idCount;               ///< Their number.
    const MusterVec2* positions;   ///< Where [m].
    int32_t positionCount;         ///< Their number.
    const MusterVec2* velocities;  ///< How fast [m/s]; none for what follows from the last positions.
    int32_t velocityCount;         ///< Their number.
} MusterWriteMotion;

/// Adds an item to collect.
typedef struct MusterAddItem {
    MusterItemDef item;  ///< Its definition.
} MusterAddItem;

/// Moves an item or changes its radius. Whether it is collected stays.
typedef struct MusterChangeItem {
    MusterItemId id;     ///< Its id.
    MusterItemDef item;  ///< Its new definition.
} MusterChangeItem;

/// Removes an item.
typedef struct MusterRemoveItem {
    MusterItemId id;  ///< Its id.
} MusterRemoveItem;

/// Adds a formation checkpoint, which nobody has passed yet.
typedef struct MusterAddCheckpoint {
    MusterCheckpointDef checkpoint;  ///< Its definition; its `group` is not read.
    MusterGroupId group;             ///< Whom it concerns; 0 for any group.
} MusterAddCheckpoint;

/// Changes a formation checkpoint. Who has passed it stays.
typedef struct MusterChangeCheckpoint {
    MusterCheckpointId id;           ///< Its id.
    MusterCheckpointDef checkpoint;  ///< Its new definition; its `group` is not read.
    MusterGroupId group;             ///< Whom it concerns; 0 for any group.
} MusterChangeCheckpoint;

/// Removes a formation checkpoint.
typedef struct MusterRemoveCheckpoint {
    MusterCheckpointId id;  ///< Its id.
} MusterRemoveCheckpoint;

/// Puts a group elsewhere at once, with its characters. Its orders and controls end.
typedef struct MusterPlaceGroup {
    MusterGroupId group;  ///< Which.
    MusterVec2 position;  ///< New centre of the formation [m].
    double angle;         ///< New heading, counter-clockwise from +x [rad].
} MusterPlaceGroup;

/// Gives a group another name.
typedef struct MusterNameGroup {
    MusterGroupId group;  ///< Which.
    const char* name;     ///< At most 4,096 bytes; null for none.
} MusterNameGroup;

/// Gives a group another colour.
typedef struct MusterColourGroup {
    MusterGroupId group;  ///< Which.
    bool hasColour;       ///< False: the palette's, by the group's id.
    uint32_t colour;      ///< 0xRRGGBB.
} MusterColourGroup;

/// Gives the people of a group another appearance.
typedef struct MusterSetAppearance {
    MusterGroupId group;      ///< Which.
    bool hasBuild;            ///< False: bodies of both builds, by the character's id.
    MusterBodyBuild build;    ///< Build of its drawn bodies.
    bool hasMotions;          ///< False: the plain manner.
    MusterMotionSet motions;  ///< How they walk and jog.
} MusterSetAppearance;

/// Adds an area, or changes one.
typedef struct MusterPutArea {
    MusterAreaId id;      ///< Which is changed; 0 to add one.
    MusterAreaDef area;   ///< Its definition; its `group` is not read.
    MusterGroupId group;  ///< For Source: whom its people join.
} MusterPutArea;

/// Removes an area. Who was to go there goes to the others of its order, or stands.
typedef struct MusterRemoveArea {
    MusterAreaId id;  ///< Its id.
} MusterRemoveArea;

/// Gives a group other sorts of persons. Those who are in it are drawn again.
typedef struct MusterSetPeople {
    MusterGroupId group;            ///< Which.
    const MusterPeopleDef* people;  ///< Its sorts; none: all are as the bodies of the group say.
    int32_t peopleCount;            ///< Their number.
} MusterSetPeople;

#ifdef __cplusplus
}
#endif

#endif
