#include "lab/reproduce/report/drawings.h"

#include <algorithm>
#include <cmath>

#include "files/report/chart_parts.h"
#include "files/report/markup.h"

namespace muster {
namespace {

// Sizes in pixels of the drawing, which a phone shows a little smaller.
constexpr double kWidth = 460.0, kPlotHeight = 240.0, kTop = 30.0, kRight = 18.0, kBelowPlot = 48.0;
constexpr double kLetterWidth = 6.9, kLegendLine = 22.0, kLegendMark = 30.0;
constexpr std::size_t kFewPoints = 16, kMarksPerLine = 8;
// Series beyond the sixth have the colours and marks of the first ones, in dashes.
constexpr const char* kDashes[] = {"", " stroke-dasharray=\"7 4\"", " stroke-dasharray=\"2 4\""};

struct Frame {
    Axis x, y;
    double left = 0.0;

    double px(double value) const { return left + x.place(value) * (kWidth - kRight - left); }
    double py(double value) const { return kTop + (1.0 - y.place(value)) * kPlotHeight; }
    bool shows(Vec2 p) const {
        return std::isfinite(p.x) && std::isfinite(p.y) && (!x.logarithmic || p.x > 0.0) &&
               (!y.logarithmic || p.y > 0.0);
    }
};

Frame frameOf(const ChartDef& chart) {
    std::vector<double> xs, ys;
    for (const ChartSeries& series : chart.series) {
        for (const Vec2 p : series.points) {
            if (!std::isfinite(p.x) || !std::isfinite(p.y)) continue;
            xs.push_back(p.x);
            ys.push_back(p.y);
        }
    }
    Frame frame{axisOf(xs, chart.logX), axisOf(ys, chart.logY), 0.0};
    std::size_t longest = 1;
    for (const Tick& tick : frame.y.ticks) longest = std::max(longest, letters(tick.label));
    frame.left = 14.0 + kLetterWidth * static_cast<double>(longest);
    return frame;
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
    return "<text x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\" text-anchor=\"" + anchor + "\">" +
           escaped(words) + "</text>\n";
}

std::string rule(double x1, double y1, double x2, double y2, const char* kind, const char* colour) {
    return std::string("<line class=\"") + kind + "\" x1=\"" + svgNumber(x1) + "\" y1=\"" + svgNumber(y1) +
           "\" x2=\"" + svgNumber(x2) + "\" y2=\"" + svgNumber(y2) + "\" stroke=\"" + colour + "\"/>\n";
}

std::string drawAxes(const Frame& frame, const ChartDef& chart) {
    const double bottom = kTop + kPlotHeight, right = kWidth - kRight;
    std::string out;
    for (const Tick& tick : frame.y.ticks) {
        const double y = frame.py(tick.value);
        out += rule(frame.left, y, right, y, "grid", "#DDD8CF") +
               text(frame.left - 7.0, y + 4.0, "end", tick.label);
    }
    const std::size_t stride = labelStride(frame.x, right - frame.left, kLetterWidth);
    for (std::size_t k = 0; k < frame.x.ticks.size(); ++k) {
        const double x = frame.px(frame.x.ticks[k].value);
        out += rule(x, bottom, x, bottom + 5.0, "axis", "#545C66");
        if (k % stride == 0) out += text(x, bottom + 19.0, "middle", frame.x.ticks[k].label);
    }
    out += rule(frame.left, bottom, right, bottom, "axis", "#545C66");
    const std::string logX = chart.logX ? " (log)" : "", logY = chart.logY ? " (log)" : "";
    out += text(right, bottom + 38.0, "end", chart.xTitle + logX) +
           text(4.0, 15.0, "start", chart.yTitle + logY);
    return out;
}

std::string linePath(const Frame& frame, const ChartSeries& series) {
    std::string data;
    bool pen = false;
    for (const Vec2 p : series.points) {
        if (frame.shows(p))
            data += (pen ? "L" : "M") + svgNumber(frame.px(p.x)) + " " + svgNumber(frame.py(p.y));
        pen = frame.shows(p);
    }
    return data;
}

std::string dashOf(std::size_t index) {
    return kDashes[std::min<std::size_t>(index / kMarkKinds, 2)];
}

std::string drawSeries(const Frame& frame, const ChartSeries& series, std::size_t index) {
    std::string content;
    const std::string path = series.marksOnly ? std::string() : linePath(frame, series);
    if (!path.empty())
        content += "<path d=\"" + path + "\" fill=\"none\" stroke-width=\"2\" stroke-linejoin=\"round\"" +
                   dashOf(index) + "/>";
    // Lines of many points carry a few marks, each series at other points, so that marks do not hide each
    // other.
    const std::size_t count = series.points.size();
    const std::size_t stride = series.marksOnly || count <= kFewPoints
                                   ? 1
                                   : (count + kMarksPerLine - 1) / kMarksPerLine;
    const std::size_t first = stride > 1 ? (index * stride / 4) % stride : 0;
    for (std::size_t i = first; i < count; i += stride) {
        const Vec2 p = series.points[i];
        if (frame.shows(p)) content += seriesMark(index, frame.px(p.x), frame.py(p.y), 4.0);
    }
    return seriesGroup(index, content);
}

std::string legendSign(const ChartSeries& series, std::size_t index, double x, double y) {
    std::string content;
    if (!series.marksOnly)
        content = "<path d=\"M" + svgNumber(x) + " " + svgNumber(y) +
                  "h24\" fill=\"none\" stroke-width=\"2\"" + dashOf(index) + "/>";
    return seriesGroup(index, content + seriesMark(index, x + 12.0, y, 4.0));
}

/// Draws the legend in rows from y on; y becomes the last baseline. A long title takes several lines.
std::string drawLegend(const ChartDef& chart, double& y) {
    std::string out;
    double x = 4.0;
    y += 0.5 * kLegendLine;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        const std::vector<std::string> lines = wrapped(chart.series[i].title, 58);
        std::size_t longest = 0;
        for (const std::string& line : lines) longest = std::max(longest, letters(line));
        const double width = kLegendMark + kLetterWidth * static_cast<double>(longest) + 16.0;
        if (x > 4.0 && (x + width > kWidth || lines.size() > 1)) {
            x = 4.0;
            y += kLegendLine;
        }
        out += legendSign(chart.series[i], i, x, y - 4.5);
        for (std::size_t k = 0; k < lines.size(); ++k)
            out += text(x + kLegendMark, k == 0 ? y : y += 17.0, "start", lines[k]);
        x += lines.size() > 1 ? kWidth : width;
    }
    return out;
}

}  // namespace

std::string chartSvg(const ChartDef& chart) {
    const Frame frame = frameOf(chart);
    std::string body = drawAxes(frame, chart);
    bool anything = false;
    for (std::size_t i = 0; i < chart.series.size(); ++i) {
        body += drawSeries(frame, chart.series[i], i);
        for (const Vec2 p : chart.series[i].points) anything = anything || frame.shows(p);
    }
    if (!anything) body += text(0.5 * kWidth, kTop + 0.5 * kPlotHeight, "middle", "no values");
    double bottom = kTop + kPlotHeight + kBelowPlot;
    if (chart.series.size() > 1) body += drawLegend(chart, bottom);
    const std::string width = svgNumber(kWidth), height = svgNumber(bottom + 6.0);
    return "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" width=\"" + width + "\" height=\"" +
           height + "\" viewBox=\"0 0 " + width + " " + height +
           "\" role=\"img\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"13\" "
           "fill=\"#171B20\"><title>" +
           escaped(chart.title) + "</title>\n" + body + "</svg>\n";
}

}  // namespace muster
