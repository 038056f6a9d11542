/* Made by schema/generate.mjs from schema/api/command.txt: change these, not this file. */
/* The command itself: one struct for all kinds. */
#ifndef MUSTER_C_COMMAND_H
#define MUSTER_C_COMMAND_H

#include "muster/c/generated/command_bodies.h"

#ifdef __cplusplus
extern "C" {
#endif

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

#ifdef __cplusplus
}
#endif

#endif
