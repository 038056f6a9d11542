// Commands: the changes of a world, serialisable and stamped with a step.
#pragma once

#include <concepts>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>
#include <vector>

#include "muster/control.h"
#include "muster/id.h"
#include "muster/order_commands.h"
#include "muster/place_commands.h"
#include "muster/status.h"
#include "muster/unit_commands.h"
#include "muster/world_def.h"

namespace muster {

/// A finger touches down. It edits the group whose mesh is nearest within `input.reach`, or `group` if given.
struct TouchDown {
    std::uint32_t touch = 0;  ///< Number of the finger, unique per client while it is down.
    Vec2 position;            ///< Position in the world [m].
    double time = 0.0;        ///< World time stamp [s].
    GroupId group;            ///< Group to edit; none to pick it by position.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch, position, time, group);
    }
};
/// A finger moves.
struct TouchMove {
    std::uint32_t touch = 0;  ///< Number of the finger.
    Vec2 position;            ///< Position in the world [m].
    double time = 0.0;        ///< World time stamp [s].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch, position, time);
    }
};
/// A finger lifts; its trajectory is still followed.
struct TouchUp {
    std::uint32_t touch = 0;  ///< Number of the finger.
    double time = 0.0;        ///< World time stamp [s].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch, time);
    }
};
/// The control of a finger ends at once.
struct TouchCancel {
    std::uint32_t touch = 0;  ///< Number of the finger.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch);
    }
};
/// Makes a control of all its points at once, for mouse and programs. Its points are then moved and lifted
/// like touches.
struct AddControl {
    GroupId group;                          ///< Group whose mesh it controls.
    ControlKind kind = ControlKind::Point;  ///< Kind of control, which must fit the number of touches.
    std::vector<std::uint32_t> touches;     ///< Numbers of its fingers, 1 to 64.
    std::vector<Vec2> positions;            ///< Positions in the world [m], one per touch.
    double time = 0.0;                      ///< World time stamp [s].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, kind, touches, positions, time);
    }
};
/// Pins a control at the end of its trajectory, or releases it.
struct PinControl {
    GroupId group;       ///< Group that the control belongs to.
    ControlId control;   ///< Its id.
    bool pinned = true;  ///< False to release it.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, control, pinned);
    }
};
/// Ends a control at once.
struct RemoveControl {
    GroupId group;      ///< Group that the control belongs to.
    ControlId control;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, control);
    }
};
/// A client has disconnected: all its fingers lift.
struct ReleaseClient {
    std::uint8_t unused = 0;  ///< Not used; archives need at least one field.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(unused);
    }
};
/// The group takes another formation.
struct SetFormation {
    GroupId group;           ///< Group to change.
    FormationDef formation;  ///< Its new definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, formation);
    }
};
/// Changes the number of characters. New ones join behind the mesh; those with the highest ids leave first.
struct SetCount {
    GroupId group;           ///< Group to change.
    std::int32_t count = 0;  ///< New number of characters, 1 to 200,000.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, count);
    }
};
/// Moves the mesh at once; its places travel there.
struct SetPose {
    GroupId group;       ///< Group to move.
    Vec2 position;       ///< New centre of the mesh in the world [m].
    double angle = 0.0;  ///< New heading, counter-clockwise from +x [rad].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, position, angle);
    }
};
/// Adds a group.
struct AddGroup {
    GroupDef group;  ///< Its definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group);
    }
};
/// Removes a group and its characters.
struct RemoveGroup {
    GroupId group;  ///< Group to remove.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group);
    }
};
/// Adds an obstacle.
struct AddObstacle {
    ObstacleDef obstacle;  ///< Its definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(obstacle);
    }
};
/// Changes shape, position, path or field of an obstacle.
struct ChangeObstacle {
    ObstacleId id;         ///< Its id.
    ObstacleDef obstacle;  ///< Its new definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, obstacle);
    }
};
/// Removes an obstacle.
struct RemoveObstacle {
    ObstacleId id;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// Adds a patch.
struct AddPatch {
    PatchDef patch;  ///< Its definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(patch);
    }
};
/// Changes shape, position, path or motion of a patch.
struct ChangePatch {
    PatchId id;      ///< Its id.
    PatchDef patch;  ///< Its new definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, patch);
    }
};
/// Removes a patch.
struct RemovePatch {
    PatchId id;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// Changes the value of a parameter.
struct SetParameter {
    std::string name;    ///< Name in parameterTable(): "plan.exponent".
    double value = 0.0;  ///< New value, in the range of the parameter.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, value);
    }
};

/// Every kind of change. The order of alternatives is part of the file format: append only.
using CommandKinds = std::variant<
    TouchDown, TouchMove, TouchUp, TouchCancel, AddControl, PinControl, RemoveControl, ReleaseClient,
    SetFormation, SetCount, SetPose, AddGroup, RemoveGroup, AddObstacle, ChangeObstacle, RemoveObstacle,
    AddPatch, ChangePatch, RemovePatch, SetParameter, GiveOrder, EditQueue, SetConduct, AddCharacters,
    RemoveCharacters, TransferCharacters, SplitGroup, MergeGroups, SetBodies, SetRoles, SetDemands, SetDriver,
    WriteMotion, AddItem, ChangeItem, RemoveItem, AddCheckpoint, ChangeCheckpoint, RemoveCheckpoint,
    PlaceGroup, NameGroup, ColourGroup, SetAppearance, PutArea, RemoveArea, SetPeople>;

/// The body of a command: one of its kinds, for std::visit, std::get_if and the like. Copying, moving and
/// destroying are compiled once in the library, since each of them takes one function for each kind.
class CommandBody : public CommandKinds {
public:
    CommandBody() : CommandKinds(std::in_place_index<0>) {}  ///< A TouchDown.
    /// Holds this kind.
    template <class Kind>
    requires(!std::derived_from<std::remove_cvref_t<Kind>, CommandBody> &&
             std::constructible_from<CommandKinds, Kind>) CommandBody(Kind&& kind)
        : CommandKinds(std::forward<Kind>(kind)) {}
    /// Holds the kind of that index.
    template <std::size_t Index>
    explicit CommandBody(std::in_place_index_t<Index> kind) : CommandKinds(kind) {}
    CommandBody(const CommandBody& other);                 ///< A copy.
    CommandBody(CommandBody&& other) noexcept;             ///< What the other held.
    CommandBody& operator=(const CommandBody& other);      ///< Becomes a copy.
    CommandBody& operator=(CommandBody&& other) noexcept;  ///< Takes what the other held.
    ~CommandBody();                                        ///< Destroys what it holds.
};

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
/// The kind as a word, for logs: "TouchDown".
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
