// Words and numbers of a BVH file, with line numbers.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

#include "muster/status.h"

namespace muster {

/// Walks through text. Words end at white space, braces stand alone. Never reads beyond the text.
class BvhScanner {
public:
    BvhScanner(std::string_view text, std::string sourceName) : text_(text), source_(std::move(sourceName)) {}

    /// The next word, "{" or "}"; empty at the end.
    std::string_view word();
    /// The next word as far as it consists of letters: "Frames" of "Frames:3".
    std::string_view keyword();
    /// What is left of the line, or up to a brace, without white space at its ends; colons at its front are
    /// skipped.
    std::string_view restOfLine();
    /// A finite number of at most 1e9; false where the next word is none (it is consumed).
    bool number(double& value);
    /// A count written as a whole number, 0 to 1e9; false where the next word is none.
    bool count(std::size_t& value);
    /// Skips colons, alone or at the front of a word.
    void skipColons();
    /// Line of the last word, from 1.
    std::size_t line() const { return wordLine_; }
    /// Bytes not yet read.
    std::size_t left() const { return text_.size() - at_; }
    /// `SOURCE:LINE: found FOUND, expected EXPECTED`, with the last word where `found` is empty.
    Status unexpected(std::string_view expected, std::string_view found = {}) const;

private:
    void skipSpace();

    std::string_view text_;
    std::string source_;
    std::size_t at_ = 0;
    std::size_t line_ = 1;
    std::size_t wordLine_ = 1;
    std::string_view last_;
};

/// True where two words differ in case at most.
bool sameWord(std::string_view a, std::string_view b);
/// Letters as small ones; only of ASCII.
std::string lowered(std::string_view text);

}  // namespace muster
