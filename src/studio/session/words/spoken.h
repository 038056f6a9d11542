// What sentences leave to be done: orders to parts, once the world has made groups of them.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "studio/session/inbox/protocol.h"
#include "studio/words/words.h"

namespace muster {

/// The rest of a sentence of a director, which waits for its parts.
struct SpokenRest {
    std::uint32_t client = 0;    ///< Number of the director.
    std::uint32_t sentence = 0;  ///< Its commands and these are one step of the history.
    std::string label;
    std::vector<WordsPart> parts;
    std::vector<CommandBody> followers;
};

/// The commands of a rest, with the ids that its parts have now. A part that the world has not made takes its
/// commands with it.
std::vector<CommandBody> commandsOf(const SpokenRest& rest, const World& world);

/// Where people would stand, and what would come of the first order of each part.
void addPreviews(protocol::Said& said, const Understood& understood, const World& world);

}  // namespace muster
