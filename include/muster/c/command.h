/* The command itself: one struct for all kinds. */
#ifndef MUSTER_C_COMMAND_H
#define MUSTER_C_COMMAND_H

#include "muster/c/command_bodies.h"

#ifdef __cplusplus
extern "C" {
#endif

/// Kinds of commands. Numbers stay; new kinds are appended.
typedef int32_t MusterCommandKind;
/// Values of MusterCommandKind.
enum MusterCommandKindValue {
    MUSTER_COMMAND_TOUCH_DOWN = 0,            ///< Its body is `touchDown`.
    MUSTER_COMMAND_TOUCH_MOVE = 1,            ///< Its body is `touchMove`.
    MUSTER_COMMAND_TOUCH_UP = 2,              ///< Its body is `touchUp`.
    MUSTER_COMMAND_TOUCH_CANCEL = 3,          ///< Its body is `touchCancel`.
    MUSTER_COMMAND_ADD_CONTROL = 4,           ///< Its body is `addControl`.
    MUSTER_COMMAND_PIN_CONTROL = 5,           ///< Its body is `pinControl`.
    MUSTER_COMMAND_REMOVE_CONTROL = 6,        ///< Its body is `removeControl`.
    MUSTER_COMMAND_RELEASE_CLIENT = 7,        ///< Its body is `releaseClient`.
    MUSTER_COMMAND_SET_FORMATION = 8,         ///< Its body is `setFormation`.
    MUSTER_COMMAND_SET_COUNT = 9,             ///< Its body is `setCount`.
    MUSTER_COMMAND_SET_POSE = 10,             ///< Its body is `setPose`.
    MUSTER_COMMAND_ADD_GROUP = 11,            ///< Its body is `addGroup`.
    MUSTER_COMMAND_REMOVE_GROUP = 12,         ///< Its body is `removeGroup`.
    MUSTER_COMMAND_ADD_OBSTACLE = 13,         ///< Its body is `addObstacle`.
    MUSTER_COMMAND_CHANGE_OBSTACLE = 14,      ///< Its body is `changeObstacle`.
    MUSTER_COMMAND_REMOVE_OBSTACLE = 15,      ///< Its body is `removeObstacle`.
    MUSTER_COMMAND_ADD_PATCH = 16,            ///< Its body is `addPatch`.
    MUSTER_COMMAND_CHANGE_PATCH = 17,         ///< Its body is `changePatch`.
    MUSTER_COMMAND_REMOVE_PATCH = 18,         ///< Its body is `removePatch`.
    MUSTER_COMMAND_SET_PARAMETER = 19,        ///< Its body is `setParameter`.
    MUSTER_COMMAND_GIVE_ORDER = 20,           ///< Its body is `giveOrder`.
    MUSTER_COMMAND_EDIT_QUEUE = 21,           ///< Its body is `editQueue`.
    MUSTER_COMMAND_SET_CONDUCT = 22,          ///< Its body is `setConduct`.
    MUSTER_COMMAND_ADD_CHARACTERS = 23,       ///< Its body is `addCharacters`.
    MUSTER_COMMAND_REMOVE_CHARACTERS = 24,    ///< Its body is `removeCharacters`.
    MUSTER_COMMAND_TRANSFER_CHARACTERS = 25,  ///< Its body is `transferCharacters`.
    MUSTER_COMMAND_SPLIT_GROUP = 26,          ///< Its body is `splitGroup`.
    MUSTER_COMMAND_MERGE_GROUPS = 27,         ///< Its body is `mergeGroups`.
    MUSTER_COMMAND_SET_BODIES = 28,           ///< Its body is `setBodies`.
    MUSTER_COMMAND_SET_ROLES = 29,            ///< Its body is `setRoles`.
    MUSTER_COMMAND_SET_DEMANDS = 30,          ///< Its body is `setDemands`.
    MUSTER_COMMAND_SET_DRIVER = 31,           ///< Its body is `setDriver`.
    MUSTER_COMMAND_WRITE_MOTION = 32,         ///< Its body is `writeMotion`.
    MUSTER_COMMAND_ADD_ITEM = 33,             ///< Its body is `addItem`.
    MUSTER_COMMAND_CHANGE_ITEM = 34,          ///< Its body is `changeItem`.
    MUSTER_COMMAND_REMOVE_ITEM = 35,          ///< Its body is `removeItem`.
    MUSTER_COMMAND_ADD_CHECKPOINT = 36,       ///< Its body is `addCheckpoint`.
    MUSTER_COMMAND_CHANGE_CHECKPOINT = 37,    ///< Its body is `changeCheckpoint`.
    MUSTER_COMMAND_REMOVE_CHECKPOINT = 38,    ///< Its body is `removeCheckpoint`.
    MUSTER_COMMAND_PLACE_GROUP = 39,          ///< Its body is `placeGroup`.
    MUSTER_COMMAND_NAME_GROUP = 40,           ///< Its body is `nameGroup`.
    MUSTER_COMMAND_COLOUR_GROUP = 41,         ///< Its body is `colourGroup`.
    MUSTER_COMMAND_SET_APPEARANCE = 42,       ///< Its body is `setAppearance`.
    MUSTER_COMMAND_PUT_AREA = 43,             ///< Its body is `putArea`.
    MUSTER_COMMAND_REMOVE_AREA = 44,          ///< Its body is `removeArea`.
    MUSTER_COMMAND_SET_PEOPLE = 45,           ///< Its body is `setPeople`.
    MUSTER_COMMAND_COUNT = 46                 ///< Number of kinds.
};

/// What a command of each kind says. Only the member of the command's kind is read.
typedef union MusterCommandBody {
    MusterTouchDown touchDown;                    ///< For MUSTER_COMMAND_TOUCH_DOWN.
    MusterTouchMove touchMove;                    ///< For MUSTER_COMMAND_TOUCH_MOVE.
    MusterTouchUp touchUp;                        ///< For MUSTER_COMMAND_TOUCH_UP.
    MusterTouchCancel touchCancel;                ///< For MUSTER_COMMAND_TOUCH_CANCEL.
    MusterAddControl addControl;                  ///< For MUSTER_COMMAND_ADD_CONTROL.
    MusterPinControl pinControl;                  ///< For MUSTER_COMMAND_PIN_CONTROL.
    MusterRemoveControl removeControl;            ///< For MUSTER_COMMAND_REMOVE_CONTROL.
    MusterReleaseClient releaseClient;            ///< For MUSTER_COMMAND_RELEASE_CLIENT.
    MusterSetFormation setFormation;              ///< For MUSTER_COMMAND_SET_FORMATION.
    MusterSetCount setCount;                      ///< For MUSTER_COMMAND_SET_COUNT.
    MusterSetPose setPose;                        ///< For MUSTER_COMMAND_SET_POSE.
    MusterAddGroup addGroup;                      ///< For MUSTER_COMMAND_ADD_GROUP.
    MusterRemoveGroup removeGroup;                ///< For MUSTER_COMMAND_REMOVE_GROUP.
    MusterAddObstacle addObstacle;                ///< For MUSTER_COMMAND_ADD_OBSTACLE.
    MusterChangeObstacle changeObstacle;          ///< For MUSTER_COMMAND_CHANGE_OBSTACLE.
    MusterRemoveObstacle removeObstacle;          ///< For MUSTER_COMMAND_REMOVE_OBSTACLE.
    MusterAddPatch addPatch;                      ///< For MUSTER_COMMAND_ADD_PATCH.
    MusterChangePatch changePatch;                ///< For MUSTER_COMMAND_CHANGE_PATCH.
    MusterRemovePatch removePatch;                ///< For MUSTER_COMMAND_REMOVE_PATCH.
    MusterSetParameter setParameter;              ///< For MUSTER_COMMAND_SET_PARAMETER.
    MusterGiveOrder giveOrder;                    ///< For MUSTER_COMMAND_GIVE_ORDER.
    MusterEditQueue editQueue;                    ///< For MUSTER_COMMAND_EDIT_QUEUE.
    MusterSetConduct setConduct;                  ///< For MUSTER_COMMAND_SET_CONDUCT.
    MusterAddCharacters addCharacters;            ///< For MUSTER_COMMAND_ADD_CHARACTERS.
    MusterRemoveCharacters removeCharacters;      ///< For MUSTER_COMMAND_REMOVE_CHARACTERS.
    MusterTransferCharacters transferCharacters;  ///< For MUSTER_COMMAND_TRANSFER_CHARACTERS.
    MusterSplitGroup splitGroup;                  ///< For MUSTER_COMMAND_SPLIT_GROUP.
    MusterMergeGroups mergeGroups;                ///< For MUSTER_COMMAND_MERGE_GROUPS.
    MusterSetBodies setBodies;                    ///< For MUSTER_COMMAND_SET_BODIES.
    MusterSetRoles setRoles;                      ///< For MUSTER_COMMAND_SET_ROLES.
    MusterSetDemands setDemands;                  ///< For MUSTER_COMMAND_SET_DEMANDS.
    MusterSetDriver setDriver;                    ///< For MUSTER_COMMAND_SET_DRIVER.
    MusterWriteMotion writeMotion;                ///< For MUSTER_COMMAND_WRITE_MOTION.
    MusterAddItem addItem;                        ///< For MUSTER_COMMAND_ADD_ITEM.
    MusterChangeItem changeItem;                  ///< For MUSTER_COMMAND_CHANGE_ITEM.
    MusterRemoveItem removeItem;                  ///< For MUSTER_COMMAND_REMOVE_ITEM.
    MusterAddCheckpoint addCheckpoint;            ///< For MUSTER_COMMAND_ADD_CHECKPOINT.
    MusterChangeCheckpoint changeCheckpoint;      ///< For MUSTER_COMMAND_CHANGE_CHECKPOINT.
    MusterRemoveCheckpoint removeCheckpoint;      ///< For MUSTER_COMMAND_REMOVE_CHECKPOINT.
    MusterPlaceGroup placeGroup;                  ///< For MUSTER_COMMAND_PLACE_GROUP.
    MusterNameGroup nameGroup;                    ///< For MUSTER_COMMAND_NAME_GROUP.
    MusterColourGroup colourGroup;                ///< For MUSTER_COMMAND_COLOUR_GROUP.
    MusterSetAppearance setAppearance;            ///< For MUSTER_COMMAND_SET_APPEARANCE.
    MusterPutArea putArea;                        ///< For MUSTER_COMMAND_PUT_AREA.
    MusterRemoveArea removeArea;                  ///< For MUSTER_COMMAND_REMOVE_AREA.
    MusterSetPeople setPeople;                    ///< For MUSTER_COMMAND_SET_PEOPLE.
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
/// The kind as a word, for logs: "TouchDown". Null for other numbers.
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
