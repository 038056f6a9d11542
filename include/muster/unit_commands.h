// Commands that change who belongs to which group, and what they are.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "muster/id.h"
#include "muster/unit.h"

namespace muster {

/// Characters join a group where they stand; places are added to its formation. Events Joined tell their ids.
struct AddCharacters {
    GroupId group;                ///< Which they join.
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
    std::vector<std::uint32_t> ids;  ///< Who.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids);
    }
};
/// Characters leave their groups for another one. Ids, positions and velocities stay.
struct TransferCharacters {
    std::vector<std::uint32_t> ids;  ///< Who.
    GroupId group;                   ///< Which they join.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, group);
    }
};
/// Divides a group. The part that leaves is a new group, whose id the event GroupAdded tells; nobody stops,
/// and all parts go on with the orders of the whole.
struct SplitGroup {
    GroupId group;                   ///< Which.
    SplitBy by = SplitBy::Ids;       ///< How.
    std::vector<std::uint32_t> ids;  ///< For Ids: who leaves.
    std::vector<Vec2> points;        ///< For Line: two points; for Lasso: the corners of the polygon [m].
    std::vector<double> shares;      ///< For Shares: of all parts, above 0; their sum counts as the whole.
    bool abreast = false;            ///< For Shares: parts lie side by side, not one behind the other.
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
    std::vector<std::uint32_t> ids;  ///< Whose.
    std::vector<Body> bodies;        ///< One for each, or one for all.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, bodies);
    }
};
/// Says which class stands where in a formation.
struct SetRoles {
    GroupId group;               ///< Whose.
    std::vector<RoleDef> roles;  ///< In the order in which they choose places; empty for none.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, roles);
    }
};
/// Says how many units of supply each place demands (SPEC A1).
struct SetDemands {
    GroupId group;                ///< Whose.
    std::vector<double> demands;  ///< Of each place, 0 to 1000; empty for 1 each.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, demands);
    }
};
/// Says who moves characters.
struct SetDriver {
    std::vector<std::uint32_t> ids;  ///< Whom.
    Driver driver = Driver::Muster;  ///< Who moves them.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, driver);
    }
};
/// Where characters that are moved from outside are after this step.
struct WriteMotion {
    std::vector<std::uint32_t> ids;  ///< Who.
    std::vector<Vec2> positions;     ///< Where [m].
    std::vector<Vec2> velocities;    ///< How fast [m/s]; empty for what follows from the last positions.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(ids, positions, velocities);
    }
};

}  // namespace muster
