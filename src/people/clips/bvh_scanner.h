// Splits the text of a BVH file into words and numbers and counts lines.
#pragma once

#include <cstddef>
#include <cstdlib>
#include <string>
#include <string_view>

#include "muster/status.h"

namespace muster {

/// Scans a text. Words end at white space; a brace is a word of its own. It never reads beyond the text.
class BvhScanner {
public:
    BvhScanner(std::string_view text, std::string sourceName) : text_(text), source_(std::move(sourceName)) {}

    /// The next word, "{" or "}"; empty at the end.
    std::string_view word();
    /// The leading letters of the next word: "Frames" of "Frames:3".
    std::string_view keyword();
    /// The rest of the line, or up to a brace, trimmed of white space and of leading colons.
    std::string_view restOfLine();
    /// Reads a finite number of at most 1e9. Returns false if the next word is not one; the word is consumed.
    bool number(double& value);
    /// Reads a whole number from 0 to 1e9. Returns false if the next word is not one.
    bool count(std::size_t& value);
    /// Skips colons, whether alone or at the start of a word.
    void skipColons();
    /// Line of the last word, from 1.
    std::size_t line() const { return wordLine_; }
    /// Number of bytes not yet read.
    std::size_t left() const { return text_.size() - at_; }
    /// The error `SOURCE:LINE: found FOUND, expected EXPECTED`; FOUND is the last word if `found` is empty.
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

/// True if two words are equal except for case.
bool sameWord(std::string_view a, std::string_view b);
/// The text with ASCII letters in lower case.
std::string lowered(std::string_view text);

}  // namespace muster
