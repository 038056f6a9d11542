/* Made by schema/generate.mjs from schema/api/take.txt: change these, not this file. */
/* Takes: a scenario, the commands given to it and hashes of its state, so that it replays bit for bit; and
 * their export. Component io. */
#ifndef MUSTER_C_TAKE_H
#define MUSTER_C_TAKE_H

#include "muster/c/clips.h"
#include "muster/c/world.h"

#ifdef __cplusplus
extern "C" {
#endif

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
