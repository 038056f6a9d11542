// Names by which histories know things, whatever ids these have in the world that goes on.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "muster/command.h"

namespace muster {

/// What has ids of its own: things, in the order of ThingKind, and others.
enum class SubjectKind : std::uint8_t {
    Obstacle,
    Patch,
    Item,
    Checkpoint,
    Area,
    Group,
    Character,
    Order,
    Parameter,  ///< Its id is its index in parameterTable().
    Start,      ///< How a group starts, as the place has it; its name is that of the group.
};
inline constexpr std::size_t kSubjectKinds = 10;

/// The kind of a thing.
inline SubjectKind subjectOf(ThingKind thing) {
    return static_cast<SubjectKind>(thing);
}

/// Names one of them.
struct Subject {
    SubjectKind kind = SubjectKind::Obstacle;
    std::uint32_t name = 0;
    friend auto operator<=>(const Subject&, const Subject&) = default;
};

/// The one table of ids. A thing that comes back has another id, and its name stays.
class Names {
public:
    /// The name of the thing that has this id in the world; 0 for 0.
    std::uint32_t nameOf(SubjectKind kind, std::uint32_t id);
    /// The id that the thing has, or had last; 0 for 0.
    std::uint32_t idOf(SubjectKind kind, std::uint32_t name) const;
    /// The thing has come, or come back, with that id.
    void bind(SubjectKind kind, std::uint32_t name, std::uint32_t id);
    /// Things that had these ids have the ids 1, 2, 3... from now on, in their order; all others are gone. An
    /// id of 0 stands for a thing that nothing is known of.
    void renumber(SubjectKind kind, const std::vector<std::uint32_t>& ids);
    /// Nothing is known of any thing.
    void clear();

    /// Puts names in the place of ids, or ids in the place of names, wherever a command has some.
    void toNames(CommandBody& body);
    void toIds(CommandBody& body) const;
    void toNames(QueuedOrder& order);
    void toIds(QueuedOrder& order) const;

private:
    struct Table {
        std::map<std::uint32_t, std::uint32_t> ids;    // By name.
        std::map<std::uint32_t, std::uint32_t> names;  // By id.
    };
    Table& table(SubjectKind kind) { return tables_[static_cast<std::size_t>(kind)]; }
    const Table& table(SubjectKind kind) const { return tables_[static_cast<std::size_t>(kind)]; }

    std::array<Table, kSubjectKinds> tables_;
    std::uint32_t last_ = 0x80000000u;  // Of the names that are no ids.
};

}  // namespace muster
