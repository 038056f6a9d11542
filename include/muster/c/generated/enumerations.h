/* Made by schema/generate.mjs from schema/enumerations.txt: change these, not this file. */
#ifndef MUSTER_C_ENUMERATIONS_H
#define MUSTER_C_ENUMERATIONS_H

#include <stdint.h>

/// The library of shapes.
typedef uint8_t MusterFormationKind;
/// Values of MusterFormationKind.
enum MusterFormationKindValue {
    MUSTER_FORMATION_SQUARE = 0,    ///< A filled square.
    MUSTER_FORMATION_LINE = 1,      ///< Two ranks abreast.
    MUSTER_FORMATION_COLUMN = 2,    ///< Two files along the heading.
    MUSTER_FORMATION_WEDGE = 3,     ///< A filled triangle with its tip in front.
    MUSTER_FORMATION_RING = 4,      ///< Concentric circles round an open middle.
    MUSTER_FORMATION_CIRCLE = 5,    ///< A filled disc.
    MUSTER_FORMATION_CRESCENT = 6,  ///< Concentric arcs, open to the front.
    MUSTER_FORMATION_PACMAN = 7,    ///< A disc with a mouth to the front.
    MUSTER_FORMATION_OUTLINE = 8,   ///< Any polygon with holes, scaled to hold the count at the spacing.
    MUSTER_FORMATION_POINTS = 9     ///< Explicit places; the mesh is made round them.
};

/// The build of drawn bodies.
typedef uint8_t MusterBodyBuild;
/// Values of MusterBodyBuild.
enum MusterBodyBuildValue {
    MUSTER_BODY_BUILD_BROAD = 0,  ///< Wide shoulders, short hair.
    MUSTER_BODY_BUILD_NARROW = 1  ///< Narrow shoulders, wider hips, tied hair.
};

/// A manner of walking and jogging, with clips of its own. Standing and what patches ask for is the same in
/// all.
typedef uint8_t MusterMotionSet;
/// Values of MusterMotionSet.
enum MusterMotionSetValue {
    MUSTER_MOTION_SET_MARCH = 0,  ///< Upright, with high knees and stiff arms.
    MUSTER_MOTION_SET_WEARY = 1   ///< Stooped, with hanging arms and feet that are hardly lifted.
};

/// The phase of the motion that a character performs (SPEC C1, C3, C4).
typedef uint8_t MusterMotionPhase;
/// Values of MusterMotionPhase.
enum MusterMotionPhaseValue {
    MUSTER_PHASE_STEADY = 0,    ///< It performs the motion of the ground it is on.
    MUSTER_PHASE_ENTERING = 1,  ///< It plays the transition into the motion.
    MUSTER_PHASE_LEAVING = 2,   ///< It plays the transition out of the motion.
    MUSTER_PHASE_LOCKED = 3     ///< It is within a single-step motion, which runs once per patch.
};

/// Kind of a control by its number of points: one, two, or three and more.
typedef uint8_t MusterControlKind;
/// Values of MusterControlKind.
enum MusterControlKindValue {
    MUSTER_CONTROL_POINT = 0,  ///< One point.
    MUSTER_CONTROL_LINE = 1,   ///< Two points.
    MUSTER_CONTROL_AREA = 2    ///< Three points and more.
};

/// What an area does.
typedef uint8_t MusterAreaKind;
/// Values of MusterAreaKind.
enum MusterAreaKindValue {
    MUSTER_AREA_EXIT = 0,    ///< People who are to leave by it go there, and leave the world in it.
    MUSTER_AREA_SOURCE = 1,  ///< People come into the world in it, where there is room.
    MUSTER_AREA_WAITING = 2  ///< People who are to wait in it spread in it and stand.
};

/// What stands or lies in the place.
typedef uint8_t MusterThingKind;
/// Values of MusterThingKind.
enum MusterThingKindValue {
    MUSTER_THING_OBSTACLE = 0,    ///< Something in the way.
    MUSTER_THING_PATCH = 1,       ///< Ground on which another motion is performed.
    MUSTER_THING_ITEM = 2,        ///< Something to collect.
    MUSTER_THING_CHECKPOINT = 3,  ///< Where a formation is asked for.
    MUSTER_THING_AREA = 4         ///< An exit, a source or a waiting area.
};

/// What passes a checkpoint.
typedef uint8_t MusterCheckpointTrigger;
/// Values of MusterCheckpointTrigger.
enum MusterCheckpointTriggerValue {
    MUSTER_CHECKPOINT_CROWD = 0,  ///< A share of the characters has been in it, or, up to a half, their
                                  ///< middle is.
    MUSTER_CHECKPOINT_MESH = 1    ///< The centre of the group's mesh is in it.
};

/// How a number is spread over persons.
typedef uint8_t MusterSpread;
/// Values of MusterSpread.
enum MusterSpreadValue {
    MUSTER_SPREAD_CONSTANT = 0,    ///< All have `a`.
    MUSTER_SPREAD_UNIFORM = 1,     ///< Evenly from `a` to `b`.
    MUSTER_SPREAD_NORMAL = 2,      ///< Mean `a`, standard deviation `b`.
    MUSTER_SPREAD_LOG_NORMAL = 3,  ///< Its logarithm has the mean `a` and the standard deviation `b`.
    MUSTER_SPREAD_GAMMA = 4,       ///< Shape `a`, at most 10,000, scale `b`.
    MUSTER_SPREAD_WEIBULL = 5      ///< Scale `a`, shape `b`.
};

/// Parts of a formation.
typedef uint8_t MusterRoleArea;
/// Values of MusterRoleArea.
enum MusterRoleAreaValue {
    MUSTER_ROLE_FRONT = 0,        ///< The foremost places.
    MUSTER_ROLE_REAR = 1,         ///< The hindmost.
    MUSTER_ROLE_RIM = 2,          ///< Those nearest to the outline.
    MUSTER_ROLE_CENTRE = 3,       ///< Those nearest to the middle.
    MUSTER_ROLE_LEFT_FLANK = 4,   ///< Those farthest to the left.
    MUSTER_ROLE_RIGHT_FLANK = 5,  ///< Those farthest to the right.
    MUSTER_ROLE_FLANKS = 6        ///< Those farthest from the middle line.
};

/// Who moves a character.
typedef uint8_t MusterDriver;
/// Values of MusterDriver.
enum MusterDriverValue {
    MUSTER_DRIVER_MUSTER = 0,  ///< Steering and contacts.
    MUSTER_DRIVER_OUTSIDE = 1  ///< Somebody else, by WriteMotion. Others keep clear of it.
};

/// How a group is divided.
typedef uint8_t MusterSplitBy;
/// Values of MusterSplitBy.
enum MusterSplitByValue {
    MUSTER_SPLIT_BY_IDS = 0,    ///< Those with the given ids leave.
    MUSTER_SPLIT_BY_LINE = 1,   ///< Those to the left of a line leave, as their places lie.
    MUSTER_SPLIT_BY_LASSO = 2,  ///< Those whose places lie in a polygon leave.
    MUSTER_SPLIT_BY_SHARES = 3  ///< Parts of given shares, front to back, or left to right.
};

/// The formation of parts.
typedef uint8_t MusterPartShape;
/// Values of MusterPartShape.
enum MusterPartShapeValue {
    MUSTER_PART_AS_HELD = 0,  ///< The places that they held.
    MUSTER_PART_SMALLER = 1   ///< The shape of the whole, for fewer.
};

/// What an order asks for.
typedef uint8_t MusterOrderKind;
/// Values of MusterOrderKind.
enum MusterOrderKindValue {
    MUSTER_ORDER_MOVE = 0,    ///< Go to `target`, by `route` if one is given.
    MUSTER_ORDER_FACE = 1,    ///< Turn to `facing` where it stands.
    MUSTER_ORDER_FOLLOW = 2,  ///< Keep at `offset` from a group or a character, until the next order.
    MUSTER_ORDER_GUARD = 3,   ///< Stand round a rectangle, which may move, until the next order.
    MUSTER_ORDER_LEAVE = 4,   ///< Leave the world by exits. Nobody has a place meanwhile.
    MUSTER_ORDER_WAIT = 5,    ///< Go to a waiting area and stand there. Nobody has a place meanwhile.
    MUSTER_ORDER_WALK = 6     ///< Walk on towards `facing` without end. Nobody has a place meanwhile.
};

/// By which exit each leaves.
typedef uint8_t MusterExitChoice;
/// Values of MusterExitChoice.
enum MusterExitChoiceValue {
    MUSTER_EXIT_QUICKEST = 0,  ///< Where it will have left soonest, with the wait before it.
    MUSTER_EXIT_NEAREST = 1    ///< The one with the quickest way.
};

/// How a group goes to its target.
typedef uint8_t MusterManner;
/// Values of MusterManner.
enum MusterMannerValue {
    MUSTER_MANNER_MARCH = 0,     ///< In formation: the shape goes along the way and waits for the last.
    MUSTER_MANNER_FREE = 1,      ///< Each by the shortest way; the shape at the end.
    MUSTER_MANNER_CONTINUUM = 2  ///< All to `target` itself, by one cost field that the crowd raises
                                 ///< (Treuille et al. 2006): no shape, no places. Those who have come near
                                 ///< stand where there is room.
};

/// How a marching formation takes its turns.
typedef uint8_t MusterTurn;
/// Values of MusterTurn.
enum MusterTurnValue {
    MUSTER_TURN_WHEEL = 0,    ///< It faces along its way, and turns at a bounded rate.
    MUSTER_TURN_REVERSE = 1,  ///< As Wheel, but where the way leads back its rear becomes its front, and
                              ///< nobody changes files.
    MUSTER_TURN_KEEP = 2,     ///< It faces one way until it has arrived, and then turns to `facing`.
    MUSTER_TURN_FLOW = 3      ///< Everybody heads for the place that is nearest for all, and the formation
                              ///< flows where the way narrows. In the open nothing arrives sooner.
};

/// What a finger or a pointer does.
typedef uint8_t MusterTouchPhase;
/// Values of MusterTouchPhase.
enum MusterTouchPhaseValue {
    MUSTER_TOUCH_DOWN = 0,   ///< It comes down.
    MUSTER_TOUCH_MOVE = 1,   ///< It moves.
    MUSTER_TOUCH_UP = 2,     ///< It lifts.
    MUSTER_TOUCH_CANCEL = 3  ///< It is lost: its control ends at once.
};

/// Changes of a control.
typedef uint8_t MusterControlEdit;
/// Values of MusterControlEdit.
enum MusterControlEditValue {
    MUSTER_CONTROL_EDIT_PIN = 0,      ///< It stays at the end of its trajectory.
    MUSTER_CONTROL_EDIT_RELEASE = 1,  ///< It is no longer pinned.
    MUSTER_CONTROL_EDIT_REMOVE = 2    ///< It ends at once.
};

/// Where a new order stands in a queue.
typedef uint8_t MusterQueueMode;
/// Values of MusterQueueMode.
enum MusterQueueModeValue {
    MUSTER_QUEUE_REPLACE = 0,  ///< It takes the place of all others.
    MUSTER_QUEUE_APPEND = 1,   ///< It comes last.
    MUSTER_QUEUE_INSERT = 2    ///< It comes before the order of a given index.
};

/// Changes of a queue.
typedef uint8_t MusterQueueEdit;
/// Values of MusterQueueEdit.
enum MusterQueueEditValue {
    MUSTER_EDIT_CANCEL = 0,      ///< Drops one order, or all.
    MUSTER_EDIT_HOLD = 1,        ///< The group waits where it is; the queue stays.
    MUSTER_EDIT_RESUME = 2,      ///< It goes on.
    MUSTER_EDIT_PATROL = 3,      ///< Orders that are done come last again.
    MUSTER_EDIT_END_PATROL = 4,  ///< They do not.
    MUSTER_EDIT_STOP = 5         ///< Drops all orders, ends all controls, and the group stands where it is.
};

/// Who makes room where groups meet.
typedef uint8_t MusterStance;
/// Values of MusterStance.
enum MusterStanceValue {
    MUSTER_STANCE_NORMAL = 0,  ///< Each as much as the other.
    MUSTER_STANCE_HOLD = 1,    ///< It holds its ground: others go round it.
    MUSTER_STANCE_YIELD = 2    ///< It makes room for others.
};

/// Kinds of events. Those from Arrived on tell how orders get on and how groups change; each from Arrived to
/// Partial comes once per order and version of the ground. An order is a pose, a formation, a count or a
/// drawn way; the ground changes with every command that changes obstacles or patches.
typedef uint8_t MusterEventKind;
/// Values of MusterEventKind.
enum MusterEventKindValue {
    MUSTER_EVENT_ENTER_PATCH = 0,       ///< `value` is the id of the patch.
    MUSTER_EVENT_LEAVE_PATCH = 1,       ///< `value` is the id of the patch.
    MUSTER_EVENT_TRANSITION_START = 2,  ///< A transition into or out of a motion begins; `value` is the
                                        ///< motion id.
    MUSTER_EVENT_TRANSITION_END = 3,    ///< A transition has ended; `value` is the motion id.
    MUSTER_EVENT_SINGLE_STEP = 4,       ///< A jump or climb begins; `value` is the motion id.
    MUSTER_EVENT_COLLECT = 5,           ///< An item was collected; `value` is the index of the item.
    MUSTER_EVENT_FORMATION_CHANGE = 6,  ///< A group has another formation; `subject` is the id of the group.
    MUSTER_EVENT_SWAP = 7,              ///< A character's place changed without a command; `value` is the new
                                        ///< place.
    MUSTER_EVENT_ARRIVED = 8,           ///< All of a group's characters that have a place are within 0.5 m of
                                        ///< it for 1 s, and the places stand where the order wants them;
                                        ///< `value` is their number.
    MUSTER_EVENT_STUCK = 9,             ///< A character is not at its place and has moved less than 0.25 m
                                        ///< over the last 5 s, and not in a queue that moves on; `value` is
                                        ///< the place. Raised again only once it has moved.
    MUSTER_EVENT_BLOCKED = 10,          ///< The ground cut off the way of `value` characters of a group, or
                                        ///< for 2 s a moving obstacle did, as a gate that closes. One that
                                        ///< only passes gives no event.
    MUSTER_EVENT_FREE = 11,             ///< All of a group have their way again; `value` is how many had
                                        ///< none.
    MUSTER_EVENT_NO_PATH = 12,          ///< No place of the group's order can be reached, or not by its
                                        ///< largest members, who stay behind; `value` is the number of those
                                        ///< concerned.
    MUSTER_EVENT_PARTIAL = 13,          ///< `value` places of the group's order cannot be reached; the others
                                        ///< can.
    MUSTER_EVENT_ORDER_GIVEN = 14,      ///< A group was given the order of id `value`.
    MUSTER_EVENT_ORDER_BEGUN = 15,      ///< It begins the order of id `value`.
    MUSTER_EVENT_ORDER_DONE = 16,       ///< It has carried out the order of id `value`.
    MUSTER_EVENT_ORDER_SKIPPED = 17,    ///< It passes over the order of id `value`, whose target cannot be
                                        ///< reached.
    MUSTER_EVENT_PASSED = 18,           ///< A group has passed the checkpoint of index `value`.
    MUSTER_EVENT_GROUP_ADDED = 19,      ///< A group is new; `value` is the id of the group that it was split
                                        ///< off, 0 for none.
    MUSTER_EVENT_GROUP_REMOVED = 20,    ///< A group has ended; `value` is the id of the group that it was
                                        ///< merged into, 0 for none.
    MUSTER_EVENT_JOINED = 21,           ///< A character is new; `value` is the id of its group.
    MUSTER_EVENT_LEFT = 22,             ///< A character has left the world; `value` is the id of its group.
    MUSTER_EVENT_TRANSFERRED = 23,      ///< A character has changed groups; `value` is the id of its new
                                        ///< group.
    MUSTER_EVENT_EXITED = 24,           ///< A character has left the world by an exit; `value` is the id of
                                        ///< that area.
    MUSTER_EVENT_ENTERED = 25,          ///< A character has come into the world by a source; `value` is the
                                        ///< id of that area.
    MUSTER_EVENT_COUNT = 26             ///< Their number.
};

#endif
