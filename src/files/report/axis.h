// Axes of charts.
#pragma once

#include <string>
#include <vector>

namespace muster {

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
