// The words of the grammar.
#pragma once

#include <optional>
#include <span>
#include <string_view>
#include <vector>

#include "studio/words/clauses.h"

namespace muster::words {

/// How many words of a phrase the tokens begin with; 0 where they do not.
std::size_t matches(std::span<const Token> tokens, std::string_view phrase);

/// The verb that a phrase of one to three words is, with the number of its words; None for other words.
struct VerbFound {
    Verb verb = Verb::None;
    std::size_t words = 0;
};
VerbFound verbAt(std::span<const Token> tokens);

/// Words that may stand anywhere and say nothing: "please".
bool isFiller(std::string_view word);
std::optional<Heading> headingOf(std::string_view word);
std::optional<FormationKind> formOf(std::string_view word);
/// Half for "half", a third for "third" and "thirds"...
std::optional<double> shareOf(std::string_view word);
/// Metres of one "m", "metres", "feet"...
std::optional<double> metresOf(std::string_view word);
bool isPeopleWord(std::string_view word);
bool isEverybody(std::string_view word);
bool isRest(std::string_view word);
bool isGroupWord(std::string_view word);
/// All words that mean something, for suggestions.
std::span<const std::string_view> allWords();
/// What may be said of a group, for completions.
std::span<const std::string_view> commonPhrases();

/// "north", "the left".
std::string_view nameOf(Heading heading);

}  // namespace muster::words
