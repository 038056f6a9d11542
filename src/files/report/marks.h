// Colours and marks of series: two series differ by both.
#pragma once

#include <cstddef>
#include <string>

namespace muster {

/// Disc, triangle, square, diamond, cross, ring; further series start again with the first.
inline constexpr std::size_t kMarkKinds = 6;

/// A group element in the colour of a series: `class` for a page with its own colours, else light
/// colours.
std::string seriesGroup(std::size_t series, const std::string& content);
/// The mark of a series, to be placed in its group. Hollow marks are filled with the background colour.
std::string seriesMark(std::size_t series, double x, double y, double radius, bool hollow = false);
/// The colours of the page in light or dark: one CSS variable per series, --s0 to --s5.
std::string seriesVariables(bool dark);
/// CSS that uses the variables.
std::string seriesRules();

}  // namespace muster
