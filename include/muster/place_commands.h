// Commands that change what lies on the ground, and where groups stand, while a world runs.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/id.h"
#include "muster/people.h"
#include "muster/world_def.h"

namespace muster {

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
    GroupId group;                      ///< Whom it concerns; none for any group.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(checkpoint, group);
    }
};
/// Changes a formation checkpoint. Who has passed it stays.
struct ChangeCheckpoint {
    CheckpointId id;                    ///< Its id.
    FormationCheckpointDef checkpoint;  ///< Its new definition; its `group` is not read.
    GroupId group;                      ///< Whom it concerns; none for any group.

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
/// Puts a group elsewhere at once: its mesh, its places, and its characters, who stand still there. Its
/// orders and controls end. (SetPose moves the mesh alone, and characters walk.)
struct PlaceGroup {
    GroupId group;       ///< Which.
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
    GroupId group;     ///< Which.
    std::string name;  ///< At most 4,096 bytes.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, name);
    }
};
/// Gives a group another colour.
struct ColourGroup {
    GroupId group;                        ///< Which.
    std::optional<std::uint32_t> colour;  ///< 0xRRGGBB; none for the palette's, by the group's id.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, colour);
    }
};
/// Gives the people of a group another appearance.
struct SetAppearance {
    GroupId group;                     ///< Which.
    std::optional<BodyBuild> build;    ///< Of its drawn bodies; none for both, by the character's id.
    std::optional<MotionSet> motions;  ///< How it walks and jogs; none for the plain manner.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, build, motions);
    }
};
/// Gives a group other sorts of persons. Whoever joins it by number or by a source is drawn by them from now
/// on. Those who are in it are drawn again, as those who come at once: each number that neither the sorts
/// before nor these draw stays as it is. Whoever has heard an order sets out when it was to.
struct SetPeople {
    GroupId group;                  ///< Which.
    std::vector<PeopleDef> people;  ///< Its sorts; none: all are as GroupDef::bodies say.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, people);
    }
};

}  // namespace muster
