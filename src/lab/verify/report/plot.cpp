// Plots: a band of expected values, and series over it.
#include <algorithm>

#include "files/report/chart_parts.h"
#include "files/report/markup.h"
#include "lab/verify/report/words.h"

namespace muster {
namespace {

// Sizes in pixels of the drawing.
constexpr double kPlotWide = 460.0, kPlotHigh = 240.0, kAbove = 30.0, kBeside = 18.0, kBelowAxis = 48.0;
constexpr double kGlyph = 6.9, kLegendRow = 20.0;
constexpr std::size_t kMostDots = 1200;  // Greatest number of dots of a series.

/// Positions of values in a plot.
struct PlotFrame {
    Axis x, y;
    double left = 0.0;

    explicit PlotFrame(const VerifyPlot& plot) {
        std::vector<double> xs, ys;
        const auto add = [&](const std::vector<Vec2>& points) {
            for (const Vec2 p : points)
                if (isFinite(p)) xs.push_back(p.x), ys.push_back(p.y);
        };
        for (const PlotSeries& series : plot.series) add(series.points);
        add(plot.bandLow);
        add(plot.bandHigh);
        x = axisOf(xs, false);
        y = axisOf(ys, false);
        std::size_t longest = 1;
        for (const Tick& tick : y.ticks) longest = std::max(longest, letters(tick.label));
        left = 14.0 + kGlyph * static_cast<double>(longest);
    }
    double px(double value) const { return left + x.place(value) * (kPlotWide - kBeside - left); }
    double py(double value) const { return kAbove + (1.0 - y.place(value)) * kPlotHigh; }
    std::string at(Vec2 p) const { return svgNumber(px(p.x)) + " " + svgNumber(py(p.y)); }
};

std::string words(double x, double y, const char* anchor, const std::string& text) {
    return "<text x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\" text-anchor=\"" + anchor + "\">" +
           escaped(text) + "</text>\n";
}

std::string stroke(double x1, double y1, double x2, double y2, const char* kind) {
    return std::string("<line class=\"") + kind + "\" x1=\"" + svgNumber(x1) + "\" y1=\"" + svgNumber(y1) +
           "\" x2=\"" + svgNumber(x2) + "\" y2=\"" + svgNumber(y2) + "\" stroke=\"#A8A296\"/>\n";
}

std::string axes(const PlotFrame& frame, const VerifyPlot& plot) {
    const double bottom = kAbove + kPlotHigh, right = kPlotWide - kBeside;
    std::string out;
    for (const Tick& tick : frame.y.ticks) {
        const double y = frame.py(tick.value);
        out += stroke(frame.left, y, right, y, "grid") + words(frame.left - 7.0, y + 4.0, "end", tick.label);
    }
    const std::size_t stride = labelStride(frame.x, right - frame.left, kGlyph);
    for (std::size_t k = 0; k < frame.x.ticks.size(); ++k) {
        const double x = frame.px(frame.x.ticks[k].value);
        out += stroke(x, bottom, x, bottom + 5.0, "axis");
        if (k % stride == 0) out += words(x, bottom + 19.0, "middle", frame.x.ticks[k].label);
    }
    out += stroke(frame.left, bottom, right, bottom, "axis");
    return out + words(right, bottom + 38.0, "end", plot.xTitle) + words(4.0, 15.0, "start", plot.yTitle);
}

std::string band(const PlotFrame& frame, const VerifyPlot& plot) {
    if (plot.bandLow.empty()) return {};
    std::string data = "M";
    for (const Vec2 p : plot.bandLow) data += frame.at(p) + " L";
    for (std::size_t k = plot.bandHigh.size(); k-- > 0;)
        data += frame.at(plot.bandHigh[k]) + (k > 0 ? " L" : "Z");
    return "<path d=\"" + data + "\" fill=\"#016553\" fill-opacity=\"0.16\"/>\n";
}

std::string lineOf(const PlotFrame& frame, const std::vector<Vec2>& points) {
    std::string data;
    bool pen = false;
    for (const Vec2 p : points) {
        if (isFinite(p)) data += (pen ? "L" : "M") + frame.at(p);
        pen = isFinite(p);
    }
    return data.empty() ? data : "<path d=\"" + data + "\" fill=\"none\" stroke-width=\"2\"/>";
}

std::string seriesOf(const PlotFrame& frame, const PlotSeries& series, std::size_t index) {
    std::string content;
    if (series.look == PlotSeries::Look::Line) {
        content = lineOf(frame, series.points);
    } else {
        const bool dots = series.look == PlotSeries::Look::Dots;
        const std::size_t stride = dots ? 1 + series.points.size() / kMostDots : 1;
        for (std::size_t k = 0; k < series.points.size(); k += stride) {
            const Vec2 p = series.points[k];
            if (!isFinite(p)) continue;
            content += dots ? "<circle cx=\"" + svgNumber(frame.px(p.x)) + "\" cy=\"" +
                                  svgNumber(frame.py(p.y)) +
                                  "\" r=\"1.4\" stroke=\"none\" fill-opacity=\"0.5\"/>"
                            : seriesMark(index, frame.px(p.x), frame.py(p.y), 4.5);
        }
    }
    return seriesGroup(index, content);
}

std::string legend(const VerifyPlot& plot, double& y) {
    std::string out;
    for (std::size_t i = 0; i < plot.series.size(); ++i, y += kLegendRow) {
        const bool line = plot.series[i].look == PlotSeries::Look::Line;
        out += seriesGroup(
                   i, line ? "<path d=\"M4 " + svgNumber(y - 4.5) + "h24\" fill=\"none\" stroke-width=\"2\"/>"
                           : seriesMark(i, 16.0, y - 4.5,
                                        plot.series[i].look == PlotSeries::Look::Dots ? 2.0 : 4.5)) +
               words(34.0, y, "start", plot.series[i].title);
    }
    if (!plot.bandTitle.empty()) {
        out += "<rect x=\"4\" y=\"" + svgNumber(y - 10.0) +
               "\" width=\"24\" height=\"11\" fill=\"#016553\" fill-opacity=\"0.16\"/>" +
               words(34.0, y, "start", plot.bandTitle);
        y += kLegendRow;
    }
    return out;
}

}  // namespace

std::string plotSvg(const VerifyPlot& plot) {
    const PlotFrame frame(plot);
    std::string body = axes(frame, plot) + band(frame, plot);
    for (std::size_t i = 0; i < plot.series.size(); ++i) body += seriesOf(frame, plot.series[i], i);
    double bottom = kAbove + kPlotHigh + kBelowAxis + 14.0;
    body += legend(plot, bottom);
    const std::string size = svgNumber(kPlotWide) + " " + svgNumber(bottom);
    return "<svg class=\"chart\" xmlns=\"http://www.w3.org/2000/svg\" width=\"" + svgNumber(kPlotWide) +
           "\" height=\"" + svgNumber(bottom) + "\" viewBox=\"0 0 " + size +
           "\" role=\"img\" font-family=\"Inter, Helvetica, Arial, sans-serif\" font-size=\"13\" "
           "fill=\"#171B20\"><title>" +
           escaped(plot.title) + "</title>\n" + body + "</svg>\n";
}

}  // namespace muster
