// What directors do to groups beside edits of the place, and what takes that back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "muster/command.h"
#include "muster/event.h"
#include "muster/world.h"

namespace muster {

/// Ids of orders that no step has given yet are above this.
inline constexpr std::uint32_t kUnnamedOrders = 0x80000000u;
/// Ids in histories of things that were gone when the place began again are above this.
inline constexpr std::uint32_t kGoneThings = 0xC0000000u;

/// Commands, and the orders that they give.
struct CrowdCommands {
    /// An order that a command gives, under the id by which it is known until a step has named it.
    struct Order {
        std::size_t body = 0;
        std::uint32_t id = 0;
    };
    std::vector<CommandBody> bodies;
    std::vector<Order> orders;  ///< In the order of the commands.
};

/// A group's queue at one moment.
struct QueueState {
    std::vector<QueuedOrder> orders;
    bool held = false;
    bool patrols = false;
};

/// The queue of a group becomes another one.
struct QueueChange {
    GroupId group;
    QueueState before, after;
    /// The formation that the group had before an order gave it another one.
    std::optional<FormationDef> formation;
    bool undone = false;  ///< It leads to what was before.
};

/// Characters come, leave or change groups.
struct MemberChange {
    std::vector<CommandBody> redo, undo;
};

/// What is to be known of a group that is divided or joined, to bring it back.
struct PartState {
    GroupId id;
    GroupDef def;  ///< Name, colour, formation, conduct, roles and demands.
    std::vector<std::uint32_t> members;
    QueueState queue;
};

/// A group is divided, or groups are joined.
struct DivisionChange {
    CommandBody asked;             ///< SplitGroup or MergeGroups as it was given.
    PartState whole;               ///< The group that stays, before.
    std::vector<PartState> parts;  ///< The groups that come, or end.
    bool undone = false;           ///< It leads to what was before.

    bool splits() const { return std::holds_alternative<SplitGroup>(asked) != undone; }
};

using CrowdChange = std::variant<QueueChange, MemberChange, DivisionChange>;

/// True where both are equal in all parts.
bool sameBody(const CommandBody& a, const CommandBody& b);
/// About how many bytes they take.
std::size_t bytesOf(const CommandBody& body);
std::size_t bytesOf(const CrowdChange& crowdChange);
QueueState queueOf(const GroupView& group);
/// Changes the queue as the world will; an order that is given has that id.
void apply(QueueState& queue, const CommandBody& body, std::uint32_t id);
/// The group of the queue that a command changes; none for other commands.
GroupId queueChangedBy(const CommandBody& body);
/// Commands after which the group has these orders and no others.
void giveAll(const PartState& wanted, const GroupView& now, CrowdCommands& commands);

/// The change of the crowd that takes this one back.
CrowdChange reversed(CrowdChange crowdChange);
/// Adds the commands that do the change of the crowd in the world as it is, and notes what is to be known to
/// take it back. Adds none where nothing is left to do.
void commandsOf(CrowdChange& crowdChange, const World& world, CrowdCommands& commands);
/// Wherever the change of the crowd names that order, its id is `to`.
void renameOrder(CrowdChange& crowdChange, std::uint32_t from, std::uint32_t to);
/// Wherever the change of the crowd names that group, its id is `to`.
void renameGroup(CrowdChange& crowdChange, GroupId from, GroupId to);

/// What adds, removes or transfers characters, with what takes it back in the world as it is.
CrowdChange memberChange(const CommandBody& body, const World& world);

/// The change of the crowd of a command that is about to divide or join groups.
DivisionChange divisionOf(const CommandBody& asked, const World& world);
/// Adds the commands that divide or join. Adds none where too few of the groups are left.
void divisionCommands(DivisionChange& crowdChange, const World& world, CrowdCommands& commands);
/// The groups that came when the step divided one for this change of the crowd. Takes their events out.
std::vector<GroupId> takeNewParts(const DivisionChange& crowdChange, std::vector<Event>& added);
/// Adds what makes new groups what they were before they were joined.
void partsComeBack(const DivisionChange& crowdChange, const World& world, CrowdCommands& commands);

}  // namespace muster
