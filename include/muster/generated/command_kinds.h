// Made by schema/generate.mjs from schema/commands.txt: change these, not this file.
// The kinds of commands: every change of a world.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/world_definitions.h"
#include "muster/id.h"
#include "muster/order.h"
#include "muster/people.h"

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
    std::vector<Vec2> positions;            ///< Positions in the world, one per touch [m].
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
    std::int32_t count = 0;  ///< New number of characters.

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
/// Puts a thing into the place, or gives one another definition. Exactly one of the five definitions says
/// what it is. An item that is collected stays so, and a checkpoint stays passed by the groups that have
/// passed it.
struct PutThing {
    std::uint32_t id = 0;                              ///< Thing that gets another definition; 0 to add one.
    std::optional<ObstacleDef> obstacle;               ///< An obstacle; none for other things.
    std::optional<PatchDef> patch;                     ///< A patch; none for other things.
    std::optional<ItemDef> item;                       ///< An item to collect; none for other things.
    std::optional<FormationCheckpointDef> checkpoint;  ///< A formation checkpoint (SPEC M7), whose `group` is
                                                       ///< not read; none for other things.
    std::optional<AreaDef> area;                       ///< An area, whose `group` is not read; none for other
                                                       ///< things.
    GroupId group;                                     ///< Group that a checkpoint concerns, none for any, or
                                                       ///< that people of a source join.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, obstacle, patch, item, checkpoint, area, group);
    }
};
/// Removes a thing. People on their way to an area that is removed go to the other areas of their order, or
/// stand.
struct RemoveThing {
    ThingKind thing = ThingKind::Obstacle;  ///< What it is.
    std::uint32_t id = 0;                   ///< Its id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(thing, id);
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
/// Puts an order into a group's queue. The event OrderGiven tells its id.
struct GiveOrder {
    GroupId group;                        ///< The group.
    QueueMode mode = QueueMode::Replace;  ///< Where the order stands in the queue.
    std::uint32_t index = 0;              ///< For Insert: before which order, counted from 0.
    Order order;                          ///< The order.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, mode, index, order);
    }
};
/// Changes a group's queue.
struct EditQueue {
    GroupId group;                       ///< The group.
    QueueEdit edit = QueueEdit::Cancel;  ///< What is done to the queue.
    std::uint32_t order = 0;             ///< For Cancel: the id of the order; 0 for all.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, edit, order);
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
/// Characters join a group where they stand; places are added to its formation. Events Joined tell their ids.
struct AddCharacters {
    GroupId group;                ///< Group that they join.
    std::vector<Vec2> positions;  ///< Where they stand [m]; they part where they would stand in each other.
    std::vector<Body> bodies;     ///< One for each, or one for all; empty for that of the group.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, positions, bodies);
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
/// Characters leave their groups for another one. Ids, positions and velocities stay.
struct TransferCharacters {
    std::vector<std::uint32_t> ids;  ///< Their ids.
    GroupId group;                   ///< Group that they join.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, group);
    }
};
/// Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops,
/// and all parts go on with the orders of the whole.
struct SplitGroup {
    GroupId group;                        ///< The group.
    SplitBy by = SplitBy::Ids;            ///< How it is divided.
    std::vector<std::uint32_t> ids;       ///< For Ids: the characters that leave.
    std::vector<Vec2> points;             ///< For Line: two points [m]; for Lasso: the corners of the
                                          ///< polygon.
    std::vector<double> shares;           ///< For Shares: of all parts, above 0; their sum counts as the
                                          ///< whole.
    bool abreast = false;                 ///< For Shares: parts lie side by side, not one behind the other.
    PartShape shape = PartShape::AsHeld;  ///< Formation of the parts.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, by, ids, points, shares, abreast, shape);
    }
};
/// Joins groups to the first of them; the others end.
struct MergeGroups {
    std::vector<GroupId> groups;           ///< Two or more.
    PartShape shape = PartShape::Smaller;  ///< Smaller: the formation of the first for all; AsHeld: all
                                           ///< places stay.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(groups, shape);
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
/// Where characters that are moved from outside are after this step.
struct WriteMotion {
    std::vector<std::uint32_t> ids;  ///< Their ids.
    std::vector<Vec2> positions;     ///< Where they are [m].
    std::vector<Vec2> velocities;    ///< Their velocities [m/s]; empty for what follows from the last
                                     ///< positions.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, positions, velocities);
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
    GroupId group;                        ///< The group.
    std::optional<std::uint32_t> colour;  ///< 0xRRGGBB; none for the palette's, by the group's id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, colour);
    }
};
/// Gives the people of a group another appearance.
struct SetAppearance {
    GroupId group;                     ///< The group.
    std::optional<BodyBuild> build;    ///< Build of its drawn bodies; none for both, by the character's id.
    std::optional<MotionSet> motions;  ///< How it walks and jogs; none for the plain manner.

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
/// Reverses the orders of a group's queue: the last one begins, and what is under way comes last.
struct ReverseQueue {
    GroupId group;  ///< The group.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group);
    }
};

/// Every kind of change.
// clang-format off
using CommandKinds = std::variant<
    TouchDown, TouchMove, TouchUp, TouchCancel, AddControl, PinControl, RemoveControl, ReleaseClient,
    SetFormation, SetCount, SetPose, AddGroup, RemoveGroup, PutThing, RemoveThing, SetParameter, GiveOrder,
    EditQueue, SetConduct, AddCharacters, RemoveCharacters, TransferCharacters, SplitGroup, MergeGroups,
    SetBodies, SetRoles, SetDemands, SetDriver, WriteMotion, PlaceGroup, NameGroup, ColourGroup,
    SetAppearance, SetPeople, ReverseQueue>;
// clang-format on

}  // namespace muster
