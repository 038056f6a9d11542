// Text and numbers as they stand in the report.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace muster {

/// Text for HTML, XML and SVG: < > & and quotes escaped, control characters left out (but for line breaks and
/// tabs, which become blanks), bytes that are no UTF-8 replaced by U+FFFD.
std::string escaped(std::string_view text);
/// Paragraphs that end with line breaks as <p> elements, escaped; empty ones are left out.
std::string paragraphs(std::string_view text);
/// Text for a cell of a Markdown table, on one line, with what Markdown would read as a sign escaped.
std::string markdownCell(std::string_view text);

/// ASCII letters made small: for names of files and comparisons.
std::string lowerCase(std::string text);
/// Letters (code points) of UTF-8 text.
std::size_t letters(std::string_view text);
/// Lines of at most `most` letters, broken between words; a longer word gets a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t most);

/// "12,345.50": that many decimals, no "-0.00"; "infinite" for infinities, "no value" for NaN.
std::string fixedNumber(double value, int decimals);
/// Four significant digits, no trailing zeros, no whole digit lost: "36", "0.01235", "12,346".
std::string plainNumber(double value);
/// The same with as many digits more as tell it from the threshold, where it is not the threshold.
std::string judgedNumber(double value, double threshold);
/// What is written for a value that a run did not have: "not reached" for times, else "no value".
std::string missingWord(std::string_view unit);
/// A number with its unit: "12 s", "12 %", "12".
std::string withUnit(const std::string& number, std::string_view unit);
/// "1 seed", "3 seeds".
std::string counted(std::size_t number, std::string_view one, std::string_view several);
/// A number as SVG attributes take it, at most two decimals; 0 where it is not finite.
std::string svgNumber(double value);

}  // namespace muster
