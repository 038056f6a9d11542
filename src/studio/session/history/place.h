// The place that is being made: what the world began from, with all that was edited since.
#pragma once

#include <vector>

#include "muster/command.h"
#include "muster/world.h"

namespace muster {

/// A group of the place.
struct PlaceGroupDef {
    GroupId id;    ///< In the world that goes on.
    GroupDef def;  ///< How it starts.
};

/// A definition, and the ids that its things have in the world that goes on, in their order. (What a map
/// makes comes behind them.)
struct PlaceDefinition {
    WorldDef def;
    std::vector<std::uint32_t> obstacles;
    std::vector<std::uint32_t> patches;
    std::vector<std::uint32_t> items;
    std::vector<std::uint32_t> checkpoints;
    std::vector<std::uint32_t> groups;
    std::vector<std::uint32_t> areas;
    std::vector<std::uint32_t> characters;  ///< 0 for those of a group that has other numbers of people.
};

/// Obstacles, patches, items, checkpoints and areas are those of the world. How groups start, and parameters,
/// are kept here: directing changes the groups of a world, and not where they start.
class Place {
public:
    /// A world began from that definition.
    void begin(const WorldDef& def);
    /// A world began from that definition(): groups and areas have new ids, and what was edited stays edited.
    void beginAgain(const PlaceDefinition& before);
    /// The world has carried out this edit.
    void apply(const CommandBody& edit, const World& world);
    /// A group that was removed has come back with a new id.
    void add(GroupId id, const GroupDef& def);
    /// A group has come back to the world with another id.
    void follow(GroupId before, GroupId now);

    /// True where something was edited.
    bool edited() const { return edited_; }
    /// Its groups, in the order in which they came.
    const std::vector<PlaceGroupDef>& groups() const { return groups_; }
    /// The group of that id; null where the place has none.
    const PlaceGroupDef* group(GroupId id) const;
    /// What a world begins from that has what is here now. `began` is what this world began from.
    PlaceDefinition definition(const WorldDef& began, const World& world) const;

private:
    PlaceGroupDef* find(GroupId id);
    void setBodies(const ChangeCharacters& set, const World& world);
    void addNewest(const GroupDef& def, const World& world);

    std::vector<PlaceGroupDef> groups_;
    std::vector<SetParameter> parameters_;  // In the order in which they were set.
    bool edited_ = false;
};

}  // namespace muster
