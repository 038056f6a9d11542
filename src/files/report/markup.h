// Text and numbers as the report writes them, its style sheet, and pictures as elements.
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace muster {

/// Text for HTML, XML and SVG: < > & and quotes escaped, control characters left out (but for line breaks and
/// tabs, which become blanks), bytes that are not UTF-8 replaced by U+FFFD.
std::string escaped(std::string_view text);
/// Splits text at line breaks into escaped <p> elements; empty paragraphs are left out.
std::string paragraphs(std::string_view text);
/// Text for a cell of a Markdown table, on one line, with Markdown syntax escaped.
std::string markdownCell(std::string_view text);

/// Converts ASCII letters to lower case, for file names and comparisons.
std::string lowerCase(std::string text);
/// Number of code points of UTF-8 text.
std::size_t letters(std::string_view text);
/// Lines of at most `most` letters, broken between words; a longer word gets a line of its own.
std::vector<std::string> wrapped(std::string_view text, std::size_t most);

/// "12,345.50": that many decimals, no "-0.00"; "infinite" for infinities, "no value" for NaN.
std::string fixedNumber(double value, int decimals);
/// Four significant digits, no trailing zeros, no whole digit lost: "36", "0.01235", "12,346".
std::string plainNumber(double value);
/// The same with as many more digits as are needed to distinguish it from the threshold.
std::string judgedNumber(double value, double threshold);
/// The text for a value that a run did not have: "not reached" for times, else "no value".
std::string missingWord(std::string_view unit);
/// A number with its unit: "12 s", "12 %", "12".
std::string withUnit(const std::string& number, std::string_view unit);
/// "1 seed", "3 seeds".
std::string counted(std::size_t number, std::string_view one, std::string_view several);
/// A number for an SVG attribute, with at most two decimals; 0 if it is not finite.
std::string svgNumber(double value);

/// The studio's colours and letters, for screens, phones, dark surroundings and A4.
std::string pageStyle();

/// Size of a picture by its root element [px]; 0 without a picture.
struct PictureSize {
    double width = 0.0;
    double height = 0.0;
};

/// Reads width and height, or else those of the viewBox.
PictureSize pictureSize(const std::string& svg);

/// The picture as an <svg> element with `attributes` (` x="3"`...) in place of its own position and size. Ids
/// and references to them get the prefix, so that pictures in one document have different ids. Empty
/// for no picture.
std::string nestedPicture(const std::string& svg, const std::string& attributes, const std::string& prefix);

}  // namespace muster
