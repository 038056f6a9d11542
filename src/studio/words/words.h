// Directing by words: a sentence becomes the commands that fingers and buttons give (docs/method/words.md).
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"

namespace muster {

/// What a sentence is said about.
struct WordsScene {
    const World& world;
    std::span<const GroupId> chosen;  ///< Whom it is about where it names nobody.
};

/// What a sentence wants of time and of the history.
enum class WordsDeed : std::uint8_t { None, Play, Pause, Restart, Undo, Redo };

/// A part of a group that becomes a group of its own, once the world has divided it.
struct WordsPart {
    GroupId standIn;              ///< Stands in for its id in the commands that follow.
    std::uint32_t character = 0;  ///< Id of one of its people.
    GroupId from;                 ///< The group that is divided.
};

/// The first order of a group or a part, to be shown before it is given.
struct WordsPreview {
    GroupId group;                   ///< The group that they are in now.
    std::vector<std::uint32_t> ids;  ///< The people of a part; empty for the whole group.
    Order order;
};

/// What a sentence comes to. Where there is a problem nothing is to be done.
struct Understood {
    std::vector<std::string> sentences;  ///< What each group does, a plain sentence each.
    std::string problem;                 ///< What is not understood or cannot be; empty where all is well.
    std::vector<CommandBody> commands;   ///< In their order.
    std::vector<CommandBody> edits;      ///< Changes of the place.
    std::vector<CommandBody> followers;  ///< Once the parts are groups, which they name by stand-ins.
    std::vector<WordsPart> parts;
    std::vector<WordsPreview> previews;
    WordsDeed deed = WordsDeed::None;
    std::optional<double> speed;  ///< How much faster than real time.
};

/// Reads a text of one or several sentences. The same text and world give the same commands.
Understood understand(std::string_view text, const WordsScene& scene);

/// One way to go on with a text.
struct WordsCompletion {
    std::string words;  ///< What comes next.
    std::string whole;  ///< The text with it.
};
/// How a text may go on: names of groups and things first, then other words; at most eight.
std::vector<WordsCompletion> completions(std::string_view text, const WordsScene& scene);

/// Puts the ids of groups in the place of their stand-ins.
void replaceStandIn(CommandBody& body, GroupId standIn, GroupId group);

/// Groups with their people and orders, and things, with their ids and places, a line each.
std::vector<std::string> lookAround(const World& world);
/// The ground from above as lines of letters, north at the top, with a key below.
std::vector<std::string> mapFromAbove(const World& world);

}  // namespace muster
