// A text as words, numbers and marks.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace muster::words {

/// A word in small letters, a number, or a mark as "," and "%".
struct Token {
    std::string text;
    std::optional<double> number;  ///< Of digits, and of words as "three" and "dozen".
    bool digits = false;           ///< It is written in digits.
    std::size_t from = 0;          ///< Where it begins in the text [bytes].
    std::size_t end = 0;
};

/// Words are runs of letters, with - and ' inside; what is no letter, digit or mark ends them and is left
/// out. "10m" is a number and a word.
std::vector<Token> tokensOf(std::string_view text);

/// A letter of A to Z as a small one; other characters as they are.
char smallLetter(char c);

/// The letters of a name in the form that tokens have, word by word.
std::vector<std::string> wordsOfName(std::string_view name);

/// How many letters have to be changed, left out, put in or exchanged with the next to make one word of the
/// other.
std::size_t lettersBetween(std::string_view a, std::string_view b);

}  // namespace muster::words
