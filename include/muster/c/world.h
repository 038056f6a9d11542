/* Made by schema/generate.mjs from schema/api/world.txt: change these, not this file. */
/* Worlds: environment, groups, characters, and the simulation step. */
#ifndef MUSTER_C_WORLD_H
#define MUSTER_C_WORLD_H

#include "muster/c/views.h"

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif
