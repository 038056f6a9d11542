/* Made by schema/generate.mjs from schema/api/bvh.txt: change these, not this file. */
/* BVH files, decoded. Component motion. */
#ifndef MUSTER_C_BVH_H
#define MUSTER_C_BVH_H

#include "muster/c/clips.h"

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif
