#include "files/report/chart_parts.h"

#include "files/report/markup.h"

namespace muster {
namespace {

constexpr const char* kLightSeries[kMarkKinds] = {"#1D5FD1", "#CB4A0E", "#016553",
                                                  "#87598B", "#624A02", "#313C4B"};
constexpr const char* kDarkSeries[kMarkKinds] = {"#74A9FF", "#FF8A4C", "#90FBC9",
                                                 "#AC6BAA", "#FBE24F", "#B7BCC2"};
constexpr std::size_t kCross = 4, kRing = 5;

std::string point(double x, double y) {
    return svgNumber(x) + " " + svgNumber(y);
}

}  // namespace

std::string seriesGroup(std::size_t series, const std::string& content) {
    const std::size_t kind = series % kMarkKinds;
    return "<g class=\"s" + std::to_string(kind) + "\" fill=\"" + kLightSeries[kind] + "\" stroke=\"" +
           kLightSeries[kind] + "\">" + content + "</g>\n";
}

std::string seriesMark(std::size_t series, double x, double y, double r, bool hollow) {
    const std::size_t kind = series % kMarkKinds;
    const bool open = hollow || kind == kRing;
    const std::string paint = std::string(open ? " class=\"hollow\" fill=\"#FFFFFF\"" : " stroke=\"none\"") +
                              (open ? " stroke-width=\"1.6\"" : "") + "/>";
    // Shapes of about the same area.
    const double s = 0.9 * r, d = 1.25 * r;
    if (kind == kCross) {
        return "<path d=\"M" + point(x - r, y - r) + "L" + point(x + r, y + r) + "M" + point(x - r, y + r) +
               "L" + point(x + r, y - r) + "\" fill=\"none\" stroke-width=\"" + (hollow ? "1.2" : "2.4") +
               "\"/>";
    }
    if (kind == 1) {
        return "<path d=\"M" + point(x, y - d) + "L" + point(x + 1.15 * r, y + 0.8 * r) + "L" +
               point(x - 1.15 * r, y + 0.8 * r) + "Z\"" + paint;
    }
    if (kind == 2) {
        return "<rect x=\"" + svgNumber(x - s) + "\" y=\"" + svgNumber(y - s) + "\" width=\"" +
               svgNumber(2.0 * s) + "\" height=\"" + svgNumber(2.0 * s) + "\"" + paint;
    }
    if (kind == 3) {
        return "<path d=\"M" + point(x, y - d) + "L" + point(x + d, y) + "L" + point(x, y + d) + "L" +
               point(x - d, y) + "Z\"" + paint;
    }
    return "<circle cx=\"" + svgNumber(x) + "\" cy=\"" + svgNumber(y) + "\" r=\"" + svgNumber(r) + "\"" +
           paint;
}

std::string seriesVariables(bool dark) {
    std::string css;
    for (std::size_t k = 0; k < kMarkKinds; ++k)
        css += "--s" + std::to_string(k) + ":" + (dark ? kDarkSeries : kLightSeries)[k] + ";";
    return css;
}

std::string seriesRules() {
    std::string css;
    for (std::size_t k = 0; k < kMarkKinds; ++k) {
        const std::string variable = "var(--s" + std::to_string(k) + ")";
        css += ".s" + std::to_string(k) + "{fill:" + variable + ";stroke:" + variable + "}";
    }
    return css + "\n";
}

}  // namespace muster
