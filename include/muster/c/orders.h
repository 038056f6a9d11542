/* Units and orders: what characters are, what groups are to do, and how they behave meanwhile. */
#ifndef MUSTER_C_ORDERS_H
#define MUSTER_C_ORDERS_H

#include "muster/c/ground.h"

#ifdef __cplusplus
extern "C" {
#endif

typedef uint32_t MusterObstacleId;    ///< Names an obstacle of a world; 0 for none. It is not used again.
typedef uint32_t MusterPatchId;       ///< Names a patch of a world; 0 for none.
typedef uint32_t MusterGroupId;       ///< Names a group of a world; 0 for none.
typedef uint32_t MusterItemId;        ///< Names an item of a world; 0 for none.
typedef uint32_t MusterCheckpointId;  ///< Names a formation checkpoint of a world; 0 for none.
typedef uint32_t MusterAreaId;        ///< Names an exit, a source or a waiting area; 0 for none.
typedef uint32_t MusterControlId;     ///< Names a control of a world; 0 for none.
typedef uint32_t MusterCharacterId;   ///< Names a character of a world; 0 for none.
typedef uint32_t MusterOrderId;       ///< Names an order in a queue; 0 for none.

/// The body of a character. A number of 0 stands for the parameter of that name.
typedef struct MusterBody {
    double radius;        ///< Radius [m], 0 or 0.05 to 1.5.
    double maxSpeed;      ///< Top speed in the open [m/s], 0 or 0.01 to 50.
    double acceleration;  ///< Top acceleration [m/s^2], 0 or 0.01 to 1000.
    double mass;          ///< Mass in bodies of the usual mass, 0.01 to 1000: who is heavy gives way less.
    double supply;        ///< Units that it supplies to places, above 0 and at most 1000.
    uint8_t unitClass;    ///< Class, for roles; 0 for none.
    double headway;       ///< Time that it keeps from who is ahead [s], 0 or 0.02 to 5.
    double premovement;   ///< Time from its first order until it sets out [s], 0 to 1e7; no parameter.
    double upstairs;      ///< Speed up stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
    double downstairs;    ///< Speed down stairs as a share of that in the open, 0.01 to 1; 0: the stairs'.
} MusterBody;

/// A body by the parameters, of mass and supply 1.
MUSTER_API MusterBody muster_default_body(void);

/// Characters of a class take their places in a part of the formation.
typedef struct MusterRoleDef {
    MusterRoleArea area;  ///< Where.
    uint8_t unitClass;    ///< Who, 1 or more.
} MusterRoleDef;

/// One order of a group.
typedef struct MusterOrder {
    uint32_t structVersion;   ///< Set by muster_default_order().
    MusterOrderKind kind;     ///< What it asks for.
    MusterManner manner;      ///< How it goes.
    MusterTurn turn;          ///< How it turns on a march.
    MusterVec2 target;        ///< Centre of the formation at the end; of the rectangle for Guard [m].
    bool hasFacing;           ///< False: the heading of the last stretch.
    double facing;            ///< Heading at the end [rad].
    double width;             ///< Width of the front in ranks [m]; 0 for the formation's own.
    const MusterVec2* route;  ///< Drawn way to the target [m]; followed as drawn, round obstacles.
    int32_t routeCount;       ///< Number of its points.
    const MusterFormationDef* formation;  ///< New formation, which is taken up on the way; null to keep it.
    double pace;                          ///< Speed of a march [m/s]; 0 for as fast as all can keep up with.
    double share;                 ///< Share that must have arrived before the next order begins, (0, 1].
    MusterGroupId group;          ///< For Follow and Guard: the group to stay with; 0 for none.
    MusterCharacterId character;  ///< For Follow and Guard: the character to stay with; 0 for none.
    MusterVec2 offset;            ///< For Follow: from its centre to the formation's, in its axes [m].
    MusterVec2 halfSize;          ///< For Guard: half the length and half the width [m].
    MusterTimedPath path;         ///< For Guard: how the rectangle moves from `target` on.
    const MusterAreaId* exits;    ///< For Leave: by which exits; none for all.
    int32_t exitCount;            ///< Their number.
    MusterExitChoice choice;      ///< For Leave: by which of them each goes.
    const double* attractions;    ///< For Leave: seconds by which each of `exits` counts as nearer; or none.
    int32_t attractionCount;      ///< Their number: that of `exits`, or 0.
    double herding;  ///< For Leave: seconds by which an exit counts as nearer if all others nearby choose
                     ///< it, 0 to 1e6.
    double misjudgement;  ///< For Leave: deviation of the error by which each misjudges the time by an exit
                          ///< [s], 0 to 1e6.
    MusterAreaId area;    ///< For Wait: the waiting area.
    double seconds;       ///< For Wait: how long, from when its share has come, 0 to 1e9; 0 for no end.
} MusterOrder;

/// A move to the origin.
MUSTER_API MusterOrder muster_default_order(void);
/// Takes up a front from `left` to `right` [m]: its middle, width and facing.
MUSTER_API MusterOrder muster_order_to_line(MusterVec2 left, MusterVec2 right);

/// How a group behaves, whatever its orders.
typedef struct MusterConduct {
    MusterStance stance;  ///< Who makes room.
    double cohesion;      ///< 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1].
    double squeeze;       ///< Share of its width that it may give up in narrow passages, [0, 1]; 0 for none.
    bool avoids;          ///< True: its mesh gives way to other meshes and to moving obstacles.
} MusterConduct;

/// Everybody at their own pace, any squeeze.
MUSTER_API MusterConduct muster_default_conduct(void);

/// An order in a group's queue.
typedef struct MusterQueuedOrder {
    MusterOrderId id;   ///< Unique in the world; it is not used again.
    MusterOrder order;  ///< What is to be done.
} MusterQueuedOrder;

/// What would come of an order.
typedef struct MusterForecast {
    uint32_t structVersion;  ///< Set by muster_default_forecast().
    bool arrives;            ///< True where the target can be reached.
    const MusterVec2* way;   ///< The way of the formation's centre, both ends included [m].
    int32_t wayCount;        ///< Number of its points.
    MusterVec2 end;  ///< Where the formation would stand: the target, or the nearest ground to it [m].
    double seconds;  ///< Time until it would arrive [s]; infinite where it never does.
} MusterForecast;

/// Nothing yet: to be filled by muster_world_forecast().
MUSTER_API MusterForecast muster_default_forecast(void);

#ifdef __cplusplus
}
#endif

#endif
