#include "lab/reproduce/report/drawings.h"

#include <algorithm>
#include <cmath>

#include "files/report/chart_parts.h"
#include "files/report/markup.h"
#include "lab/reproduce/experiments/samples.h"

namespace muster {
namespace {

constexpr double kRowWidth = 360.0, kLeft = 20.0, kRowRight = 24.0;
constexpr double kTitleHeight = 17.0, kLane = 30.0, kRowGap = 6.0, kAxisHeight = 26.0;
constexpr double kRowLetterWidth = 6.9;
constexpr double kRadius = 3.6;
constexpr double kMarkDistance = 6.4;  // Distance below which two marks stand above each other [px].
constexpr double kMarkRise = 3.7;      // Height of one such rise [px].

double across(const Axis& axis, double value) {
    return kLeft + axis.place(value) * (kRowWidth - kLeft - kRowRight);
}

std::string label(double x, double y, const char* anchor, const std::string& words,
                  const char* kind = "note") {
    return "<text class=\"" + std::string(kind) + "\" x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) +
           "\" text-anchor=\"" + anchor + "\">" + escaped(words) + "</text>\n";
}

std::string upright(double x, double top, double bottom, const char* kind, const char* colour, double width) {
    return "<line class=\"" + std::string(kind) + "\" x1=\"" + svgNumber(x) + "\" y1=\"" + svgNumber(top) +
           "\" x2=\"" + svgNumber(x) + "\" y2=\"" + svgNumber(bottom) + "\" stroke=\"" + colour +
           "\" stroke-width=\"" + svgNumber(width) + "\"/>\n";
}

/// Heights above or below the middle of the row such that marks do not overlap as far as the row has room.
std::vector<double> raised(const std::vector<double>& xs) {
    std::vector<double> heights;
    for (std::size_t i = 0; i < xs.size(); ++i) {
        double height = 0.0;
        for (int lane = 0; lane < 7; ++lane) {
            height = (lane % 2 == 1 ? 1.0 : -1.0) * kMarkRise * ((lane + 1) / 2);
            bool free = true;
            for (std::size_t k = 0; k < i && free; ++k)
                free = std::hypot(xs[k] - xs[i], heights[k] - height) >= kMarkDistance;
            if (free) break;
        }
        heights.push_back(height);
    }
    return heights;
}

std::string notes(const StripRow& row, std::size_t finite) {
    std::string words;
    if (row.missing > 0) words = std::to_string(row.missing) + " without a value";
    if (finite < row.values.size())
        words += (words.empty() ? "" : ", ") + std::to_string(row.values.size() - finite) + " infinite";
    return words;
}

std::string drawRow(const StripRow& row, const Axis& axis, double y) {
    std::vector<double> finite, xs;
    for (const double value : row.values)
        if (std::isfinite(value)) finite.push_back(value);
    std::sort(finite.begin(), finite.end());
    for (const double value : finite) xs.push_back(across(axis, value));
    const std::string note = notes(row, finite.size());
    std::string out = label(0.0, y + 12.0, "start", row.title + (note.empty() ? "" : ": " + note), "label");
    const double middle = y + kTitleHeight + 0.5 * kLane;
    for (const Tick& tick : axis.ticks)
        out += upright(across(axis, tick.value), middle - 15.0, middle + 15.0, "grid", "#DDD8CF", 1.0);
    if (finite.empty()) return out;
    const bool alike = finite.front() == finite.back() && finite.size() > 1;
    std::string marks;
    if (alike) {
        marks = seriesMark(row.series, xs[0], middle, kRadius, row.hollow);
    } else {
        const std::vector<double> heights = raised(xs);
        for (std::size_t i = 0; i < xs.size(); ++i)
            marks += seriesMark(row.series, xs[i], middle + heights[i], kRadius, row.hollow);
    }
    const double at = across(axis, median(finite));
    out += upright(at, middle - 13.0, middle + 13.0, "median", "#171B20", 2.0) +
           seriesGroup(row.series, marks);
    if (alike) {
        const bool before = at > 0.7 * kRowWidth;
        out += label(at + (before ? -9.0 : 9.0), middle + 4.5, before ? "end" : "start",
                     "all " + std::to_string(finite.size()));
    }
    return out;
}

}  // namespace

std::string stripPlot(const StripPlotDef& plot) {
    std::vector<double> all;
    for (const StripRow& row : plot.rows) all.insert(all.end(), row.values.begin(), row.values.end());
    const Axis axis = axisOf(all, false, plot.whole);
    const double bottom = (kTitleHeight + kLane + kRowGap) * static_cast<double>(plot.rows.size());
    std::string body;
    const std::size_t stride = labelStride(axis, kRowWidth - kLeft - kRowRight, kRowLetterWidth);
    for (std::size_t k = 0; k < axis.ticks.size(); k += stride)
        body += label(across(axis, axis.ticks[k].value), bottom + 14.0, "middle", axis.ticks[k].label);
    double y = 0.0;
    for (const StripRow& row : plot.rows) {
        body += drawRow(row, axis, y);
        y += kTitleHeight + kLane + kRowGap;
    }
    const std::string width = svgNumber(kRowWidth), height = svgNumber(bottom + kAxisHeight);
    return "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
           height + "\" viewBox=\"0 0 " + width + " " + height +
           "\" role=\"img\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"12\" "
           "fill=\"#171B20\"><title>" +
           escaped(plot.title) + "</title>\n" + body + "</svg>\n";
}

}  // namespace muster
