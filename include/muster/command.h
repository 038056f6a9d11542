// Commands: the changes of a world, serialisable and stamped with a step.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "muster/generated/command_kinds.h"
#include "muster/generated/former_commands.h"
#include "muster/status.h"

namespace muster {

/// One of the structs that a command may hold, such as Touch.
template <class Kind>
concept CommandKind = !std::derived_from<std::remove_cvref_t<Kind>, CommandBody> &&
                      std::constructible_from<CommandKinds, Kind>;

/// A command by a name that it had: AddObstacle stands for a PutThing.
template <class Kind>
concept FormerCommand = requires(const Kind& kind) {
    { converted(kind) } -> std::same_as<CommandBody>;
};

/// A command that puts a new thing, or gives the one of that id another definition.
PutThing putThing(const ObstacleDef& def, ObstacleId id = {});
PutThing putThing(const PatchDef& def, PatchId id = {});  ///< The same of a patch.
PutThing putThing(const ItemDef& def, ItemId id = {});    ///< The same of an item.
/// The same of a checkpoint. `group`: the group that it concerns; none for any.
PutThing putThing(const FormationCheckpointDef& def, CheckpointId id = {}, GroupId group = {});
/// The same of an area. `group`: the group that the people of a source join.
PutThing putThing(const AreaDef& def, AreaId id = {}, GroupId group = {});

RemoveThing removeThing(ObstacleId id);    ///< A command that removes an obstacle.
RemoveThing removeThing(PatchId id);       ///< The same of a patch.
RemoveThing removeThing(ItemId id);        ///< The same of an item.
RemoveThing removeThing(CheckpointId id);  ///< The same of a checkpoint.
RemoveThing removeThing(AreaId id);        ///< The same of an area.

/// What a command puts: the first of its definitions that is given; none where none is.
std::optional<ThingKind> thingOf(const PutThing& put);

/// The body of a command: one of its kinds, for std::visit, std::get_if and the like. Copying, moving and
/// destroying are compiled once in the library, since each of them takes one function for each kind.
class CommandBody : public CommandKinds {
public:
    CommandBody() : CommandKinds(std::in_place_index<0>) {}  ///< A Touch.
    /// Holds this kind.
    template <CommandKind Kind>
    CommandBody(Kind&& kind) : CommandKinds(std::forward<Kind>(kind)) {}
    /// Holds what a command by a former name stands for.
    template <FormerCommand Kind>
    CommandBody(const Kind& kind) : CommandBody(converted(kind)) {}
    /// Holds the kind of that index.
    template <std::size_t Index>
    explicit CommandBody(std::in_place_index_t<Index> kind) : CommandKinds(kind) {}
    CommandBody(const CommandBody& other);                 ///< A copy.
    CommandBody(CommandBody&& other) noexcept;             ///< What the other held.
    CommandBody& operator=(const CommandBody& other);      ///< Becomes a copy.
    CommandBody& operator=(CommandBody&& other) noexcept;  ///< Takes what the other held.
    ~CommandBody();                                        ///< Destroys what it holds.
};

/// The command of a finger that does this; null for others.
const Touch* touchOf(const CommandBody& body, TouchPhase phase);
Touch* touchOf(CommandBody& body, TouchPhase phase);  ///< The same.

/// A change of a world, with its step and sender. Commands apply in the order of (step, client, sequence).
struct Command {
    std::uint32_t step = 0;      ///< It applies at the start of the step from `step` to `step + 1`.
    std::uint32_t client = 0;    ///< Number of the sender.
    std::uint32_t sequence = 0;  ///< Rises with each command of a client.
    CommandBody body;            ///< The change.
};

/// Encodes a command as bytes, for files and messages.
std::vector<std::uint8_t> encodeCommand(const Command& command);
/// Decodes a command. Fails with ParseError where there are too few or too many bytes, the kind is unknown or
/// a value is out of its range.
Result<Command> decodeCommand(std::span<const std::uint8_t> bytes);
/// The kind as a word, for logs: "Touch".
const char* commandName(const Command& command);
/// Checks what does not depend on the world. Fails with InvalidArgument where a number is not finite or out
/// of its range.
Status validateCommand(const Command& command);

/// A command that could not be applied, and why.
struct Rejection {
    Command command;  ///< The command that failed.
    Status status;    ///< Reason of the failure.
};

}  // namespace muster
