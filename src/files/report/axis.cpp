#include "files/report/chart_parts.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>

#include "files/report/markup.h"

namespace muster {
namespace {

constexpr double kLargest = 1e100;  // Beyond it differences would overflow.
constexpr double kAlike = 1e-9;     // Values closer than this share of them count as one.
constexpr double kWantedSteps = 4.0;
constexpr double kLogSmallest = 1e-100;

std::string label(double value, double step) {
    const double size = std::max(std::abs(value), step);
    if (value != 0.0 && (size >= 1e7 || step < 1e-6)) {
        // As many digits as distinguish neighbouring ticks.
        const int digits = static_cast<int>(std::floor(std::log10(size) + 1e-9) -
                                            std::floor(std::log10(step) + 1e-9)) +
                           1;
        char buffer[32];
        std::snprintf(buffer, sizeof(buffer), "%.*g", std::clamp(digits, 1, 12), value);
        return buffer;
    }
    const int decimals = std::max(0, static_cast<int>(-std::floor(std::log10(step) + 1e-9)));
    return fixedNumber(value, value == 0.0 ? 0 : decimals);
}

/// The step between ticks, 1, 2 or 5 times a power of ten, such that about that many steps cover the range.
double stepFor(double range, bool whole) {
    const double raw = range / kWantedSteps;
    const double power = std::pow(10.0, std::floor(std::log10(raw)));
    const double share = raw / power;
    const double step = (share < 1.5 ? 1.0 : share < 3.5 ? 2.0 : share < 7.5 ? 5.0 : 10.0) * power;
    return whole ? std::max(1.0, step) : step;
}

Axis linearAxis(double low, double high, bool whole) {
    if (high - low <= kAlike * std::max(std::abs(low), std::abs(high))) {
        if (low == 0.0)
            high = 1.0;
        else
            (low > 0.0 ? low : high) = 0.0;
    }
    if (low > 0.0 && low <= 0.5 * high) low = 0.0;
    if (high < 0.0 && high >= 0.5 * low) high = 0.0;
    const double step = stepFor(high - low, whole);
    const double first = std::floor(low / step + 1e-6), last = std::ceil(high / step - 1e-6);
    Axis axis{first * step, last * step, false, {}};
    for (double k = first; k <= last + 0.5; k += 1.0) axis.ticks.push_back({k * step, label(k * step, step)});
    return axis;
}

/// The sequence of 1, 2 and 5 times powers of ten, by index.
double logStop(int index) {
    const int decade = index >= 0 ? index / 3 : -((2 - index) / 3);
    const double digits[] = {1.0, 2.0, 5.0};
    return digits[index - 3 * decade] * std::pow(10.0, decade);
}

Axis logAxis(double low, double high) {
    int first = 3 * static_cast<int>(std::floor(std::log10(low)));
    while (logStop(first + 1) <= low * (1.0 + kAlike)) ++first;
    int last = first + 1;
    while (logStop(last) < high * (1.0 - kAlike)) ++last;
    // Only decades if there is no room for all ticks.
    const bool decadesOnly = last - first > 6;
    if (decadesOnly) {
        while (first % 3 != 0) --first;
        while (last % 3 != 0) ++last;
    }
    const int stride = decadesOnly ? 3 * std::max(1, (last - first) / 3 / 6) : 1;
    Axis axis{logStop(first), logStop(last), true, {}};
    for (int k = first; k <= last; k += stride)
        axis.ticks.push_back({logStop(k), label(logStop(k), logStop(k))});
    return axis;
}

}  // namespace

double Axis::place(double value) const {
    if (!logarithmic) return (value - low) / (high - low);
    return std::log(value / low) / std::log(high / low);
}

std::size_t labelStride(const Axis& axis, double length, double letterWidth) {
    std::size_t longest = 1;
    for (const Tick& tick : axis.ticks) longest = std::max(longest, letters(tick.label));
    const double needed = letterWidth * (static_cast<double>(longest) + 1.5);
    const double room = length / std::max<double>(1.0, static_cast<double>(axis.ticks.size()) - 1.0);
    return static_cast<std::size_t>(std::max(1.0, std::ceil(needed / room - 1e-9)));
}

Axis makeAxis(double low, double high, bool logarithmic, bool whole) {
    low = std::clamp(low, -kLargest, kLargest);
    high = std::clamp(high, low, kLargest);
    if (logarithmic && low > 0.0) return logAxis(std::max(low, kLogSmallest), std::max(high, kLogSmallest));
    return linearAxis(low, high, whole);
}

Axis axisOf(const std::vector<double>& values, bool logarithmic, bool whole) {
    std::vector<double> shown;
    for (const double value : values)
        if (std::isfinite(value) && (!logarithmic || value > 0.0)) shown.push_back(value);
    if (shown.empty()) return logarithmic ? makeAxis(1.0, 10.0, true) : makeAxis(0.0, 1.0, false, whole);
    const auto [low, high] = std::minmax_element(shown.begin(), shown.end());
    return makeAxis(*low, *high, logarithmic, whole);
}

}  // namespace muster
