// Box plots and plans.
#include <algorithm>

#include "files/report/chart_parts.h"
#include "files/report/markup.h"
#include "lab/study/report/study_parts.h"

namespace muster {
namespace {

constexpr double kWidth = 460.0, kLeft = 150.0, kRight = 16.0, kRow = 30.0, kTop = 8.0;

std::string line(double x1, double y1, double x2, double y2, const char* extra) {
    return "<line x1=\"" + svgNumber(x1) + "\" y1=\"" + svgNumber(y1) + "\" x2=\"" + svgNumber(x2) +
           "\" y2=\"" + svgNumber(y2) + "\" " + extra + "/>\n";
}

std::string text(double x, double y, const char* anchor, const std::string& words) {
    return "<text x=\"" + svgNumber(x) + "\" y=\"" + svgNumber(y) + "\" text-anchor=\"" + anchor +
           "\" font-size=\"12\">" + escaped(words) + "</text>\n";
}

std::string box(const BoxRow& row, double y, const Axis& axis) {
    const auto px = [&](double value) { return kLeft + axis.place(value) * (kWidth - kRight - kLeft); };
    const statistics::BoxSummary b = statistics::boxSummary(row.values);
    const char* stroke = "stroke=\"currentColor\" stroke-width=\"1.5\"";
    std::string shape = line(px(b.low), y, px(b.lower), y, stroke) +
                        line(px(b.upper), y, px(b.high), y, stroke);
    shape += "<rect x=\"" + svgNumber(px(b.lower)) + "\" y=\"" + svgNumber(y - 8.0) + "\" width=\"" +
             svgNumber(std::max(1.0, px(b.upper) - px(b.lower))) +
             "\" height=\"16\" fill-opacity=\"0.45\" stroke=\"currentColor\"/>\n";
    for (const double value : b.beyond) shape += seriesMark(row.series, px(value), y, 2.5, true);
    return seriesGroup(row.series, shape) + line(px(b.middle), y - 9.0, px(b.middle), y + 9.0,
                                                 "class=\"median\" stroke=\"#171B20\" stroke-width=\"2.5\"");
}

std::string rectangle(const Box& box, const Box& ground, double scale, const char* extra) {
    return "<rect x=\"" + svgNumber((box.min.x - ground.min.x) * scale) + "\" y=\"" +
           svgNumber((ground.max.y - box.max.y) * scale) + "\" width=\"" +
           svgNumber((box.max.x - box.min.x) * scale) + "\" height=\"" +
           svgNumber((box.max.y - box.min.y) * scale) + "\" " + extra + "/>\n";
}

}  // namespace

std::string boxPlot(const std::string& title, const std::string& unit, const std::vector<BoxRow>& rows) {
    std::vector<double> all{0.0};
    for (const BoxRow& row : rows) all.insert(all.end(), row.values.begin(), row.values.end());
    const Axis axis = axisOf(all, false);
    const double bottom = kTop + kRow * static_cast<double>(rows.size());
    std::string svg = "<svg class=\"chart\" viewBox=\"0 0 460 " + svgNumber(bottom + 38.0) +
                      "\" role=\"img\"><title>" + escaped(title) + "</title>\n";
    for (const Tick& tick : axis.ticks) {
        const double x = kLeft + axis.place(tick.value) * (kWidth - kRight - kLeft);
        svg += line(x, kTop, x, bottom, "class=\"grid\" stroke=\"#DDD8CF\"") +
               text(x, bottom + 15.0, "middle", tick.label);
    }
    svg += text(0.5 * (kLeft + kWidth - kRight), bottom + 33.0, "middle", unit);
    for (std::size_t i = 0; i < rows.size(); ++i) {
        const double y = kTop + kRow * (static_cast<double>(i) + 0.5);
        svg += text(kLeft - 8.0, y + 4.0, "end", rows[i].title) + box(rows[i], y, axis);
    }
    return svg + "</svg>\n";
}

std::string planDrawing(const StudyEnvironment& environment) {
    const StudyRules& rules = studyRules();
    const double scale = 10.0;
    const double width = (rules.box.max.x - rules.box.min.x) * scale,
                 height = (rules.box.max.y - rules.box.min.y) * scale;
    std::string svg = "<svg class=\"chart\" viewBox=\"-1 -1 " + svgNumber(width + 2.0) + " " +
                      svgNumber(height + 2.0) + "\" role=\"img\"><title>Plan of " +
                      escaped(environment.title) + "</title>\n" +
                      rectangle(rules.box, rules.box, scale,
                                "fill=\"none\" class=\"axis\" stroke=\"#545C66\"");
    for (const Box& block : environment.blocks) svg += rectangle(block, rules.box, scale, "fill=\"#8B857C\"");
    const auto world = studyWorld(environment, studyCrowds().front(), 1, false);
    if (world.ok()) {
        for (const ItemDef& item : world->items)
            svg += "<circle cx=\"" + svgNumber((item.position.x - rules.box.min.x) * scale) + "\" cy=\"" +
                   svgNumber((rules.box.max.y - item.position.y) * scale) + "\" r=\"4\" fill=\"#D9730D\"/>\n";
    }
    const double half = 2.5 + 0.3;
    svg += rectangle({{environment.start.x - half, environment.start.y - half},
                      {environment.start.x + half, environment.start.y + half}},
                     rules.box, scale, "fill=\"#1D5FD1\" fill-opacity=\"0.5\" stroke=\"#1D5FD1\"");
    return svg + "</svg>\n";
}

}  // namespace muster
