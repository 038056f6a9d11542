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

/// Any of them.
// clang-format off
using FormerKinds = std::variant<
    AddObstacle, ChangeObstacle, RemoveObstacle, AddPatch, ChangePatch, RemovePatch, AddItem, ChangeItem,
    RemoveItem, AddCheckpoint, ChangeCheckpoint, RemoveCheckpoint, PutArea, RemoveArea>;
// clang-format on

}  // namespace muster
