// Commands: the changes of a world, serialisable and stamped with a step.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "muster/control.h"
#include "muster/id.h"
#include "muster/world_def.h"

namespace muster {

/// A finger comes down. It edits the group whose mesh is nearest within `input.reach`, or `group` if given.
struct TouchDown {
    std::uint32_t touch = 0;  ///< Unique per client while it is down.
    Vec2 position;            ///< World [m].
    double time = 0.0;        ///< World time stamp [s].
    GroupId group;            ///< None to pick by position.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(touch, position, time, group);
    }
};
/// A finger moves.
struct TouchMove {
    std::uint32_t touch = 0;  ///< Number of the finger.
    Vec2 position;            ///< World [m].
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
/// A whole control at once, for mouse and program. Its points are then moved and lifted like touches.
struct AddControl {
    GroupId group;                          ///< Whose mesh it holds.
    ControlKind kind = ControlKind::Point;  ///< Must suit the number of touches.
    std::vector<std::uint32_t> touches;     ///< Numbers of its fingers, 1 to 64.
    std::vector<Vec2> positions;            ///< World [m], one per touch.
    double time = 0.0;                      ///< World time stamp [s].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, kind, touches, positions, time);
    }
};
/// Pins a control where its trajectory ends, or lets it go.
struct PinControl {
    GroupId group;       ///< Whose control it is.
    ControlId control;   ///< Which one.
    bool pinned = true;  ///< False to let it go.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, control, pinned);
    }
};
/// Ends a control at once.
struct RemoveControl {
    GroupId group;      ///< Whose control it is.
    ControlId control;  ///< Which one.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, control);
    }
};
/// A client has gone: its fingers lift.
struct ReleaseClient {
    std::uint8_t unused = 0;  ///< Keeps the format from being empty.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(unused);
    }
};
/// The group takes another formation.
struct SetFormation {
    GroupId group;           ///< Which one.
    FormationDef formation;  ///< What it becomes.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, formation);
    }
};
/// Characters join behind the mesh, or leave, those with the highest ids first.
struct SetCount {
    GroupId group;           ///< Which one.
    std::int32_t count = 0;  ///< Characters that it has then, 1 to 200,000.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, count);
    }
};
/// Puts the mesh elsewhere at once; places travel there.
struct SetPose {
    GroupId group;       ///< Which one.
    Vec2 position;       ///< Of its centre [m].
    double angle = 0.0;  ///< Of its heading, from +x counter-clockwise [rad].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, position, angle);
    }
};
/// A new group.
struct AddGroup {
    GroupDef group;  ///< What it is.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group);
    }
};
/// A group and its characters are removed.
struct RemoveGroup {
    GroupId group;  ///< Which one.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group);
    }
};
/// A new obstacle.
struct AddObstacle {
    ObstacleDef obstacle;  ///< What it is.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(obstacle);
    }
};
/// An obstacle gets another shape, position, path or field.
struct ChangeObstacle {
    ObstacleId id;         ///< Which one.
    ObstacleDef obstacle;  ///< What it becomes.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, obstacle);
    }
};
/// An obstacle is removed.
struct RemoveObstacle {
    ObstacleId id;  ///< Which one.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// A new patch.
struct AddPatch {
    PatchDef patch;  ///< What it is.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(patch);
    }
};
/// A patch gets another shape, position, path or motion.
struct ChangePatch {
    PatchId id;      ///< Which one.
    PatchDef patch;  ///< What it becomes.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, patch);
    }
};
/// A patch is removed.
struct RemovePatch {
    PatchId id;  ///< Which one.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// A parameter gets another value.
struct SetParameter {
    std::string name;    ///< As in parameterTable(): "plan.exponent".
    double value = 0.0;  ///< In its range.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(name, value);
    }
};

/// The body of a command. The order of alternatives is part of the file format: append only.
using CommandBody = std::variant<TouchDown, TouchMove, TouchUp, TouchCancel, AddControl, PinControl,
                                 RemoveControl, ReleaseClient, SetFormation, SetCount, SetPose, AddGroup,
                                 RemoveGroup, AddObstacle, ChangeObstacle, RemoveObstacle, AddPatch,
                                 ChangePatch, RemovePatch, SetParameter>;

/// A change of a world, when it applies and who sent it. Applied in (step, client, sequence) order.
struct Command {
    std::uint32_t step = 0;      ///< Applied at the start of the step that leads from `step` to `step + 1`.
    std::uint32_t client = 0;    ///< Who sent it.
    std::uint32_t sequence = 0;  ///< Rises with each command of a client.
    CommandBody body;            ///< What it changes.
};

/// A command as bytes, to send it to another world.
std::vector<std::uint8_t> encodeCommand(const Command& command);
/// A command from these bytes. Fails with ParseError where they are short or too many, the kind is unknown or
/// a value is out of its range.
Result<Command> decodeCommand(std::span<const std::uint8_t> bytes);
/// The kind as a word, for logs: "TouchDown".
const char* commandName(const Command& command);
/// InvalidArgument where a number is not finite or out of its range, whatever the world.
Status validateCommand(const Command& command);

}  // namespace muster
