// The definition of what can be directed, in the words of the commands that set it, and how it differs before
// and after an act.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/names.h"
#include "studio/session/history/place.h"
#include "studio/session/history/queue_state.h"

namespace muster {

/// Names one property of one thing.
struct PartKey {
    Subject subject;
    std::size_t said = 0;    ///< Index of the kind of command that sets it.
    std::uint32_t part = 0;  ///< The control, for EditControl; the field, for ChangeGroup.
    friend auto operator<=>(const PartKey&, const PartKey&) = default;
};

/// One property before and after: the command that sets it, with names in the place of ids. None where the
/// thing is not there.
struct PartChange {
    PartKey key;
    std::optional<CommandBody> before, after;
    bool stays = false;  ///< It is set although both are equal, because what follows from the act changes it.
    bool passed = false;  ///< Somebody else has set it since: this time it is passed over.
};

/// The queue of a group before and after, with names in the place of ids.
struct QueueChange {
    std::uint32_t group = 0;
    QueueState before, after;
    bool stays = false;  ///< As of a PartChange.
};

/// What a character is.
struct MemberState {
    std::uint32_t group = 0;  ///< Name of its group; 0 where it is not in the world.
    Vec2 position;            ///< Where it stood [m].
    Body body;
};

/// A character before and after.
struct MemberChange {
    std::uint32_t character = 0;  ///< Its name.
    MemberState before, after;
    bool passed = false;  ///< As of a PartChange.
};

/// The characters of a group that comes or goes with all of them.
struct Crew {
    std::uint32_t group = 0;
    std::vector<std::uint32_t> characters;
    std::optional<GroupDef> start;  ///< How it starts, as the place has it; none for a group that it lacks.
};

/// The parts of a definition that differ.
struct Difference {
    std::vector<PartChange> parts;
    std::vector<QueueChange> queues;
    std::vector<MemberChange> members;  ///< By their names.
    std::vector<Crew> crews;

    /// True where nothing is another after than before.
    bool empty() const;
};

/// The world and the place, and the names of their things.
struct Scene {
    const World& world;
    const Place& place;
    Names& names;
};

/// True where the command, of one field, adds a thing, removes one, or sets a property that it says whole.
bool setsPart(const CommandBody& body);
/// The property that the command sets, of the thing that it names; of a new thing where it adds one. `start`:
/// that of how the group starts.
PartKey keyOf(const CommandBody& body, Names& names, bool start = false);
/// True where the property is the pose of a mesh, to which characters walk.
bool isMeshPose(const CommandBody& body);
/// True where the property is that the thing is there.
bool isPresence(const PartKey& key);
/// What the property is after a command that adds a thing, which has that id now, or sets one; with ids. None
/// for one that removes it.
std::optional<CommandBody> saidBy(const CommandBody& body, std::uint32_t id);
/// What the world says of the property that a command sets or removes; with names. None where it lacks the
/// thing. `start`: what the place says of how the group starts; none where its start does not tell.
std::optional<CommandBody> presentPart(const CommandBody& asked, bool start, const Scene& scene);
/// The command that sets the property: it adds a thing that is not there.
CommandBody adding(const CommandBody& said);
/// The command that removes the thing of which that is said.
CommandBody removing(const CommandBody& said, std::uint32_t id);
/// What presentPart() is asked for a part; with ids.
CommandBody askedOf(const PartChange& part, const Names& names);
/// What a character of that id is in the world.
MemberState presentMember(std::uint32_t id, const World& world, Names& names);

/// True where both are the same for whoever looks at it.
bool samePart(const std::optional<CommandBody>& a, const std::optional<CommandBody>& b);
/// The difference that takes this one back.
Difference reversed(Difference difference);
/// Both differences, one after the other.
void join(Difference& difference, Difference later);
/// Drops what is the same before and after.
void dropEqual(Difference& difference);
/// A difference is taken out of the middle: where a later one begins from what it led to, that begins from
/// what was before. What the later one has set stays, and is passed over in the former.
void takeOut(Difference& difference, Difference& later);
/// The things that it is about.
std::vector<Subject> subjectsOf(const Difference& difference);
/// About how many bytes it takes.
std::size_t bytesOf(const Difference& difference);

}  // namespace muster
