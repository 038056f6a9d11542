/* Made by schema/generate.mjs from schema/api/values.txt: change these, not this file. */
/* What definitions are made of: points, shapes, ids, maps, parameters. */
#ifndef MUSTER_C_VALUES_H
#define MUSTER_C_VALUES_H

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

#ifdef __cplusplus
}
#endif

#endif
