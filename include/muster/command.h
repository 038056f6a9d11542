// The only way to change a world: serialisable, step-stamped commands.
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
    template <class Archive>
    void visit(Archive& a) {
        a(touch, position, time, group);
    }  ///< For archives.
};
/// A finger moves.
struct TouchMove {
    std::uint32_t touch = 0;
    Vec2 position;      ///< World [m].
    double time = 0.0;  ///< World time stamp [s].
    template <class Archive>
    void visit(Archive& a) {
        a(touch, position, time);
    }  ///< For archives.
};
/// A finger lifts; its path is still followed.
struct TouchUp {
    std::uint32_t touch = 0;
    double time = 0.0;  ///< World time stamp [s].
    template <class Archive>
    void visit(Archive& a) {
        a(touch, time);
    }  ///< For archives.
};
/// The control of a finger ends at once.
struct TouchCancel {
    std::uint32_t touch = 0;
    template <class Archive>
    void visit(Archive& a) {
        a(touch);
    }  ///< For archives.
};
/// A whole control at once (mouse and API). Its points are then moved and lifted like touches.
struct AddControl {
    GroupId group;
    ControlKind kind = ControlKind::Point;
    std::vector<std::uint32_t> touches;
    std::vector<Vec2> positions;  ///< World [m], one per touch.
    double time = 0.0;            ///< World time stamp [s].
    /// For archives.
    template <class Archive>
    void visit(Archive& a) {
        a(group, kind, touches, positions, time);
    }
};
/// Keeps a control where its path ends, or lets it go.
struct PinControl {
    GroupId group;
    ControlId control;
    bool pinned = true;
    template <class Archive>
    void visit(Archive& a) {
        a(group, control, pinned);
    }  ///< For archives.
};
/// Ends a control at once.
struct RemoveControl {
    GroupId group;
    ControlId control;
    template <class Archive>
    void visit(Archive& a) {
        a(group, control);
    }  ///< For archives.
};
/// A client has gone: its fingers lift.
struct ReleaseClient {
    std::uint8_t unused = 0;
    template <class Archive>
    void visit(Archive& a) {
        a(unused);
    }  ///< For archives.
};
/// The group takes another formation.
struct SetFormation {
    GroupId group;
    FormationDef formation;
    template <class Archive>
    void visit(Archive& a) {
        a(group, formation);
    }  ///< For archives.
};
/// Characters join (beside the mesh) or leave (highest ids first).
struct SetCount {
    GroupId group;
    std::int32_t count = 0;
    template <class Archive>
    void visit(Archive& a) {
        a(group, count);
    }  ///< For archives.
};
/// Puts the mesh somewhere at once; places travel there.
struct SetPose {
    GroupId group;
    Vec2 position;       ///< [m]
    double angle = 0.0;  ///< [rad]
    template <class Archive>
    void visit(Archive& a) {
        a(group, position, angle);
    }  ///< For archives.
};
/// A new group.
struct AddGroup {
    GroupDef group;
    template <class Archive>
    void visit(Archive& a) {
        a(group);
    }  ///< For archives.
};
/// A group and its characters go.
struct RemoveGroup {
    GroupId group;
    template <class Archive>
    void visit(Archive& a) {
        a(group);
    }  ///< For archives.
};
/// A new obstacle.
struct AddObstacle {
    ObstacleDef obstacle;
    template <class Archive>
    void visit(Archive& a) {
        a(obstacle);
    }  ///< For archives.
};
/// Another shape, place, path or field for an obstacle.
struct ChangeObstacle {
    ObstacleId id;
    ObstacleDef obstacle;
    template <class Archive>
    void visit(Archive& a) {
        a(id, obstacle);
    }  ///< For archives.
};
/// An obstacle goes.
struct RemoveObstacle {
    ObstacleId id;
    template <class Archive>
    void visit(Archive& a) {
        a(id);
    }  ///< For archives.
};
/// A new patch.
struct AddPatch {
    PatchDef patch;
    template <class Archive>
    void visit(Archive& a) {
        a(patch);
    }  ///< For archives.
};
/// Another shape, place, path or motion for a patch.
struct ChangePatch {
    PatchId id;
    PatchDef patch;
    template <class Archive>
    void visit(Archive& a) {
        a(id, patch);
    }  ///< For archives.
};
/// A patch goes.
struct RemovePatch {
    PatchId id;
    template <class Archive>
    void visit(Archive& a) {
        a(id);
    }  ///< For archives.
};
/// Another value for a parameter.
struct SetParameter {
    std::string name;
    double value = 0.0;
    template <class Archive>
    void visit(Archive& a) {
        a(name, value);
    }  ///< For archives.
};

/// One of all. The order of alternatives is part of the file format: append only.
using CommandBody = std::variant<TouchDown, TouchMove, TouchUp, TouchCancel, AddControl, PinControl,
                                 RemoveControl, ReleaseClient, SetFormation, SetCount, SetPose, AddGroup,
                                 RemoveGroup, AddObstacle, ChangeObstacle, RemoveObstacle, AddPatch,
                                 ChangePatch, RemovePatch, SetParameter>;

/// A change, when it applies and who asked for it. Applied in (step, client, sequence) order.
struct Command {
    std::uint32_t step = 0;      ///< Applied at the start of the step that leads from `step` to `step + 1`.
    std::uint32_t client = 0;    ///< Who sent it.
    std::uint32_t sequence = 0;  ///< Rises with each command of a client.
    CommandBody body;
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
