// Edits of a place: what they are about, and what takes them back.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/crowd_change.h"
#include "studio/session/history/place.h"

namespace muster {

/// What an edit is about.
enum class ThingKind : std::uint8_t { Obstacle, Patch, Item, Checkpoint, Group, Area, Characters, Parameter };

/// Names one thing of the place.
struct Thing {
    ThingKind kind = ThingKind::Obstacle;
    std::uint32_t id = 0;  ///< 0 for what is to be added, characters and parameters.
    friend bool operator==(const Thing&, const Thing&) = default;
};

/// One change and what takes it back.
struct PlaceChange {
    Thing thing;
    CommandBody redo;  ///< Makes it (again).
    CommandBody undo;  ///< Takes it back.
};

/// What one step of a director's history does.
struct PlaceStep {
    std::string label;                      ///< For people: "Move wall".
    std::uint32_t gesture = 0;              ///< Steps with the same number are one; 0: alone.
    std::vector<PlaceChange> changes;       ///< In the order in which they were made.
    bool directs = false;                   ///< It directs groups, and leaves the place as it is.
    std::uint32_t step = 0;                 ///< Of the world, when it was last done.
    std::vector<CrowdChange> crowdChanges;  ///< What else was done, where it directs.
    std::size_t bytes = 0;                  ///< About how large it is in a history.
};

/// What a command is about; nothing where it is no edit of a place.
std::optional<Thing> thingOf(const CommandBody& body);
/// True where it makes a new thing.
bool adds(const CommandBody& body);
/// True where the later change does the same to the same thing, so that it stands for both.
bool doesTheSame(const PlaceChange& later, const PlaceChange& earlier);
/// What takes the edit back in the world as it is before the edit; for what is to be added a removal of id 0.
/// Nothing where the world lacks what it is about.
std::optional<CommandBody> inverseOf(const CommandBody& body, const World& world, const Place& place);
/// Id of the newest thing in the world that `added` has made and that is not in `taken`; 0 for none.
std::uint32_t addedId(const CommandBody& added, const World& world, std::uint32_t after);
/// The highest ids of things in a world, by ThingKind.
std::vector<std::uint32_t> highestIds(const World& world);
/// Whoever names the thing `from` names the thing `to`.
void rename(CommandBody& body, Thing from, std::uint32_t to);

/// True where the edit that waits need not be carried out, because the later one does the same to the same
/// things.
bool overtakes(const std::vector<PlaceChange>& later, const std::vector<PlaceChange>& waiting);
/// Puts the changes of a later edit into the step, so that both are taken back together. What is as it was
/// before the step is left out.
void join(PlaceStep& step, std::vector<PlaceChange> later);

}  // namespace muster
