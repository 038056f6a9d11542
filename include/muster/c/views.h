/* Made by schema/generate.mjs from schema/api/views.txt: change these, not this file. */
/* What can be read of a world. Arrays belong to the world and are valid until it steps, goes back or ends. */
#ifndef MUSTER_C_VIEWS_H
#define MUSTER_C_VIEWS_H

#include "muster/c/command.h"

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif
