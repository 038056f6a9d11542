/* Made by schema/generate.mjs from the declarations in schema/: change these, not this file. */
/* The C API of Muster: C99 and C++.
 *
 * Handles are ids, which functions check: a handle of something that was destroyed is refused and never read.
 * Structs with `structVersion` are made by their muster_default_...() function, never by hand; then fields
 * are set. Arrays are a pointer and a count, `positions` and `positionCount`; null with 0 is none. What is
 * handed to a function is copied. Texts are UTF-8 and end with a zero byte.
 *
 * Functions return MUSTER_OK or the code of a failure, whose sentence muster_last_error() gives. No function
 * throws, and none writes to what `out...` points to where it fails, but for handles, which become none.
 * Fields of kinds are small integers; other numbers than those listed are refused.
 *
 * Threads: different handles may be used at the same time, one handle by one thread at a time, for reading
 * too. Making and destroying is allowed from any thread. muster_set_allocator() and muster_set_log() belong
 * before everything else, while no other thread is in the library. Each thread has its own last error.
 *
 * The engine reads no clock in any decision. Only muster_world_stage_times() measures wall time.
 *
 * Contents, in this order; a line of ==== begins each:
 *
 *   base         What all parts of the C API share: codes of failures, their sentences, memory, log,
 *                threads. C99 and C++.
 *   values       Enumerations, and what definitions are made of: points, shapes, ids, maps, parameters.
 *   definitions  What worlds are made of, with the values that they have at first; and what reads or makes
 *                definitions: paths, maps, people, parameters.
 *   commands     The bodies of all kinds of commands, and the command itself: one struct for all kinds.
 *   views        What can be read of a world. Arrays belong to the world and are valid until it steps,
 *                goes back or ends.
 *   world        Worlds: environment, groups, characters, and the simulation step.
 *   scenario     Scenario files: everything a world starts from. Gesture files: touches and other commands
 *                with their times. Component io.
 *   clips        Skeletons, poses and motion clips. Component motion.
 *   motion       Animation of a crowd: which clip each character plays, and its pose with feet on the
 *                floor. It reads worlds and never changes them. Component motion.
 *   bvh          BVH files, decoded. Component motion.
 *   take         Takes: a scenario, the commands given to it and hashes of its state, so that it replays
 *                bit for bit; and their export. Component io.
 */
#ifndef MUSTER_MUSTER_H
#define MUSTER_MUSTER_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#if defined(MUSTER_BUILDING) && defined(_WIN32)
#define MUSTER_API __declspec(dllexport)
#elif defined(MUSTER_SHARED) && defined(_WIN32)
#define MUSTER_API __declspec(dllimport)
#elif defined(__GNUC__)
#define MUSTER_API __attribute__((visibility("default")))
#else
#define MUSTER_API
#endif

#ifdef __cplusplus
extern "C" {
#endif

/* ==== base ======================================================================================
 * What all parts of the C API share: codes of failures, their sentences, memory, log, threads. C99 and
 * C++. */

/// What kind of thing went wrong.
typedef int32_t MusterStatus;
/// Values of MusterStatus.
enum MusterStatusValue {
    MUSTER_OK = 0,                ///< Success.
    MUSTER_INVALID_ARGUMENT = 1,  ///< A value is outside its range or contradicts another.
    MUSTER_NOT_FOUND = 2,         ///< No object has this name or id; also for a handle that was destroyed.
    MUSTER_PARSE_ERROR = 3,       ///< Text or bytes that do not follow the format.
    MUSTER_IO_ERROR = 4,          ///< A file that cannot be read or written.
    MUSTER_CORRUPT = 5,           ///< A checksum or hash that does not match.
    MUSTER_UNSUPPORTED = 6,       ///< Valid, but of a version or kind not known here.
    MUSTER_LIMIT_EXCEEDED = 7,    ///< Too large, too many, too often.
    MUSTER_OUT_OF_MEMORY = 8,     ///< Memory could not be had.
    MUSTER_INTERNAL = 9           ///< A fault of Muster itself.
};

/// The sentence of this thread's last call that failed: the same as that of the C++ API, without a trailing
/// newline. Calls that succeed do not change it. Empty before the first failure. Valid until the next failure
/// in this thread.
MUSTER_API const char* muster_last_error(void);
/// The name of a code: "ok", "invalid argument"... "unknown" for other numbers.
MUSTER_API const char* muster_status_name(MusterStatus status);

/// The version of the library, "MAJOR.MINOR.PATCH".
MUSTER_API const char* muster_version(void);
/// True where the library was built with that component: "core", "motion" or "io". Null is none.
MUSTER_API bool muster_has_component(const char* component);

/// Memory of the host. Both functions may be called from any thread.
typedef struct MusterAllocator {
    void* context;  ///< Passed unchanged as the first argument. May be null.
    /// Gives `size` bytes at a multiple of `alignment`, a power of two, or null. Must not be null.
    void* (*allocate)(void* context, size_t size, size_t alignment);
    /// Takes back what `allocate` gave. Must not be null.
    void (*release)(void* context, void* memory);
} MusterAllocator;

/// Takes memory from the host from now on; null for the standard functions again. What was allocated before
/// goes back to where it came from, so the functions must work until all of their memory is released. What
/// comes from here is stated by muster_allocator_covers_engine(). Fails with InvalidArgument where a function
/// is null.
MUSTER_API MusterStatus muster_set_allocator(const MusterAllocator* allocator);

/// True where all that the library takes with C++ `new` comes from the allocator (a shared library that was
/// built with MUSTER_HOST_ALLOCATOR). False: only the memory that the C API itself takes for read-outs,
/// buffers and text.
MUSTER_API bool muster_allocator_covers_engine(void);

/// Kinds of log messages.
typedef int32_t MusterLogLevel;
/// Values of MusterLogLevel.
enum MusterLogLevelValue {
    MUSTER_LOG_INFO = 0,    ///< Something that is good to know, as a command that was refused in its step.
    MUSTER_LOG_FAILURE = 1  ///< A call failed; the text is its sentence.
};

/// Gets a message: one sentence, valid during the call. It may come from any thread that calls the library.
/// It must not call the library.
typedef void (*MusterLogFunction)(void* context, MusterLogLevel level, const char* message);
/// Sends messages to a function from now on; null for none, as at first. The library itself prints nothing.
MUSTER_API void muster_set_log(MusterLogFunction function, void* context);

/// Bytes that belong to the caller until muster_free_buffer(). A zero byte follows them, so text can be used
/// as it is.
typedef struct MusterBuffer {
    uint8_t* data;  ///< The bytes; null where there are none.
    size_t size;    ///< Their number, without the zero byte.
} MusterBuffer;

/// Releases the bytes and sets the buffer to none. Null, and a buffer without bytes, are fine.
MUSTER_API void muster_free_buffer(MusterBuffer* buffer);

/// A piece of work that is called once for each of its items.
typedef void (*MusterTask)(void* taskContext, int32_t item, int32_t worker);
/// A long piece of work for the background.
typedef void (*MusterBackgroundTask)(void* taskContext);

/// The job system of the host, in place of the library's own threads. Results are the same.
typedef struct MusterTaskRunner {
    uint32_t structVersion;  ///< Set by muster_default_task_runner().
    int32_t threads;         ///< Largest number of workers that run at the same time, the calling thread
                             ///< included where it takes part [1 to 256].
    void* context;           ///< Passed unchanged as the first argument of each function below. May be null.
    /// Calls `task(taskContext, item, worker)` once for every item in [0, count), in any order and on any
    /// threads. Returns when all calls have returned and their writes are visible to the calling thread.
    /// `worker` lies in [0, threads); no two simultaneous calls have the same `worker`. Must not be null.
    void (*run)(void* context, int32_t count, MusterTask task, void* taskContext);
    /// Starts `task(taskContext)` on another thread, now or later, and returns at once. Null if the host has
    /// no thread for background work, which is then done in the calling thread.
    void (*launch)(void* context, MusterBackgroundTask task, void* taskContext);
    /// Returns when the launched task has returned and its writes are visible to the calling thread. Must not
    /// be null if `launch` is not.
    void (*wait)(void* context);
} MusterTaskRunner;

/// One thread, no functions.
MUSTER_API MusterTaskRunner muster_default_task_runner(void);

/* ==== values ====================================================================================
 * Enumerations, and what definitions are made of: points, shapes, ids, maps, parameters. */

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

/// Whether a character stands in its place, and if not, what keeps it from there. Of a place it is said where
/// the formation wants it: people stand beside it where they cannot stand there.
typedef uint8_t MusterStanding;
/// Values of MusterStanding.
enum MusterStandingValue {
    MUSTER_STANDING_IN_PLACE = 0,    ///< It stands within 0.5 m of where its formation wants it.
    MUSTER_STANDING_ON_THE_WAY = 1,  ///< It is on its way, or its place is.
    MUSTER_STANDING_HELD = 2,        ///< Its group was ordered to hold, or it has not set out yet.
    MUSTER_STANDING_STUCK = 3,       ///< It has not got on for 5 s.
    MUSTER_STANDING_OUTSIDE = 4,     ///< Its place lies outside the ground.
    MUSTER_STANDING_OBSTACLE = 5,    ///< Its place lies in an obstacle.
    MUSTER_STANDING_NARROW = 6,      ///< Its place is too narrow for its body.
    MUSTER_STANDING_NO_WAY = 7,      ///< No way leads to its place.
    MUSTER_STANDING_CROWDED = 8,     ///< Others have taken the room at its place.
    MUSTER_STANDING_COUNT = 9        ///< Their number.
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

/// A point or vector in the ground plane: x right, y forward [m].
typedef struct MusterVec2 {
    double x;  ///< To the right [m].
    double y;  ///< Forward [m].
} MusterVec2;

/// A rotation in the plane.
typedef struct MusterRotation {
    double c;  ///< Cosine of its angle.
    double s;  ///< Sine.
} MusterRotation;

/// A rigid transform: rotation about the origin, then translation.
typedef struct MusterPose {
    MusterVec2 position;      ///< Translation [m].
    MusterRotation rotation;  ///< Unit rotation.
} MusterPose;

/// An axis-aligned box.
typedef struct MusterBox {
    MusterVec2 min;  ///< Lower left corner [m].
    MusterVec2 max;  ///< Upper right corner [m].
} MusterBox;

/// Three vertex indices, counter-clockwise.
typedef struct MusterTriangle {
    int32_t vertex[3];  ///< Indices.
} MusterTriangle;

/// A point of a mesh by its barycentric coordinates.
typedef struct MusterMeshPoint {
    int32_t triangle;  ///< Index into the mesh's triangles.
    double weight[3];  ///< Barycentric coordinates; their sum is 1.
} MusterMeshPoint;

/// Corners of a polygon in order [m]; an edge joins the last to the first.
typedef struct MusterPolygon {
    const MusterVec2* points;  ///< Corners, counter-clockwise unless noted otherwise [m].
    int32_t pointCount;        ///< Their number.
} MusterPolygon;

/// Index of a motion clip in the world's table of clips; 0 is running in the open.
typedef int32_t MusterMotionIndex;

/// Names an obstacle of a world; 0 for none. It is not used again.
typedef uint32_t MusterObstacleId;
/// Names a patch of a world; 0 for none.
typedef uint32_t MusterPatchId;
/// Names a group of a world; 0 for none.
typedef uint32_t MusterGroupId;
/// Names an item of a world; 0 for none.
typedef uint32_t MusterItemId;
/// Names a formation checkpoint of a world; 0 for none.
typedef uint32_t MusterCheckpointId;
/// Names an exit, a source or a waiting area; 0 for none.
typedef uint32_t MusterAreaId;
/// Names a control of a world; 0 for none.
typedef uint32_t MusterControlId;
/// Names a character of a world; 0 for none.
typedef uint32_t MusterCharacterId;
/// Names an order in a queue; 0 for none.
typedef uint32_t MusterOrderId;

/// A MovingAI grid map as ground.
typedef struct MusterMapDef {
    uint32_t structVersion;  ///< Set by muster_default_map_def().
    int32_t width;           ///< Columns, 1 to 4096.
    int32_t height;          ///< Rows, 1 to 4096.
    const char* cells;       ///< One character per cell, row by row, the top row first.
    int32_t cellCount;       ///< Number of characters: width times height.
    double metresPerCell;    ///< Edge of a map cell, above 0 [m].
    MusterVec2 origin;       ///< Lower left corner of the map [m].
    double swampSpeed;       ///< Travel speed on swamp cells `S` relative to running, above 0.
} MusterMapDef;

/// No cells, 1 m each.
MUSTER_API MusterMapDef muster_default_map_def(void);

/// The value of a parameter.
typedef struct MusterParameterValue {
    const char* name;  ///< Name as muster_parameter_info() gives it: "plan.exponent".
    double value;      ///< Value in the range of the parameter.
} MusterParameterValue;

/* ==== definitions ===============================================================================
 * What worlds are made of, with the values that they have at first; and what reads or makes definitions:
 * paths, maps, people, parameters. */

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

/// Position, angle and velocities on a path at one time.
typedef struct MusterPathState {
    MusterWaypoint at;       ///< Position and angle.
    MusterVec2 velocity;     ///< Velocity [m/s].
    double angularVelocity;  ///< Angular velocity [rad/s].
} MusterPathState;

/// Reads a path at `time` [s]. Fails with InvalidArgument, naming the waypoint, where times do not rise or a
/// number is out of range.
MUSTER_API MusterStatus muster_timed_path_at(const MusterTimedPath* path, double time,
                                             MusterPathState* outState);

/// The name of a kind as files spell it: "square", "line"... Null for other numbers.
MUSTER_API const char* muster_formation_name(MusterFormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
MUSTER_API MusterStatus muster_formation_kind(const char* name, MusterFormationKind* outKind);

/// The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order. Null for
/// `outCount` is fine. Valid for ever.
MUSTER_API const MusterClipFacts* muster_own_clip_facts(int32_t* outCount);

/// A map that was read, and the ground that it makes.
typedef struct MusterMapId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMapId;

/// Reads the text of a `.map` file (type octile), of `size` bytes. Fails with ParseError, naming the line.
MUSTER_API MusterStatus muster_map_parse(const char* text, size_t size, MusterMapId* outMap);
/// Ends a map. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_map_destroy(MusterMapId map);
/// The cells of a map, with scale and position of muster_default_map_def(). Valid until the map is destroyed.
MUSTER_API MusterStatus muster_map_def(MusterMapId map, MusterMapDef* outDef);
/// Blocked cells (`@ O T W`) as few rectangular obstacles, which do not overlap and cover exactly these
/// cells. `placement` gives scale and position; its cells are not read. Valid until the next call for this
/// map.
MUSTER_API MusterStatus muster_map_obstacles(MusterMapId map, const MusterMapDef* placement,
                                             const MusterObstacleDef** outObstacles, int32_t* outCount);
/// Swamp cells as few rectangular patches on which `motion` is played, as muster_map_obstacles().
MUSTER_API MusterStatus muster_map_patches(MusterMapId map, const MusterMapDef* placement,
                                           MusterMotionIndex motion, const MusterPatchDef** outPatches,
                                           int32_t* outCount);

/// Takes up a front from `left` to `right` [m]: its middle, width and facing.
MUSTER_API MusterOrder muster_order_to_line(MusterVec2 left, MusterVec2 right);

/// What would come of an order.
typedef struct MusterForecast {
    uint32_t structVersion;  ///< Set by muster_default_forecast().
    bool arrives;            ///< True where the target can be reached.
    const MusterVec2* way;   ///< The way of the formation's centre, both ends included [m].
    int32_t wayCount;        ///< Their number.
    MusterVec2 end;          ///< Where the formation would stand: the target, or the nearest ground to it
                             ///< [m].
    double seconds;          ///< Time until it would arrive [s]; infinite where it never does.
} MusterForecast;

/// Nothing yet: to be filled by muster_world_forecast().
MUSTER_API MusterForecast muster_default_forecast(void);

/// The value below which a share of persons lie, in (0, 1). Fails with InvalidArgument for other shares, and
/// for a kind that is not known.
MUSTER_API MusterStatus muster_distribution_quantile(const MusterDistribution* distribution, double share,
                                                     double* outValue);

/// Adults: free speeds of mean 1.34 m/s and deviation 0.26 m/s, cut off at 0.5 and 2.2 m/s.
MUSTER_API MusterPeopleDef muster_adults(void);
/// The mean free speed of persons by age [m/s], 5 to 90 years.
MUSTER_API double muster_walking_speed_at_age(double years);

/// Describes one parameter.
typedef struct MusterParameterInfo {
    const char* name;         ///< Name in files and messages: "plan.exponent".
    const char* unit;         ///< "m", "s", "m/s", "1", "switch", "mode", "steps", "count"...
    double minimum;           ///< Smallest allowed value.
    double maximum;           ///< Largest allowed value.
    double standard;          ///< Value of the preset "units".
    bool whole;               ///< True where only whole numbers are valid: switches, modes, steps and counts.
    const char* description;  ///< One sentence.
} MusterParameterInfo;

/// Number of parameters.
MUSTER_API int32_t muster_parameter_count(void);
/// The parameter of an index. Its texts are valid for ever. Fails with InvalidArgument for other indices.
MUSTER_API MusterStatus muster_parameter_info(int32_t index, MusterParameterInfo* outInfo);
/// The value of a parameter in a preset: "units" (the defaults), "people" or "paper". Fails with NotFound.
MUSTER_API MusterStatus muster_preset_value(const char* preset, const char* name, double* outValue);

/* ==== commands ==================================================================================
 * The bodies of all kinds of commands, and the command itself: one struct for all kinds. */

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
    const MusterPeopleDef* people;        ///< Its sorts of persons, none where all are as
                                          ///< MusterGroupDef.bodies say. Persons who join it are drawn by
                                          ///< them from now on. Its present members are drawn again, as those
                                          ///< who come at once: each number that neither the sorts before nor
                                          ///< these draw stays as it is. A person who has heard an order sets
                                          ///< out when it was to.
    int32_t peopleCount;                  ///< Their number.
    const MusterConduct* conduct;         ///< How it behaves; null for as it does.
    bool hasRoles;                        ///< False: the roles that it has.
    const MusterRoleDef* roles;           ///< Which class stands where, in the order in which they choose
                                          ///< places.
    int32_t roleCount;                    ///< Their number.
    bool hasDemands;                      ///< False: the demands that these have.
    const double* demands;                ///< How many units of supply each place demands, 0 to 1000, of each
                                          ///< place, or none for 1 each.
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
    const MusterCheckpointDef* checkpoint;  ///< A formation checkpoint, whose `group` is not read; null for
                                            ///< other things.
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

/// A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence).
typedef struct MusterCommand {
    uint32_t structVersion;  ///< Set by muster_default_command().
    MusterCommandKind kind;  ///< Which member of `body` is meant.
    uint32_t step;           ///< It applies at the start of the step from `step` to `step + 1`.
    uint32_t client;         ///< Number of the sender.
    uint32_t sequence;       ///< Rises with each command of a client.
    MusterCommandBody body;  ///< The change.
} MusterCommand;
/// A command of that kind with the defaults of its body, for step 0. Of kind 0 where there is no such kind.
MUSTER_API MusterCommand muster_default_command(MusterCommandKind kind);
/// The kind as a word, for logs: "Touch". Null for other numbers.
MUSTER_API const char* muster_command_name(MusterCommandKind kind);
/// Checks what does not depend on the world. Fails with InvalidArgument, naming the value.
MUSTER_API MusterStatus muster_command_validate(const MusterCommand* command);
/// Encodes a command as bytes, for messages and files: the same as those of takes.
MUSTER_API MusterStatus muster_command_encode(const MusterCommand* command, MusterBuffer* outBytes);

/// A list of commands in the library's memory.
typedef struct MusterCommandListId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterCommandListId;

/// Decodes one command. Fails with ParseError where there are too few or too many bytes, the kind is unknown
/// or a value is out of its range.
MUSTER_API MusterStatus muster_command_decode(const uint8_t* bytes, size_t size,
                                              MusterCommandListId* outList);
/// The commands of a list; null for `outCount` is not allowed. Valid until the list is destroyed.
MUSTER_API MusterStatus muster_command_list_get(MusterCommandListId list, const MusterCommand** outCommands,
                                                int32_t* outCount);
/// Ends a list. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_command_list_destroy(MusterCommandListId list);

/* ==== views =====================================================================================
 * What can be read of a world. Arrays belong to the world and are valid until it steps, goes back or ends. */

/// All characters of a world: one entry per character in each array, in ascending order of ids. No copies are
/// made, and arrays are valid until the world steps or ends.
typedef struct MusterCharacters {
    uint32_t structVersion;            ///< Set by muster_default_characters().
    int32_t count;                     ///< Number of characters.
    const MusterCharacterId* id;       ///< Unique id; it is not reused after the character has left.
    const uint32_t* group;             ///< Index of its group.
    const MusterVec2* position;        ///< Position [m].
    const MusterVec2* velocity;        ///< Velocity [m/s].
    const MusterVec2* heading;         ///< Unit vector in which the body faces.
    const int32_t* place;              ///< Index of its place in its group; -1 for the unmatched.
    const MusterVec2* direction;       ///< Unit vector along its planned path; zero where there is no path.
    const double* cost;                ///< Cost of the path to its place; infinite for the unmatched.
    const MusterMotionIndex* motion;   ///< Motion it performs: an index into the world's clips.
    const MusterMotionPhase* phase;    ///< Phase of that motion.
    const double* motionTime;          ///< Time since the phase began [s].
    const MusterPatchId* patch;        ///< Id of the patch that it is in; 0 for none.
    const MusterBody* body;            ///< What it is.
    const MusterDriver* driver;        ///< Who moves it.
    const MusterVec2* wantedVelocity;  ///< Velocity that steering aims at on the ground it is on, before
                                       ///< bounds and contacts [m/s]. Those that are moved from outside have
                                       ///< it too.
    const MusterAreaId* goal;          ///< Exit or waiting area that it goes to; 0 for none.
} MusterCharacters;

/// No characters: to be filled by muster_world_characters().
MUSTER_API MusterCharacters muster_default_characters(void);

/// Sums over the path costs of all characters with a place, in metres of open ground.
typedef struct MusterWalkTotals {
    double sum;      ///< Sum of the costs [m].
    double squares;  ///< Sum of the squared costs [m^2].
    double longest;  ///< Largest cost [m].
} MusterWalkTotals;

/// What can be read of a group without a copy. Texts and arrays are valid until the world steps or ends.
typedef struct MusterGroup {
    uint32_t structVersion;             ///< Set by muster_default_group().
    MusterGroupId id;                   ///< Unique id; it is not reused after the group is removed.
    const char* name;                   ///< Name for display.
    bool hasColour;                     ///< False: the palette's colour.
    uint32_t colour;                    ///< Chosen colour, 0xRRGGBB.
    bool hasBuild;                      ///< False: bodies of both builds.
    MusterBodyBuild build;              ///< Build of its drawn bodies.
    bool hasMotions;                    ///< False: the plain manner.
    MusterMotionSet motions;            ///< How it walks and jogs.
    int32_t count;                      ///< Number of characters, and of places but where they go without
                                        ///< (Leave, Wait, Walk): then there are none.
    MusterFormationKind formation;      ///< Current shape. Its whole definition is read separately.
    uint32_t formationVersion;          ///< Increases whenever the mesh is replaced.
    MusterPose pose;                    ///< Transforms the rest mesh to the world.
    const int32_t* members;             ///< Indices of its characters, ascending.
    int32_t memberCount;                ///< Their number.
    const MusterVec2* restMesh;         ///< Vertices of the rest shape, in the group's axes [m].
    const MusterVec2* userMesh;         ///< Vertices of Vu, deformed by controls [m].
    const MusterVec2* finalMesh;        ///< Vertices of Vf: Vu deformed by the environment [m].
    int32_t vertexCount;                ///< Number of vertices of each mesh.
    const MusterTriangle* triangles;    ///< Vertex indices, counter-clockwise.
    int32_t triangleCount;              ///< Their number.
    const MusterMeshPoint* meshPlaces;  ///< Each place as a point of the mesh.
    const MusterVec2* placePositions;   ///< Current position of each place [m].
    const MusterVec2* placeVelocities;  ///< Current velocity of each place [m/s].
    const MusterVec2* placeTargets;     ///< Reachable target of each place [m].
    const uint8_t* placeUsable;         ///< 1 where a character can stand at the place, else 0.
    int32_t placeCount;                 ///< Number of places.
    const uint8_t* placeClasses;        ///< Class of each place by the group's roles, 0 for whoever is left;
                                        ///< none without roles.
    int32_t placeClassCount;            ///< Number of places; 0 without roles.
    double objective;                   ///< Objective of the last plan [cost^p].
    double gapBound;                    ///< Upper bound of its duality gap [cost^p].
    MusterWalkTotals walk;              ///< Path costs by the last plan.
    double meanLag;                     ///< Mean distance of characters to the targets of their places (SPEC
                                        ///< U6) [m].
    bool waits;                         ///< True: it was ordered to hold, and its orders stay.
    bool patrols;                       ///< True: orders that are done come last again.
    MusterConduct conduct;              ///< How it behaves.
    const MusterVec2* way;              ///< What is ahead of the way of the order that it carries out:
                                        ///< corners up to the end, the next one first [m].
    int32_t wayCount;                   ///< Their number.
} MusterGroup;

/// No group: to be filled by muster_world_group().
MUSTER_API MusterGroup muster_default_group(void);

/// A point of a drawn trajectory.
typedef struct MusterCheckpoint {
    MusterVec2 position;  ///< Position in the world [m].
    double time;          ///< When it was drawn [s].
} MusterCheckpoint;

/// A mesh vertex that a finger controls, and the trajectory drawn for it.
typedef struct MusterControlPoint {
    int32_t vertex;                      ///< Index of the mesh vertex, which is a hard constraint.
    uint32_t touch;                      ///< Number of the finger; unique per client while it is down.
    bool down;                           ///< False once the finger has lifted.
    MusterVec2 offset;                   ///< From the finger to the vertex at touch down [m]; added to all
                                         ///< drawn points.
    MusterVec2 position;                 ///< Current position of the vertex in the world [m].
    const MusterCheckpoint* trajectory;  ///< Checkpoints still ahead; the last is the finger's newest point.
    int32_t trajectoryCount;             ///< Their number.
} MusterControlPoint;

/// One control of a mesh. All its points follow their trajectories by a common clock, which preserves their
/// relative timing.
typedef struct MusterControl {
    MusterControlId id;                    ///< Unique id, which is not reused.
    MusterControlKind kind;                ///< Follows from the number of points.
    uint32_t client;                       ///< Number of the client that touches.
    bool pinned;                           ///< True where it stays at the end of its trajectories.
    bool open;                             ///< True while touches of the same client may still join.
    double joinDeadline;                   ///< World time at which it stops being open [s]; -1 before its
                                           ///< first step.
    double startTime;                      ///< Time stamp of the first touch [s]; may be later than the
                                           ///< world's time.
    double clock;                          ///< Time of the drawing that the points have reached [s].
    const MusterControlPoint* points;      ///< Controlled vertices, at least one.
    int32_t pointCount;                    ///< Their number.
    const MusterMeshPoint* supplementary;  ///< Supplementary points, which are soft constraints.
    int32_t supplementaryCount;            ///< Their number.
    const double* weights;                 ///< Row-major weights, supplementary points x points; each row
                                           ///< sums to 1.
    int32_t weightCount;                   ///< Their number.
} MusterControl;

/// An obstacle and its current position. Its id is none where the world has no such obstacle.
typedef struct MusterObstacle {
    uint32_t structVersion;     ///< Set by muster_default_obstacle().
    MusterObstacleId id;        ///< Unique id; it is not reused.
    MusterObstacleDef def;      ///< Definition as added or last changed.
    const MusterVec2* outline;  ///< Current corners [m]; none for a disc.
    int32_t outlineCount;       ///< Their number.
    MusterVec2 centre;          ///< Current centre of the disc or of the area [m].
} MusterObstacle;

/// No obstacle: to be filled by muster_world_obstacle().
MUSTER_API MusterObstacle muster_default_obstacle(void);

/// A patch and its current position. Its id is none where the world has no such patch.
typedef struct MusterPatch {
    uint32_t structVersion;     ///< Set by muster_default_patch().
    MusterPatchId id;           ///< Unique id; it is not reused.
    MusterPatchDef def;         ///< Definition as added or last changed.
    const MusterVec2* outline;  ///< Current corners [m].
    int32_t outlineCount;       ///< Their number.
} MusterPatch;

/// No patch: to be filled by muster_world_patch().
MUSTER_API MusterPatch muster_default_patch(void);

/// An exit, a source or a waiting area, and what it has seen.
typedef struct MusterArea {
    MusterAreaId id;      ///< Unique id; it is not reused.
    MusterAreaDef def;    ///< Definition as added or last changed; its `group` is not read.
    MusterGroupId group;  ///< Of a source: whom its people join.
    uint32_t passed;      ///< People who have left by an exit, or come by a source.
    uint32_t waiting;     ///< People of a source for whom there is no room yet.
} MusterArea;

/// The name of a kind: "enterPatch", "arrived"... Null for other numbers.
MUSTER_API const char* muster_event_name(MusterEventKind kind);

/// One event.
typedef struct MusterEvent {
    MusterEventKind kind;  ///< What happened.
    uint32_t subject;      ///< Id of the character; of the group where the kind speaks of one.
    uint32_t value;        ///< Its meaning depends on the kind.
    MusterVec2 position;   ///< Where it happened: the middle of those concerned [m].
} MusterEvent;

/// A command that could not be applied, and why.
typedef struct MusterRejection {
    MusterCommand command;  ///< The command that failed.
    MusterStatus status;    ///< The kind of failure.
    const char* message;    ///< Its sentence.
} MusterRejection;

/// Overlaps of bodies that remain after a step.
typedef struct MusterContacts {
    int32_t overlapPairs;     ///< Pairs that overlap by more than 10 % of the sum of their radii.
    double worstPenetration;  ///< Overlap of the deepest pair, as a share of that.
} MusterContacts;

/// Wall time of one stage of the last step. It is not part of the state.
typedef struct MusterStageTime {
    const char* name;     ///< Name of the stage.
    double milliseconds;  ///< Its time [ms].
} MusterStageTime;

/* ==== world =====================================================================================
 * Worlds: environment, groups, characters, and the simulation step. */

/// A world. All functions fail with NotFound where it was destroyed or never was.
typedef struct MusterWorldId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterWorldId;

/// Builds a world that uses this number of threads (0 for all cores). Fails with InvalidArgument, naming the
/// faulty value. `outWorld` is set to none where it fails.
MUSTER_API MusterStatus muster_world_create(const MusterWorldDef* def, int32_t threads,
                                            MusterWorldId* outWorld);
/// Builds a world that runs on the host's job system, whose `context` must outlive the world.
MUSTER_API MusterStatus muster_world_create_on(const MusterWorldDef* def, const MusterTaskRunner* runner,
                                               MusterWorldId* outWorld);
/// Restores a world from a snapshot; it continues bit for bit. Fails with ParseError on other bytes, and with
/// Unsupported on a snapshot of another version.
MUSTER_API MusterStatus muster_world_restore(const uint8_t* snapshot, size_t size, int32_t threads,
                                             MusterWorldId* outWorld);
/// Restores a world that runs on the host's job system.
MUSTER_API MusterStatus muster_world_restore_on(const uint8_t* snapshot, size_t size,
                                                const MusterTaskRunner* runner, MusterWorldId* outWorld);
/// Ends a world. All its arrays become invalid.
MUSTER_API MusterStatus muster_world_destroy(MusterWorldId world);
/// True where the world is there.
MUSTER_API bool muster_world_is_valid(MusterWorldId world);

/// Goes back to a snapshot of this world, or on to it, keeping what was computed and is still true. Fails as
/// muster_world_restore(), changing nothing.
MUSTER_API MusterStatus muster_world_rewind(MusterWorldId world, const uint8_t* snapshot, size_t size);
/// Queues a command. Fails where it is malformed or its step has passed; whether it can be applied is only
/// known in its step: see muster_world_rejections().
MUSTER_API MusterStatus muster_world_submit(MusterWorldId world, const MusterCommand* command);
/// Advances by one time step. The engine reads no clock in any decision: the same commands give the same
/// bits, whatever the time of day, the speed of the machine and the number of threads.
MUSTER_API MusterStatus muster_world_step(MusterWorldId world);
/// Hash of all state.
MUSTER_API MusterStatus muster_world_hash(MusterWorldId world, uint64_t* outHash);
/// All state as bytes, which belong to the caller (muster_free_buffer()).
MUSTER_API MusterStatus muster_world_snapshot(MusterWorldId world, MusterBuffer* outBytes);

/// Number of steps done.
MUSTER_API MusterStatus muster_world_step_count(MusterWorldId world, uint32_t* outSteps);
/// Number of steps done times the time step [s].
MUSTER_API MusterStatus muster_world_time(MusterWorldId world, double* outSeconds);
/// Step of the last applied command; 0 for none.
MUSTER_API MusterStatus muster_world_last_command_step(MusterWorldId world, uint32_t* outStep);
/// Current value of a parameter. Fails with NotFound, naming it.
MUSTER_API MusterStatus muster_world_parameter(MusterWorldId world, const char* name, double* outValue);

/// Characters of all groups.
MUSTER_API MusterStatus muster_world_characters(MusterWorldId world, MusterCharacters* outCharacters);
/// The way of a character, an index into muster_world_characters(), to its place: corners round what stands
/// still, both ends included [m]. None for the unmatched and where there is no way. Valid also until the next
/// call. Fails with InvalidArgument for other indices.
MUSTER_API MusterStatus muster_world_way_ahead(MusterWorldId world, int32_t character,
                                               const MusterVec2** outPoints, int32_t* outCount);
/// The Standing of each character: whether it stands in its place, and if not, what keeps it from there.
/// Valid also until the next call.
MUSTER_API MusterStatus muster_world_standings(MusterWorldId world, const uint8_t** outStandings,
                                               int32_t* outCount);

/// Current number of groups.
MUSTER_API MusterStatus muster_world_group_count(MusterWorldId world, int32_t* outCount);
/// A group by its index; groups are in ascending order of ids. Fails with InvalidArgument for other indices.
MUSTER_API MusterStatus muster_world_group(MusterWorldId world, int32_t index, MusterGroup* outGroup);
/// The index of the group of that id. Fails with NotFound.
MUSTER_API MusterStatus muster_world_group_index(MusterWorldId world, MusterGroupId group, int32_t* outIndex);
/// Current name, count and formation of a group. Valid also until the next call.
MUSTER_API MusterStatus muster_world_group_def(MusterWorldId world, int32_t index, MusterGroupDef* outDef);
/// Controls of a group in the order of creation. Valid also until the next call.
MUSTER_API MusterStatus muster_world_group_controls(MusterWorldId world, int32_t index,
                                                    const MusterControl** outControls, int32_t* outCount);
/// The queue of a group; the first order is carried out. Valid also until the next call.
MUSTER_API MusterStatus muster_world_group_orders(MusterWorldId world, int32_t index,
                                                  const MusterQueuedOrder** outOrders, int32_t* outCount);
/// What would come of an order that a group were given now, and nothing else changed. Nothing changes. Valid
/// also until the next call. Fails with NotFound where there is no such group, with InvalidArgument for an
/// order that is malformed.
MUSTER_API MusterStatus muster_world_forecast(MusterWorldId world, MusterGroupId group,
                                              const MusterOrder* order, MusterForecast* outForecast);

/// Ids of all obstacles, ascending.
MUSTER_API MusterStatus muster_world_obstacle_ids(MusterWorldId world, const MusterObstacleId** outIds,
                                                  int32_t* outCount);
/// The obstacle of that id. Valid also until the next call. Fails with NotFound.
MUSTER_API MusterStatus muster_world_obstacle(MusterWorldId world, MusterObstacleId id,
                                              MusterObstacle* outObstacle);
/// Ids of all patches, ascending.
MUSTER_API MusterStatus muster_world_patch_ids(MusterWorldId world, const MusterPatchId** outIds,
                                               int32_t* outCount);
/// The patch of that id. Valid also until the next call. Fails with NotFound.
MUSTER_API MusterStatus muster_world_patch(MusterWorldId world, MusterPatchId id, MusterPatch* outPatch);
/// All items, with their ids, ascending, and 1 for each that is collected, else 0. Null for a pointer that is
/// not needed is fine, but for the number.
MUSTER_API MusterStatus muster_world_items(MusterWorldId world, const MusterItemDef** outItems,
                                           const MusterItemId** outIds, const uint8_t** outCollected,
                                           int32_t* outCount);
/// All formation checkpoints, with their ids, ascending, and the group that each concerns, 0 for any. Null
/// for a pointer that is not needed is fine, but for the number. Valid also until the next call.
MUSTER_API MusterStatus muster_world_checkpoints(MusterWorldId world,
                                                 const MusterCheckpointDef** outCheckpoints,
                                                 const MusterCheckpointId** outIds,
                                                 const MusterGroupId** outGroups, int32_t* outCount);

/// All exits, sources and waiting areas, in ascending order of ids. Valid also until the next call.
MUSTER_API MusterStatus muster_world_areas(MusterWorldId world, const MusterArea** outAreas,
                                           int32_t* outCount);
/// True where the left and the right side of the world's box are joined.
MUSTER_API MusterStatus muster_world_ring(MusterWorldId world, bool* outRing);

/// Events of the last step.
MUSTER_API MusterStatus muster_world_events(MusterWorldId world, const MusterEvent** outEvents,
                                            int32_t* outCount);
/// Commands that failed in the last step. Valid also until the next call.
MUSTER_API MusterStatus muster_world_rejections(MusterWorldId world, const MusterRejection** outRejections,
                                                int32_t* outCount);
/// Overlaps after the last step.
MUSTER_API MusterStatus muster_world_contacts(MusterWorldId world, MusterContacts* outContacts);
/// Wall times of the stages of the last step, and of the whole step [ms]. Valid also until the next call.
MUSTER_API MusterStatus muster_world_stage_times(MusterWorldId world, const MusterStageTime** outStages,
                                                 int32_t* outCount, double* outTotal);

/* ==== scenario ==================================================================================
 * Scenario files: everything a world starts from. Gesture files: touches and other commands with their
 * times. */

/// A scenario in the library's memory.
typedef struct MusterScenarioId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterScenarioId;

/// Reads a scenario file. Every failure is one sentence `FILE: JSON-PATH: found X, expected Y`.
MUSTER_API MusterStatus muster_scenario_load(const char* path, MusterScenarioId* outScenario);
/// The same from text of `size` bytes. `sourceName` stands for the file in messages; `baseFolder` is where
/// relative map files are looked for (null or empty: files are refused, only embedded maps are allowed).
MUSTER_API MusterStatus muster_scenario_parse(const char* text, size_t size, const char* sourceName,
                                              const char* baseFolder, MusterScenarioId* outScenario);
/// A scenario of a definition.
MUSTER_API MusterStatus muster_scenario_from_def(const MusterWorldDef* def, MusterScenarioId* outScenario);
/// Ends a scenario. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_scenario_destroy(MusterScenarioId scenario);

/// Its whole definition. Valid until the scenario is destroyed.
MUSTER_API MusterStatus muster_scenario_def(MusterScenarioId scenario, MusterWorldDef* outDef);
/// Builds a world of it, as muster_world_create() with muster_scenario_def().
MUSTER_API MusterStatus muster_scenario_create_world(MusterScenarioId scenario, int32_t threads,
                                                     MusterWorldId* outWorld);
/// The whole definition as text with its map embedded: parsing it gives the same definition, bit for bit.
MUSTER_API MusterStatus muster_scenario_text(MusterScenarioId scenario, MusterBuffer* outText);
/// Writes the text to a file. Fails with IoError.
MUSTER_API MusterStatus muster_scenario_save(MusterScenarioId scenario, const char* path);
/// Lists what is valid but likely a mistake: one sentence each, at most `most`. Valid until the next call for
/// this scenario.
MUSTER_API MusterStatus muster_scenario_warnings(MusterScenarioId scenario, int32_t most,
                                                 const char* const** outSentences, int32_t* outCount);
/// The JSON Schema (draft 2020-12) of scenario files.
MUSTER_API MusterStatus muster_scenario_schema(MusterBuffer* outText);

/// Reads a gestures file into commands for a world of that step time [s], ordered by (step, client,
/// sequence). Fails as muster_scenario_load() does.
MUSTER_API MusterStatus muster_gestures_load(const char* path, double stepTime, MusterCommandListId* outList);
/// The same from text of `size` bytes.
MUSTER_API MusterStatus muster_gestures_parse(const char* text, size_t size, const char* sourceName,
                                              double stepTime, MusterCommandListId* outList);
/// The same from the text of a single event or of an array of events: `t` may be left out and is 0 then.
MUSTER_API MusterStatus muster_gestures_parse_commands(const char* text, size_t size, const char* sourceName,
                                                       double stepTime, MusterCommandListId* outList);
/// The touches that a scenario carries which was read from `scenarioPath`. Empty where it carries none.
MUSTER_API MusterStatus muster_gestures_of_scenario(const char* scenarioPath, MusterScenarioId scenario,
                                                    MusterCommandListId* outList);
/// The JSON Schema of gesture files.
MUSTER_API MusterStatus muster_gestures_schema(MusterBuffer* outText);
/// Commands as the text of a gestures file: reading it gives the same commands, numbered again per client.
MUSTER_API MusterStatus muster_gestures_text(const MusterCommand* commands, int32_t commandCount,
                                             double stepTime, MusterBuffer* outText);
/// Writes that text to a file. Fails with IoError.
MUSTER_API MusterStatus muster_gestures_save(const MusterCommand* commands, int32_t commandCount,
                                             double stepTime, const char* path);

/* ==== clips =====================================================================================
 * Skeletons, poses and motion clips. */

/// A point or vector in space [m]. In the world x right, y forward, z up; in body axes x forward, y left, z
/// up.
typedef struct MusterVec3 {
    float x;  ///< First coordinate [m].
    float y;  ///< Second coordinate [m].
    float z;  ///< Height [m].
} MusterVec3;

/// A rotation in space: a unit quaternion.
typedef struct MusterQuat {
    float x;  ///< First imaginary part.
    float y;  ///< Second imaginary part.
    float z;  ///< Third imaginary part.
    float w;  ///< Real part.
} MusterQuat;

/// A rigid transform: rotation about the origin, then translation.
typedef struct MusterTransform {
    MusterQuat rotation;     ///< Rotation.
    MusterVec3 translation;  ///< Translation [m].
} MusterTransform;

/// The joints, parents before children. The values are indices into every array of joints.
typedef uint8_t MusterJointRole;
/// Values of MusterJointRole.
enum MusterJointRoleValue {
    MUSTER_JOINT_HIPS = 0,             ///< The hips.
    MUSTER_JOINT_SPINE = 1,            ///< The spine.
    MUSTER_JOINT_CHEST = 2,            ///< The chest.
    MUSTER_JOINT_NECK = 3,             ///< The neck.
    MUSTER_JOINT_HEAD = 4,             ///< The head.
    MUSTER_JOINT_LEFT_SHOULDER = 5,    ///< The left shoulder.
    MUSTER_JOINT_LEFT_ARM = 6,         ///< The left arm.
    MUSTER_JOINT_LEFT_FORE_ARM = 7,    ///< The left fore arm.
    MUSTER_JOINT_LEFT_HAND = 8,        ///< The left hand.
    MUSTER_JOINT_RIGHT_SHOULDER = 9,   ///< The right shoulder.
    MUSTER_JOINT_RIGHT_ARM = 10,       ///< The right arm.
    MUSTER_JOINT_RIGHT_FORE_ARM = 11,  ///< The right fore arm.
    MUSTER_JOINT_RIGHT_HAND = 12,      ///< The right hand.
    MUSTER_JOINT_LEFT_UP_LEG = 13,     ///< The left up leg.
    MUSTER_JOINT_LEFT_LEG = 14,        ///< The left leg.
    MUSTER_JOINT_LEFT_FOOT = 15,       ///< The left foot.
    MUSTER_JOINT_LEFT_TOE_BASE = 16,   ///< The left toe base.
    MUSTER_JOINT_RIGHT_UP_LEG = 17,    ///< The right up leg.
    MUSTER_JOINT_RIGHT_LEG = 18,       ///< The right leg.
    MUSTER_JOINT_RIGHT_FOOT = 19,      ///< The right foot.
    MUSTER_JOINT_RIGHT_TOE_BASE = 20,  ///< The right toe base.
    MUSTER_JOINT_COUNT = 21            ///< Their number.
};

/// A joint in the rest pose.
typedef struct MusterJoint {
    const char* name;   ///< Name in common use by animation programs: "LeftForeArm".
    int32_t parent;     ///< Index of the parent; -1 for the hips.
    MusterVec3 offset;  ///< Offset from the parent [m]; for the hips, from the ground below.
    MusterVec3 tip;     ///< End of the bone relative to the joint [m]; zero for joints with children.
} MusterJoint;

/// The MUSTER_JOINT_COUNT joints of the skeleton of a person 1.75 m tall. Valid for ever.
MUSTER_API const MusterJoint* muster_skeleton(void);
/// Body size of the character with that id, as a factor of the skeleton: uniform in 0.96 to 1.04.
MUSTER_API float muster_character_size(uint32_t character);

/// A pose of the body in body axes: the origin is on the ground below the character, which faces +x.
typedef struct MusterBodyPose {
    MusterVec3 hips;          ///< Position of the hips [m].
    MusterQuat rotation[21];  ///< Rotation of each joint relative to its parent; of the hips to the body
                              ///< axes.
} MusterBodyPose;

/// The rest pose.
MUSTER_API MusterBodyPose muster_rest_pose(void);
/// Forward kinematics: writes MUSTER_JOINT_COUNT transforms. `root` transforms body axes to the world.
MUSTER_API MusterStatus muster_joint_transforms(const MusterBodyPose* pose, const MusterTransform* root,
                                                MusterTransform* outJoints);
/// Interpolates between two poses; t = 0 gives `a`, t = 1 gives `b`.
MUSTER_API MusterStatus muster_blend_poses(const MusterBodyPose* a, const MusterBodyPose* b, float t,
                                           MusterBodyPose* outPose);

/// The part of a body that touches something in a contact.
typedef uint8_t MusterLimb;
/// Values of MusterLimb.
enum MusterLimbValue {
    MUSTER_LIMB_LEFT_FOOT = 0,   ///< The left foot.
    MUSTER_LIMB_RIGHT_FOOT = 1,  ///< The right foot.
    MUSTER_LIMB_LEFT_HAND = 2,   ///< The left hand.
    MUSTER_LIMB_RIGHT_HAND = 3,  ///< The right hand.
    MUSTER_LIMB_LEFT_KNEE = 4,   ///< The left knee.
    MUSTER_LIMB_RIGHT_KNEE = 5,  ///< The right knee.
    MUSTER_LIMB_COUNT = 6        ///< Their number.
};

/// The name of a limb: "left foot"... Null for other numbers.
MUSTER_API const char* muster_limb_name(MusterLimb limb);
/// The joint that stays in place during a contact of the limb. MUSTER_JOINT_COUNT for other numbers.
MUSTER_API MusterJointRole muster_limb_joint(MusterLimb limb);

/// A time interval in which a limb does not move over the ground.
typedef struct MusterLimbContact {
    MusterLimb limb;    ///< The limb that is in contact.
    double begin;       ///< Start time [s], in [0, duration).
    double end;         ///< End time [s], above `begin`; in a cyclic clip it may exceed the duration.
    MusterVec3 anchor;  ///< Position of the joint during the contact [m], in the axes in which the travel
                        ///< starts.
} MusterLimbContact;

/// Displacement of the body axes on the ground since the clip began (root motion).
typedef struct MusterTravel {
    float x;    ///< Displacement forward [m].
    float y;    ///< Displacement to the left [m].
    float yaw;  ///< Rotation to the left [rad].
} MusterTravel;

/// Composition: `then` begins at the position and yaw at which `first` ends.
MUSTER_API MusterTravel muster_travel_compose(MusterTravel first, MusterTravel then);

/// A motion clip: poses at a fixed rate, their travel, and the contacts.
typedef struct MusterClip {
    uint32_t structVersion;             ///< Set by muster_default_clip().
    const char* name;                   ///< Unique name: "run", "crawl-enter"...
    const char* motion;                 ///< The motion it belongs to: "run", "duck", "crawl"...
    double rate;                        ///< Poses per second, above 0.
    bool cyclic;                        ///< True where the first pose follows the last, displaced by the
                                        ///< travel.
    const MusterBodyPose* poses;        ///< Duration times rate of a cyclic clip, one more of others.
    int32_t poseCount;                  ///< Their number.
    const MusterTravel* travel;         ///< Travel at each pose; a cyclic clip has one more.
    int32_t travelCount;                ///< Their number.
    const MusterLimbContact* contacts;  ///< Contacts in order of `begin`.
    int32_t contactCount;               ///< Their number.
    double entryPhase;                  ///< Of a transition: share of the entered cycle at which that
                                        ///< continues.
    double exitPhase;                   ///< Of a transition: share of the left cycle at which it begins.
    float obstacleHeight;               ///< Height of what a single-step clip passes over [m]; 0 for nothing.
    float obstacleThickness;            ///< Its extent along the travel [m].
} MusterClip;

/// A cyclic clip without poses, at 60 poses per second.
MUSTER_API MusterClip muster_default_clip(void);

/// A set of clips.
typedef struct MusterClipLibraryId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterClipLibraryId;

/// All of Muster's own clips, made once at the first call (a tenth of a second).
MUSTER_API MusterStatus muster_clips_own(MusterClipLibraryId* outLibrary);
/// A library of given clips. Fails with InvalidArgument, naming the clip and the faulty value, also where two
/// have one name.
MUSTER_API MusterStatus muster_clips_create(const MusterClip* clips, int32_t clipCount,
                                            MusterClipLibraryId* outLibrary);
/// Ends the handle of a library; motions that play its clips keep them.
MUSTER_API MusterStatus muster_clips_destroy(MusterClipLibraryId library);
/// All clips of a library. Valid until it is destroyed.
MUSTER_API MusterStatus muster_clips_get(MusterClipLibraryId library, const MusterClip** outClips,
                                         int32_t* outCount);
/// The index of the clip of that name. Fails with NotFound.
MUSTER_API MusterStatus muster_clips_find(MusterClipLibraryId library, const char* name, int32_t* outIndex);

/// Measures of a clip.
typedef struct MusterClipMeasures {
    double duration;  ///< Duration of one play [s].
    double length;    ///< Distance from start to end of one play [m].
    double speed;     ///< Length by duration [m/s].
} MusterClipMeasures;

/// Measures of the clip of an index. Fails with InvalidArgument for other indices, as all that follow.
MUSTER_API MusterStatus muster_clip_measures(MusterClipLibraryId library, int32_t clip,
                                             MusterClipMeasures* outMeasures);
/// The pose at a time [s], which wraps in cyclic clips and is clamped to the clip in others.
MUSTER_API MusterStatus muster_clip_sample(MusterClipLibraryId library, int32_t clip, double time,
                                           MusterBodyPose* outPose);
/// The travel at a time [s]; cyclic clips go on travelling for times of any sign.
MUSTER_API MusterStatus muster_clip_travel_at(MusterClipLibraryId library, int32_t clip, double time,
                                              MusterTravel* outTravel);
/// The contact of a limb at a time [s]; null where none. Valid until the library is destroyed.
MUSTER_API MusterStatus muster_clip_contact_at(MusterClipLibraryId library, int32_t clip, MusterLimb limb,
                                               double time, const MusterLimbContact** outContact);
/// The clip as the text of a BVH file, in centimetres, Y up, facing +Z.
MUSTER_API MusterStatus muster_clip_bvh(MusterClipLibraryId library, int32_t clip, MusterBuffer* outText);

/* ==== motion ====================================================================================
 * Animation of a crowd: which clip each character plays, and its pose with feet on the floor. It reads
 * worlds and never changes them. */

/// The clip that a character plays: enough to draw it from baked poses.
typedef struct MusterMotionState {
    uint16_t clip;        ///< Index into the library.
    uint16_t fromClip;    ///< The clip that fades out.
    float time;           ///< Time in `clip` [s], within one play.
    float fromTime;       ///< Time in `fromClip` [s].
    float fade;           ///< Share of `fromClip` still shown, 0 to 1.
    MusterVec2 position;  ///< Origin of the body axes in the world: the simulated position [m].
    float yaw;            ///< Heading, counter-clockwise from +x [rad].
    float size;           ///< Factor of the skeleton: muster_character_size() of its id.
} MusterMotionState;

/// The motion of all characters of a world.
typedef struct MusterMotionId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMotionId;

/// The motion of a crowd at one moment.
typedef struct MusterMotionMomentId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterMotionMomentId;

/// Motion by the clips of a library; by an empty one all characters are shown in the rest pose. `allNear`:
/// all characters get whole poses until muster_motion_set_near() is called, else none does.
MUSTER_API MusterStatus muster_motion_create(MusterClipLibraryId library, bool allNear,
                                             MusterMotionId* outMotion);
/// Ends a motion. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_motion_destroy(MusterMotionId motion);
/// Forgets all characters; the next update starts their motion again.
MUSTER_API MusterStatus muster_motion_restart(MusterMotionId motion);
/// Call after every step of the world. The motion of new characters, and of those that were moved by a
/// command, starts again.
MUSTER_API MusterStatus muster_motion_update(MusterMotionId motion, MusterWorldId world);

/// Ids of the characters that get whole poses from the next update on, in any order; unknown ids are ignored.
MUSTER_API MusterStatus muster_motion_set_near(MusterMotionId motion, const MusterCharacterId* ids,
                                               int32_t idCount);
/// The clip and time of each character, in the world's order. Valid until the next update.
MUSTER_API MusterStatus muster_motion_states(MusterMotionId motion, const MusterMotionState** outStates,
                                             int32_t* outCount);
/// Indices of characters with whole poses, ascending. Valid until the next update.
MUSTER_API MusterStatus muster_motion_near(MusterMotionId motion, const uint32_t** outIndices,
                                           int32_t* outCount);
/// The pose of the k-th of muster_motion_near(), with locked feet, for a body of size 1. In the world it is
/// scaled by `size`, rotated by `yaw` and moved to `position`. Fails with InvalidArgument for other k.
MUSTER_API MusterStatus muster_motion_pose(MusterMotionId motion, int32_t k, MusterBodyPose* outPose);
/// The id of the k-th of muster_motion_near().
MUSTER_API MusterStatus muster_motion_near_id(MusterMotionId motion, int32_t k,
                                              MusterCharacterId* outCharacter);
/// True while that limb of the k-th of muster_motion_near() is locked in a contact.
MUSTER_API MusterStatus muster_motion_locked(MusterMotionId motion, int32_t k, MusterLimb limb,
                                             bool* outLocked);
/// The joints of the k-th of muster_motion_near() in the world [m]: writes MUSTER_JOINT_COUNT transforms.
MUSTER_API MusterStatus muster_motion_joints(MusterMotionId motion, int32_t k, MusterTransform* outJoints);

/// All that later motion depends on, to go back to together with a snapshot of the world.
MUSTER_API MusterStatus muster_motion_moment(MusterMotionId motion, MusterMotionMomentId* outMoment);
/// Goes back, or on, to a moment of a motion by the same library. Fails with InvalidArgument for another.
MUSTER_API MusterStatus muster_motion_go_back(MusterMotionId motion, MusterMotionMomentId moment);
/// The memory of a moment [bytes].
MUSTER_API MusterStatus muster_motion_moment_size(MusterMotionMomentId moment, size_t* outBytes);
/// Ends a moment. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_motion_moment_destroy(MusterMotionMomentId moment);

/* ==== bvh =======================================================================================
 * BVH files, decoded. */

/// A joint of a BVH file, in Muster's axes (x forward, y left, z up).
typedef struct MusterBvhJoint {
    const char* name;        ///< Name in the file.
    int32_t parent;          ///< Index of a joint before it; -1 for a root.
    MusterVec3 offset;       ///< From the parent in the rest pose [m].
    const MusterVec3* ends;  ///< End sites, from the joint [m].
    int32_t endCount;        ///< Their number.
    bool moves;              ///< True where it has position channels.
} MusterBvhJoint;

/// A whole BVH file.
typedef struct MusterBvh {
    uint32_t structVersion;         ///< Set by muster_default_bvh().
    const MusterBvhJoint* joints;   ///< Parents before children; at least one.
    int32_t jointCount;             ///< Their number.
    const MusterTransform* values;  ///< Transforms relative to the parent [m], by frame and then by joint.
    int32_t valueCount;             ///< Frames times joints.
    int32_t frames;                 ///< Number of frames, at least one.
    double rate;                    ///< Frames per second, above 0.
    double unit;                    ///< Length of one unit of the file [m].
    double duration;                ///< Time from the first frame to the last [s].
} MusterBvh;

/// No file: to be filled by muster_bvh_get().
MUSTER_API MusterBvh muster_default_bvh(void);

/// A BVH file in the library's memory.
typedef struct MusterBvhId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterBvhId;

/// Reads BVH text of `size` bytes. `unit` is the length of one unit of the file [m], 1e-6 to 1e3; 0 to guess
/// it from the body height. Fails, as `sourceName:LINE: found X, expected Y`, on anything that is not a
/// complete BVH file.
MUSTER_API MusterStatus muster_bvh_parse(const char* text, size_t size, const char* sourceName, double unit,
                                         MusterBvhId* outBvh);
/// The same from a file.
MUSTER_API MusterStatus muster_bvh_read(const char* path, double unit, MusterBvhId* outBvh);

/// What the file holds. Valid until it is destroyed.
MUSTER_API MusterStatus muster_bvh_get(MusterBvhId bvh, MusterBvh* outFile);
/// Ends a file. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_bvh_destroy(MusterBvhId bvh);

/* ==== take ======================================================================================
 * Takes: a scenario, the commands given to it and hashes of its state, so that it replays bit for bit; and
 * their export. */

/// A take that is being recorded.
typedef struct MusterTakeWriterId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterTakeWriterId;

/// Makes the file. Fails with IoError, also where it exists and `overwrite` is false.
MUSTER_API MusterStatus muster_take_writer_create(const char* path, const MusterWorldDef* def, bool overwrite,
                                                  MusterTakeWriterId* outWriter);
/// Appends a command. Call in the order of submission, before the step that applies it.
MUSTER_API MusterStatus muster_take_writer_command(MusterTakeWriterId writer, const MusterCommand* command);
/// Call after every step: appends the events of orders, and frames and a mark whenever they are due.
MUSTER_API MusterStatus muster_take_writer_observe(MusterTakeWriterId writer, MusterWorldId world);
/// Appends the end record and closes the file, synchronised with the disk. The writer ends, also where it
/// fails.
MUSTER_API MusterStatus muster_take_writer_finish(MusterTakeWriterId writer, MusterWorldId world);
/// Ends a writer without an end record: the take is unfinished.
MUSTER_API MusterStatus muster_take_writer_destroy(MusterTakeWriterId writer);

/// A take in the library's memory.
typedef struct MusterTakeId {
    uint32_t index1;      ///< Slot, counted from 1; 0 for none.
    uint32_t generation;  ///< Which of those that had the slot.
} MusterTakeId;

/// The hash of a world's state after that many steps.
typedef struct MusterHashMark {
    uint32_t step;      ///< Number of steps done.
    uint64_t hash;      ///< Hash of the state after these steps.
    uint32_t commands;  ///< Number of commands recorded before this mark. The file does not store it.
} MusterHashMark;

/// An event of an order, as it was raised while the take was recorded (EventKind: Arrived and later ones).
typedef struct MusterTakeEvent {
    uint32_t step;      ///< Number of steps done at the event.
    MusterEvent event;  ///< The event.
} MusterTakeEvent;

/// Where everybody was after that many steps, to 1 mm: what a take shows where its simulation gives other
/// bits.
typedef struct MusterTakeFrame {
    uint32_t step;                 ///< Number of steps done.
    const MusterCharacterId* ids;  ///< Who, in ascending order.
    int32_t idCount;               ///< Their number.
    const MusterVec2* positions;   ///< Where [m], in the same order.
    int32_t positionCount;         ///< Their number.
} MusterTakeFrame;

/// A part of a take that plays faster or slower than it was recorded.
typedef struct MusterSpeedPiece {
    double from;   ///< Time in the take [s].
    double to;     ///< Time in the take [s], above `from`.
    double speed;  ///< Seconds of the take per second, 0.1 to 8.
    double ease;   ///< Time at each end in which the speed comes and goes [s], 0 or more.
} MusterSpeedPiece;

/// What a take holds.
typedef struct MusterTake {
    uint32_t structVersion;          ///< Set by muster_default_take().
    const char* scenario;            ///< Text of the scenario, map and clip facts embedded.
    MusterWorldDef def;              ///< The scenario, parsed.
    const MusterCommand* commands;   ///< Commands in the order of submission.
    int32_t commandCount;            ///< Their number.
    const MusterHashMark* marks;     ///< Hash marks in ascending order of steps.
    int32_t markCount;               ///< Their number.
    const MusterTakeEvent* events;   ///< Events in ascending order of steps.
    int32_t eventCount;              ///< Their number.
    const MusterTakeFrame* frames;   ///< Frames in ascending order of steps.
    int32_t frameCount;              ///< Their number.
    const char* title;               ///< Name for people; empty for none.
    uint32_t firstStep;              ///< Steps before the part that is to be shown.
    uint32_t lastStep;               ///< Steps after which that part ends.
    const MusterSpeedPiece* speeds;  ///< Faster and slower parts, in ascending order.
    int32_t speedCount;              ///< Their number.
    bool finished;                   ///< True where the take has an end record.
    uint64_t tornBytes;              ///< Bytes of an unfinished last record that were left out.
    uint32_t markedSteps;            ///< Steps whose hashes are known: up to the last mark.
    uint32_t steps;                  ///< Steps that can be replayed.
} MusterTake;

/// No take: to be filled by muster_take_get().
MUSTER_API MusterTake muster_default_take(void);

/// Reads a take. A torn last record is left out and counted in `tornBytes`. Fails with Corrupt, naming the
/// offset, where anything before it does not match its checksum; with ParseError or Unsupported on other
/// files.
MUSTER_API MusterStatus muster_take_read(const char* path, MusterTakeId* outTake);
/// The same from bytes; `sourceName` stands for the file in messages.
MUSTER_API MusterStatus muster_take_parse(const uint8_t* bytes, size_t size, const char* sourceName,
                                          MusterTakeId* outTake);
/// Ends a take. Fails with NotFound where there is none.
MUSTER_API MusterStatus muster_take_destroy(MusterTakeId take);

/// What the take holds. Valid until it is destroyed.
MUSTER_API MusterStatus muster_take_get(MusterTakeId take, MusterTake* outTake);
/// Seconds of the take per second that it is shown, at that time of the take [s].
MUSTER_API MusterStatus muster_take_speed_at(MusterTakeId take, double seconds, double* outSpeed);
/// Whether this Muster simulates the take as it was recorded, up to its first mark.
MUSTER_API MusterStatus muster_take_simulates_alike(MusterTakeId take, int32_t threads, bool* outAlike);

/// Where a replay takes positions from.
typedef uint8_t MusterReplayFrom;
/// Values of MusterReplayFrom.
enum MusterReplayFromValue {
    MUSTER_REPLAY_SIMULATION = 0,  ///< The world simulates everything again.
    MUSTER_REPLAY_FRAMES = 1       ///< Characters are put where the stored frames say; nothing is compared.
};

/// Outcome of a replay.
typedef struct MusterReplayReport {
    uint32_t steps;     ///< Number of steps simulated.
    uint32_t compared;  ///< Number of marks that matched.
    uint32_t unmarked;  ///< Steps after the last mark, which no hash confirms.
    uint64_t hash;      ///< Hash of the final state.
} MusterReplayReport;

/// Gets the world after every step, to read it, in the thread that replays; false ends the replay early. The
/// handle is valid during the call only.
typedef bool (*MusterReplayFunction)(void* context, MusterWorldId world);

/// Simulates the take again and compares every mark and event. Fails with Corrupt naming the step of the
/// first mark that differs. With MUSTER_REPLAY_FRAMES nothing is compared, and it fails with Unsupported
/// where the take has no stored frames. `observe` may be null.
MUSTER_API MusterStatus muster_take_replay(MusterTakeId take, int32_t threads, MusterReplayFrom from,
                                           MusterReplayFunction observe, void* context,
                                           MusterReplayReport* outReport);

/// A file format of exports.
typedef struct MusterExportFormat {
    const char* name;    ///< Unique name: "glb", "bvh"...
    const char* ending;  ///< Ending of the file name (".glb"), or of the folder that bvh writes ("-bvh").
    const char* about;   ///< Description in one line.
} MusterExportFormat;

/// All formats of this build. Valid for ever. Null for `outCount` is fine.
MUSTER_API const MusterExportFormat* muster_export_formats(int32_t* outCount);
/// The format of that name. Fails with NotFound, naming all formats.
MUSTER_API MusterStatus muster_export_format(const char* name, MusterExportFormat* outFormat);

/// The part of a take to export, and the frame rate.
typedef struct MusterExportDef {
    uint32_t structVersion;          ///< Set by muster_default_export_def().
    double from;                     ///< Time of the first frame [s], 0 or more.
    double to;                       ///< Time of the last frame [s], within the take; negative: its end.
    double fps;                      ///< Frames per second, 1 to 240.
    int32_t threads;                 ///< Number of threads, as for muster_world_create().
    const MusterSpeedPiece* speeds;  ///< Faster and slower parts.
    int32_t speedCount;              ///< Their number.
} MusterExportDef;

/// The whole take at 30 frames per second.
MUSTER_API MusterExportDef muster_default_export_def(void);

/// Gets the share done, 0 to 1, in the thread that exports; false ends the export.
typedef bool (*MusterProgressFunction)(void* context, double share);

/// Replays a take, its characters moved by the clips of `library`, and writes `path` in the format of that
/// name. `def` may be null for the defaults, `progress` null for none. Where `progress` gives false the
/// export fails with Unsupported. A failed export leaves no file.
MUSTER_API MusterStatus muster_export_take(MusterTakeId take, MusterClipLibraryId library, const char* format,
                                           const char* path, const MusterExportDef* def,
                                           MusterProgressFunction progress, void* context);

#ifdef __cplusplus
}
#endif

#endif
