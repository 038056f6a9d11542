/* Points, formations, and what lies on the ground: obstacles, patches, maps. */
#ifndef MUSTER_C_GROUND_H
#define MUSTER_C_GROUND_H

#include "muster/c/base.h"
#include "muster/c/generated/enumerations.h"

#ifdef __cplusplus
extern "C" {
#endif

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

/// Position and angle of a moving object at one time.
typedef struct MusterWaypoint {
    double time;          ///< World time [s], -1e7 to 1e7.
    MusterVec2 position;  ///< Offset from the object's defined position [m], each coordinate -1e7 to 1e7.
    double angle;         ///< Rotation about the object's centre of area [rad], -1e5 to 1e5.
} MusterWaypoint;

/// Piecewise linear motion through waypoints of strictly rising time.
typedef struct MusterTimedPath {
    const MusterWaypoint* waypoints;  ///< At least 1e-6 s apart; none for an object that stands still.
    int32_t waypointCount;            ///< Their number.
    bool loop;                        ///< True to start again after the last one; false to stay there.
} MusterTimedPath;

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

/// Index of a motion clip in the world's table of clips; 0 is running in the open.
typedef int32_t MusterMotionIndex;

/// The name of a kind as files spell it: "square", "line"... Null for other numbers.
MUSTER_API const char* muster_formation_name(MusterFormationKind kind);
/// The kind with that name. Fails with NotFound, listing the names.
MUSTER_API MusterStatus muster_formation_kind(const char* name, MusterFormationKind* outKind);

/// Definition of a formation in its local axes: it faces +x, its centre is the origin.
typedef struct MusterFormationDef {
    uint32_t structVersion;      ///< Set by muster_default_formation_def().
    MusterFormationKind kind;    ///< Shape.
    double spacing;              ///< Distance between neighbouring places [m], above 1e-6 and below 1e6.
    double opening;              ///< Full angle of Pacman's mouth or of the crescent's gap [rad] in (0, 6].
    MusterPolygon outline;       ///< For Outline: at least three corners, in any size [m].
    const MusterPolygon* holes;  ///< For Outline: holes, clockwise, apart from each other [m].
    int32_t holeCount;           ///< Their number.
    const MusterVec2* points;    ///< For Points: the places in this order [m]; no fewer than characters.
    int32_t pointCount;          ///< Their number.
    /// For Square: how many stand abreast, 0 to 200,000; 0 for about as many as there are ranks.
    int32_t files;
} MusterFormationDef;

/// A square at 1 m.
MUSTER_API MusterFormationDef muster_default_formation_def(void);

/// Describes an obstacle, which nobody can walk through: a polygon or a disc.
typedef struct MusterObstacleDef {
    uint32_t structVersion;  ///< Set by muster_default_obstacle_def().
    const char* name;        ///< Name for display; null or empty for none.
    MusterPolygon polygon;   ///< Simple, convex or not [m]; empty for a disc.
    MusterVec2 centre;       ///< Centre of the disc [m].
    double radius;           ///< Radius of the disc [m], above 0; 0 for a polygon.
    MusterTimedPath path;    ///< Its motion; empty for an obstacle that stands still.
    double range;     ///< Reach of its potential field [m], 0 or more; negative for the world's default.
    double strength;  ///< Factor of its potential field, 0 or more; negative for the world's default.
    double height;    ///< Height for display only [m], above 0.
} MusterObstacleDef;

/// No shape yet, of the world's range and strength.
MUSTER_API MusterObstacleDef muster_default_obstacle_def(void);

/// Describes a patch: ground on which a motion clip of its own is played.
typedef struct MusterPatchDef {
    uint32_t structVersion;    ///< Set by muster_default_patch_def().
    const char* name;          ///< Name for display; null or empty for none.
    MusterPolygon polygon;     ///< Corners of a simple polygon, convex or not [m].
    MusterTimedPath path;      ///< Its motion; empty for a patch that stands still.
    MusterMotionIndex motion;  ///< Clip played on it; an index into the world's clips.
    double speed;              ///< Travel speed relative to running, above 0; negative for the clip's.
    bool hasAscent;            ///< True: stairs or a ramp. There `speed` is that of going up.
    double ascent;             ///< Heading of the way up [rad].
    double speedDown;          ///< For stairs and ramps: that of going down; negative for `speed`.
} MusterPatchDef;

/// No shape yet, on which people run.
MUSTER_API MusterPatchDef muster_default_patch_def(void);

/// Facts of a motion clip that simulation needs.
typedef struct MusterClipFacts {
    uint32_t structVersion;  ///< Set by muster_default_clip_facts().
    const char* name;        ///< Name of the motion: "run", "crawl", "climb"...
    const char* file;        ///< File of the clip; null or empty for one of Muster's own.
    double speed;            ///< Travel speed relative to running, above 0 (running is 1).
    double length;           ///< Ground covered by one play [m]; 0 where unknown.
    double duration;         ///< Duration of one play [s], 0 or more.
    bool cyclic;             ///< False for single-step motions (jump, climb).
    double transitionTime;   ///< Duration of the transition on entering and on leaving [s]; 0 for none.
    double reachAhead;       ///< From the position to the head of a body that leans or lies [m].
    double reachBehind;      ///< From there back to its hips [m]; both are 0 for upright bodies.
} MusterClipFacts;

/// A cyclic clip without a name, as fast as running.
MUSTER_API MusterClipFacts muster_default_clip_facts(void);
/// The clips that every world knows: run, walk, duck, crawl, swim, jump, climb, idle, in this order. Null for
/// `outCount` is fine. Valid for ever.
MUSTER_API const MusterClipFacts* muster_own_clip_facts(int32_t* outCount);

/// A MovingAI grid map as ground.
typedef struct MusterMapDef {
    uint32_t structVersion;  ///< Set by muster_default_map_def().
    int32_t width;           ///< Columns, 1 to 4096.
    int32_t height;          ///< Rows, 1 to 4096.
    const char* cells;       ///< One character per cell, row by row, the top row first.
    int32_t cellCount;       ///< Number of characters: width times height.
    double metresPerCell;    ///< Edge of a map cell [m], above 0.
    MusterVec2 origin;       ///< Lower left corner of the map [m].
    double swampSpeed;       ///< Travel speed on swamp cells `S` relative to running, above 0.
} MusterMapDef;

/// No cells, 1 m each.
MUSTER_API MusterMapDef muster_default_map_def(void);

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

#ifdef __cplusplus
}
#endif

#endif
