// The groups' colours and marks, so that series differ by both.
#pragma once

#include <cstddef>
#include <string>

namespace muster {

/// Disc, triangle, square, diamond, cross, ring; then from the first.
inline constexpr std::size_t kMarkKinds = 6;

/// A group element in the colour of a series: `class` for a page that has colours of its own, light colours
/// else.
std::string seriesGroup(std::size_t series, const std::string& content);
/// The mark of a series; to stand in its group. Hollow ones are filled with the paper's colour.
std::string seriesMark(std::size_t series, double x, double y, double radius, bool hollow = false);
/// The colours of the page in light or dark: one CSS variable per series, --s0 to --s5.
std::string seriesVariables(bool dark);
/// CSS that puts the variables to use.
std::string seriesRules();

}  // namespace muster
