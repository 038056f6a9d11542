// Parts of charts: axes with units, and the colours and marks of series, which differ by both.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

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

/// A tick of an axis.
struct Tick {
    double value = 0.0;
    std::string label;
};

/// A range that begins and ends with ticks at round values.
struct Axis {
    double low = 0.0;
    double high = 1.0;
    bool logarithmic = false;
    std::vector<Tick> ticks;  ///< Rising.

    /// 0 at the low end, 1 at the high end.
    double place(double value) const;
};

/// Stride of labelled ticks such that labels with letters `letterWidth` wide fit side by side on an
/// axis of that length, both in the same unit.
std::size_t labelStride(const Axis& axis, double length, double letterWidth);

/// The axis that shows low to high. A linear one begins with 0 where that costs at most half of it; `whole`
/// asks for ticks at whole numbers. A logarithmic one needs low > 0, else it becomes linear.
Axis makeAxis(double low, double high, bool logarithmic, bool whole = false);

/// The same for the values that can be shown: finite, and > 0 on a logarithmic axis. 0 to 1 (1 to 10) for
/// none.
Axis axisOf(const std::vector<double>& values, bool logarithmic, bool whole = false);

}  // namespace muster
