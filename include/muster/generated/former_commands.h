// Made by schema/generate.mjs from schema/former.txt: change these, not this file.
// Commands by the names that they had: CommandBody makes each into the command that says the same.
#pragma once

#include <variant>

#include "muster/generated/command_kinds.h"

namespace muster {

class CommandBody;

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
/// Adds an item to collect.
struct AddItem {
    ItemDef item;  ///< Its definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(item);
    }
};
/// Moves an item or changes its radius. Whether it is collected stays.
struct ChangeItem {
    ItemId id;     ///< Its id.
    ItemDef item;  ///< Its new definition.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, item);
    }
};
/// Removes an item.
struct RemoveItem {
    ItemId id;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// Adds a formation checkpoint (SPEC M7), which nobody has passed yet.
struct AddCheckpoint {
    FormationCheckpointDef checkpoint;  ///< Its definition; its `group` is not read.
    GroupId group;                      ///< Group that it concerns; none for any group.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(checkpoint, group);
    }
};
/// Changes a formation checkpoint. It stays passed by the groups that have passed it.
struct ChangeCheckpoint {
    CheckpointId id;                    ///< Its id.
    FormationCheckpointDef checkpoint;  ///< Its new definition; its `group` is not read.
    GroupId group;                      ///< Group that it concerns; none for any group.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, checkpoint, group);
    }
};
/// Removes a formation checkpoint.
struct RemoveCheckpoint {
    CheckpointId id;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
    }
};
/// Adds an area, or changes one.
struct PutArea {
    AreaId id;      ///< The area that is changed; none to add one.
    AreaDef area;   ///< Its definition; its `group` is not read.
    GroupId group;  ///< For Source: the group that its people join.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, area, group);
    }
};
/// Removes an area. People on their way to it go to the other areas of their order, or stand.
struct RemoveArea {
    AreaId id;  ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id);
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
    std::int32_t count = 0;  ///< New number of characters.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, count);
    }
};
/// Tells a group how to behave.
struct SetConduct {
    GroupId group;    ///< The group.
    Conduct conduct;  ///< How it behaves.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, conduct);
    }
};
/// Characters leave the world; the ranks behind them close up. A group may become empty, and stays.
struct RemoveCharacters {
    std::vector<std::uint32_t> ids;  ///< Their ids.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids);
    }
};
/// Gives characters other bodies.
struct SetBodies {
    std::vector<std::uint32_t> ids;  ///< Their ids.
    std::vector<Body> bodies;        ///< One for each, or one for all.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, bodies);
    }
};
/// Says which class stands where in a formation.
struct SetRoles {
    GroupId group;               ///< The group.
    std::vector<RoleDef> roles;  ///< In the order in which they choose places; empty for none.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, roles);
    }
};
/// Says how many units of supply each place demands (SPEC A1).
struct SetDemands {
    GroupId group;                ///< The group.
    std::vector<double> demands;  ///< Of each place, 0 to 1000; empty for 1 each.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, demands);
    }
};
/// Says what moves characters.
struct SetDriver {
    std::vector<std::uint32_t> ids;  ///< Their ids.
    Driver driver = Driver::Muster;  ///< What moves them.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, driver);
    }
};
/// Puts a group elsewhere at once: its mesh, its places, and its characters, who stand still there. Its
/// orders and controls end. (SetPose moves the mesh alone, and characters walk.)
struct PlaceGroup {
    GroupId group;       ///< The group.
    Vec2 position;       ///< New centre of the formation [m].
    double angle = 0.0;  ///< New heading, counter-clockwise from +x [rad].

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, position, angle);
    }
};
/// Gives a group another name.
struct NameGroup {
    GroupId group;     ///< The group.
    std::string name;  ///< At most 4,096 bytes.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, name);
    }
};
/// Gives a group another colour.
struct ColourGroup {
    GroupId group;                             ///< The group.
    std::optional<std::uint32_t> colour = {};  ///< 0xRRGGBB; none for the palette's, by the group's id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, colour);
    }
};
/// Gives the people of a group another appearance.
struct SetAppearance {
    GroupId group;                          ///< The group.
    std::optional<BodyBuild> build = {};    ///< Build of its drawn bodies; none for both, by the character's
                                            ///< id.
    std::optional<MotionSet> motions = {};  ///< How it walks and jogs; none for the plain manner.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, build, motions);
    }
};
/// Gives a group other sorts of persons. Persons who join it by number or by a source are drawn by them from
/// now on. Its present members are drawn again, as those who come at once: each number that neither the sorts
/// before nor these draw stays as it is. A person who has heard an order sets out when it was to.
struct SetPeople {
    GroupId group;                  ///< The group.
    std::vector<PeopleDef> people;  ///< Its sorts; none: all are as GroupDef::bodies say.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, people);
    }
};
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

CommandBody converted(const AddObstacle& c);       ///< The command that says the same.
CommandBody converted(const ChangeObstacle& c);    ///< The command that says the same.
CommandBody converted(const RemoveObstacle& c);    ///< The command that says the same.
CommandBody converted(const AddPatch& c);          ///< The command that says the same.
CommandBody converted(const ChangePatch& c);       ///< The command that says the same.
CommandBody converted(const RemovePatch& c);       ///< The command that says the same.
CommandBody converted(const AddItem& c);           ///< The command that says the same.
CommandBody converted(const ChangeItem& c);        ///< The command that says the same.
CommandBody converted(const RemoveItem& c);        ///< The command that says the same.
CommandBody converted(const AddCheckpoint& c);     ///< The command that says the same.
CommandBody converted(const ChangeCheckpoint& c);  ///< The command that says the same.
CommandBody converted(const RemoveCheckpoint& c);  ///< The command that says the same.
CommandBody converted(const PutArea& c);           ///< The command that says the same.
CommandBody converted(const RemoveArea& c);        ///< The command that says the same.
CommandBody converted(const SetFormation& c);      ///< The command that says the same.
CommandBody converted(const SetCount& c);          ///< The command that says the same.
CommandBody converted(const SetConduct& c);        ///< The command that says the same.
CommandBody converted(const RemoveCharacters& c);  ///< The command that says the same.
CommandBody converted(const SetBodies& c);         ///< The command that says the same.
CommandBody converted(const SetRoles& c);          ///< The command that says the same.
CommandBody converted(const SetDemands& c);        ///< The command that says the same.
CommandBody converted(const SetDriver& c);         ///< The command that says the same.
CommandBody converted(const PlaceGroup& c);        ///< The command that says the same.
CommandBody converted(const NameGroup& c);         ///< The command that says the same.
CommandBody converted(const ColourGroup& c);       ///< The command that says the same.
CommandBody converted(const SetAppearance& c);     ///< The command that says the same.
CommandBody converted(const SetPeople& c);         ///< The command that says the same.
CommandBody converted(const TouchDown& c);         ///< The command that says the same.
CommandBody converted(const TouchMove& c);         ///< The command that says the same.
CommandBody converted(const TouchUp& c);           ///< The command that says the same.
CommandBody converted(const TouchCancel& c);       ///< The command that says the same.
CommandBody converted(const PinControl& c);        ///< The command that says the same.
CommandBody converted(const RemoveControl& c);     ///< The command that says the same.

/// Any of them.
// clang-format off
using FormerKinds = std::variant<
    AddObstacle, ChangeObstacle, RemoveObstacle, AddPatch, ChangePatch, RemovePatch, AddItem, ChangeItem,
    RemoveItem, AddCheckpoint, ChangeCheckpoint, RemoveCheckpoint, PutArea, RemoveArea, SetFormation,
    SetCount, SetConduct, RemoveCharacters, SetBodies, SetRoles, SetDemands, SetDriver, PlaceGroup, NameGroup,
    ColourGroup, SetAppearance, SetPeople, TouchDown, TouchMove, TouchUp, TouchCancel, PinControl,
    RemoveControl>;
// clang-format on

}  // namespace muster
