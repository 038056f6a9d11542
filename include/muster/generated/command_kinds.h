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

/// A finger touches down, moves or lifts, or its control ends at once. One that comes down edits the group
/// whose mesh is nearest within `input.reach`, or `group` if given; when it has lifted, its trajectory is
/// still followed.
struct Touch {
    TouchPhase phase = TouchPhase::Down;  ///< What it does.
    std::uint32_t touch = 0;              ///< Number of the finger, unique per client while it is down.
    Vec2 position;                        ///< For Down and Move: position in the world [m].
    double time = 0.0;                    ///< World time stamp [s]; not read for Cancel.
    GroupId group;                        ///< For Down: group to edit; none to pick it by position.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(phase, touch, position, time, group);
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
/// Pins a control at the end of its trajectory, releases it, or ends it at once.
struct EditControl {
    GroupId group;                        ///< Group that the control belongs to.
    ControlId control;                    ///< Its id.
    ControlEdit edit = ControlEdit::Pin;  ///< What is done to it.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, control, edit);
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
/// Changes what a group is. What is not given stays as it is. First comes the formation with its number of
/// places, then the sorts of people, who joins or leaves, and all else. Where one of them cannot be, none is
/// changed.
struct ChangeGroup {
    GroupId group;                                      ///< Group to change.
    std::optional<FormationDef> formation = {};         ///< Its formation; none for the one that it has.
    std::optional<std::int32_t> count = {};             ///< Its number of characters: new ones join behind
                                                        ///< the mesh, those with the highest ids leave first;
                                                        ///< none for the number that it has.
    std::optional<std::vector<PeopleDef>> people = {};  ///< Its sorts of persons, empty where all are as
                                                        ///< GroupDef::bodies say. Persons who join it are
                                                        ///< drawn by them from now on. Its present members
                                                        ///< are drawn again, as those who come at once: each
                                                        ///< number that neither the sorts before nor these
                                                        ///< draw stays as it is. A person who has heard an
                                                        ///< order sets out when it was to; none for the sorts
                                                        ///< that it has.
    std::optional<Conduct> conduct = {};                ///< How it behaves; none for as it does.
    std::optional<std::vector<RoleDef>> roles = {};     ///< Which class stands where, in the order in which
                                                        ///< they choose places; none for the roles that it
                                                        ///< has.
    std::optional<std::vector<double>> demands = {};    ///< How many units of supply each place demands (SPEC
                                                        ///< A1), 0 to 1000, of each place, or empty for 1
                                                        ///< each; none for the demands that these have.
    std::optional<std::string> name = {};               ///< Its name, of at most 4,096 bytes; none for the
                                                        ///< one that it has.
    std::optional<GroupColour> colour = {};             ///< Its colour; none for the one that it has.
    std::optional<GroupLook> look = {};                 ///< How its people look; none for as they do.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, formation, count, people, conduct, roles, demands, name, colour, look);
    }
};
/// Moves the mesh of a group at once; its places and its characters walk there, or stand there at once. Its
/// orders and controls end.
struct SetPose {
    GroupId group;            ///< Group to move.
    Vec2 position;            ///< New centre of the mesh in the world [m].
    double angle = 0.0;       ///< New heading, counter-clockwise from +x [rad].
    bool characters = false;  ///< True: its places and characters are there at once, and stand still.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, position, angle);
        archive.optionalSince(10, characters);
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
    std::uint32_t id = 0;                                   ///< Thing that gets another definition; 0 to add
                                                            ///< one.
    std::optional<ObstacleDef> obstacle = {};               ///< An obstacle; none for other things.
    std::optional<PatchDef> patch = {};                     ///< A patch; none for other things.
    std::optional<ItemDef> item = {};                       ///< An item to collect; none for other things.
    std::optional<FormationCheckpointDef> checkpoint = {};  ///< A formation checkpoint (SPEC M7), whose
                                                            ///< `group` is not read; none for other things.
    std::optional<AreaDef> area = {};                       ///< An area, whose `group` is not read; none for
                                                            ///< other things.
    GroupId group;                                          ///< Group that a checkpoint concerns, none for
                                                            ///< any, or that people of a source join.

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
/// Characters leave their groups for another one, or leave the world. Ids, positions and velocities stay. The
/// ranks behind them close up; a group may become empty, and stays.
struct TransferCharacters {
    std::vector<std::uint32_t> ids;  ///< Their ids.
    GroupId group;                   ///< Group that they join; none to leave the world.

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
/// Changes what characters are. What is not given stays as it is.
struct ChangeCharacters {
    std::vector<std::uint32_t> ids;                ///< Their ids.
    std::optional<std::vector<Body>> bodies = {};  ///< Their bodies, one for each or one for all; none for
                                                   ///< those that they have.
    std::optional<Driver> driver = {};             ///< What moves them; none for what moves them now.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, bodies, driver);
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
    Touch, AddControl, EditControl, ReleaseClient, ChangeGroup, SetPose, AddGroup, RemoveGroup, PutThing,
    RemoveThing, SetParameter, GiveOrder, EditQueue, AddCharacters, TransferCharacters, SplitGroup,
    MergeGroups, ChangeCharacters, WriteMotion, ReverseQueue>;
// clang-format on

}  // namespace muster
