// Axes, charts and strip plots.
#include "lab/reproduce/report/drawings.h"

#include <doctest.h>

#include <rapidcheck.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <set>

#include "files/report/chart_parts.h"
#include "lab/picture/xml.h"
#include "lab/reproduce/fake.h"

using namespace muster;
using namespace muster::testing;

namespace {

std::vector<std::string> labels(const Axis& axis) {
    std::vector<std::string> list;
    for (const Tick& tick : axis.ticks) list.push_back(tick.label);
    return list;
}

/// The axis holds the range between its first and last tick, which rise and are labelled apart.
bool sound(const Axis& axis, double low, double high) {
    const double slack = 1e-6 * (axis.high - axis.low);
    bool good = axis.low <= low + slack && axis.high >= high - slack && axis.high > axis.low;
    good = good && axis.ticks.size() >= 2 && axis.ticks.size() <= 16 && axis.ticks.front().value == axis.low;
    std::set<std::string> seen;
    for (std::size_t k = 0; k < axis.ticks.size(); ++k) {
        good = good && seen.insert(axis.ticks[k].label).second &&
               (k == 0 || axis.ticks[k].value > axis.ticks[k - 1].value);
        const double place = axis.place(axis.ticks[k].value);
        good = good && place > -1e-6 && place < 1.0 + 1e-6;
    }
    return good;
}

std::vector<Element> withClass(const XmlReader& xml, const std::string& name, const std::string& kind) {
    std::vector<Element> found;
    for (const Element& element : xml.all(name))
        if (element.attribute("class") == kind) found.push_back(element);
    return found;
}

}  // namespace

TEST_CASE("linear ticks stand at round values") {
    CHECK(labels(makeAxis(0.0, 10.0, false)) == std::vector<std::string>{"0", "2", "4", "6", "8", "10"});
    CHECK(labels(makeAxis(3.0, 37.0, false)) == std::vector<std::string>{"0", "10", "20", "30", "40"});
    CHECK(labels(makeAxis(0.91, 1.02, false)) ==
          std::vector<std::string>{"0.90", "0.92", "0.94", "0.96", "0.98", "1.00", "1.02"});
    CHECK(labels(makeAxis(-1.0, 1.0, false)) == std::vector<std::string>{"-1.0", "-0.5", "0", "0.5", "1.0"});
    CHECK(labels(makeAxis(20000.0, 21000.0, false)).front() == "20,000");
    CHECK(labels(makeAxis(0.0, 2.0, false, true)) == std::vector<std::string>{"0", "1", "2"});
    CHECK(labels(makeAxis(36.0, 36.0, false)) == std::vector<std::string>{"0", "10", "20", "30", "40"});
    CHECK(labels(makeAxis(0.0, 0.0, false)).back() == "1.0");
}

TEST_CASE("logarithmic ticks stand at 1, 2, 5 or at decades") {
    CHECK(labels(makeAxis(3.0, 40.0, true)) == std::vector<std::string>{"2", "5", "10", "20", "50"});
    CHECK(labels(makeAxis(10.0, 10000.0, true)) == std::vector<std::string>{"10", "100", "1000", "10,000"});
    CHECK(labels(makeAxis(0.004, 0.02, true)) == std::vector<std::string>{"0.002", "0.005", "0.01", "0.02"});
    CHECK(labels(makeAxis(7.0, 7.0, true)) == std::vector<std::string>{"5", "10"});
    const Axis axis = makeAxis(1.0, 100.0, true);
    CHECK(axis.place(10.0) == doctest::Approx(0.5));
    CHECK_FALSE(makeAxis(0.0, 10.0, true).logarithmic);
}

TEST_CASE("any range gets an axis that holds it") {
    const auto number = [] {
        const double digits = (*rc::gen::inRange(-100000, 100000)) / 1000.0;
        return digits * std::pow(10.0, *rc::gen::inRange(-6, 7));
    };
    CHECK(rc::check("linear", [&] {
        const double a = number(), b = number();
        RC_ASSERT(sound(makeAxis(std::min(a, b), std::max(a, b), false), std::min(a, b), std::max(a, b)));
    }));
    CHECK(rc::check("logarithmic", [&] {
        const double a = std::abs(number()) + 1e-9, b = std::abs(number()) + 1e-9;
        RC_ASSERT(sound(makeAxis(std::min(a, b), std::max(a, b), true), std::min(a, b), std::max(a, b)));
    }));
}

TEST_CASE("values that cannot be shown do not stretch the axis") {
    const double endless = std::numeric_limits<double>::infinity();
    CHECK(axisOf({1.0, kNone, endless, 9.0}, false).high == 10.0);
    CHECK(axisOf({-5.0, 0.0, 1.0, 9.0}, true).low == 1.0);
    CHECK(axisOf({}, false).ticks.size() >= 2);
    CHECK(axisOf({kNone}, true).ticks.size() >= 2);
    CHECK(sound(axisOf({-1e308, 1e308}, false), 0.0, 1.0));
}

TEST_CASE("labels are left out where they would touch") {
    const Axis axis = makeAxis(0.0, 140000.0, false);
    CHECK(labelStride(axis, 1000.0, 7.0) == 1);
    CHECK(labelStride(axis, 100.0, 7.0) == 2);
}

TEST_CASE("a chart shows its lines, marks, units and legend, and lets no gap be bridged") {
    const ChartDef chart{"Time <by> size",
                         "characters",
                         "step [ms]",
                         false,
                         false,
                         {{"first & best", {{0.0, 1.0}, {1.0, 2.0}, {2.0, kNone}, {3.0, 4.0}}, false},
                          {"dots", {{1.0, 1.0}, {2.0, 3.0}}, true}}};
    const std::string svg = chartSvg(chart);
    const XmlReader xml(svg);
    REQUIRE(xml.error.empty());
    CHECK(xml.all("title").front().text == "Time <by> size");
    std::set<std::string> words;
    for (const Element& text : xml.all("text")) words.insert(text.text);
    for (const char* wanted : {"characters", "step [ms]", "first & best", "dots"})
        CHECK(words.count(wanted) == 1);
    // One path with two beginnings; in the legend another one. Points alone have none.
    std::size_t lines = 0;
    for (const Element& path : xml.all("path")) {
        const std::string data = path.attribute("d");
        if (path.attribute("fill") != "none" || data.find('h') != std::string::npos) continue;
        ++lines;
        CHECK(std::count(data.begin(), data.end(), 'M') == 2);
    }
    CHECK(lines == 1);
    CHECK(xml.all("circle").size() == 3 + 1);  // Disc: the first series and its legend.
    CHECK(withClass(xml, "g", "s0").size() == 2);
    CHECK(withClass(xml, "g", "s1").size() == 2);
}

TEST_CASE("all of a chart lies inside it") {
    ChartDef chart{"t", "x", "y", true, true, {{"a", {}, true}}};
    for (double v = 0.01; v < 2e5; v *= 3.0) chart.series[0].points.push_back({v, 1.0 / v});
    const std::string svg = chartSvg(chart);
    const XmlReader xml(svg);
    REQUIRE(xml.error.empty());
    const Element root = xml.elements.front();
    CHECK(xml.all("circle").size() == chart.series[0].points.size());
    for (const Element& mark : xml.all("circle")) {
        CHECK(mark.number("cx") >= 0.0);
        CHECK(mark.number("cx") <= root.number("width"));
        CHECK(mark.number("cy") >= 0.0);
        CHECK(mark.number("cy") <= root.number("height"));
    }
}

TEST_CASE("a chart without values says so") {
    const std::string svg = chartSvg(
        {"t", "x", "y", true, false, {{"a", {{-1.0, 2.0}, {kNone, 1.0}}, false}}});
    CHECK(XmlReader(svg).error.empty());
    CHECK(svg.find(">no values<") != std::string::npos);
    CHECK(XmlReader(chartSvg({})).error.empty());
}

TEST_CASE("the marks of six series differ, and so do their colours") {
    std::set<std::string> marks, groups;
    for (std::size_t s = 0; s < kMarkKinds; ++s) {
        marks.insert(seriesMark(s, 10.0, 10.0, 4.0));
        groups.insert(seriesGroup(s, ""));
    }
    CHECK(marks.size() == kMarkKinds);
    CHECK(groups.size() == kMarkKinds);
    CHECK(seriesMark(kMarkKinds, 1.0, 2.0, 4.0) == seriesMark(0, 1.0, 2.0, 4.0));
    CHECK(seriesMark(0, 1.0, 2.0, 4.0, true) != seriesMark(0, 1.0, 2.0, 4.0));
}

TEST_CASE("a strip plot has a mark per seed and a bar at the median") {
    const StripPlotDef plot{"time",
                            false,
                            {{"first", 0, false, {0.0, 4.0, 10.0, 2.0}, 1},
                             {"second", 1, true, {5.0, 5.0, 5.0}, 0},
                             {"third", 2, false, {}, 3}}};
    const std::string svg = stripPlot(plot);
    const XmlReader xml(svg);
    REQUIRE(xml.error.empty());
    REQUIRE(xml.all("circle").size() == 4);
    CHECK(withClass(xml, "path", "hollow").size() == 1);  // All three at one place: one mark that says so.
    CHECK(svg.find(">all 3<") != std::string::npos);
    CHECK(svg.find(">first: 1 without a value<") != std::string::npos);
    CHECK(svg.find(">third: 3 without a value<") != std::string::npos);
    const auto bars = withClass(xml, "line", "median");
    REQUIRE(bars.size() == 2);
    // Median 3 of 0, 2, 4, 10: between the marks of 2 and 4, at 0.3 of the way from 0 to 10.
    std::vector<double> xs;
    for (const Element& mark : xml.all("circle")) xs.push_back(mark.number("cx"));
    CHECK(bars[0].number("x1") == doctest::Approx(xs[0] + 0.3 * (xs[3] - xs[0])).epsilon(1e-3));
    CHECK(bars[1].number("x1") == doctest::Approx(xs[0] + 0.5 * (xs[3] - xs[0])).epsilon(1e-3));
}

TEST_CASE("marks of a strip plot that are close stand above each other") {
    const StripPlotDef plot{"time", false, {{"a", 0, false, {1.0, 1.001, 1.002, 9.0}, 0}}};
    const XmlReader xml(stripPlot(plot));
    std::set<std::string> heights;
    const auto marks = xml.all("circle");
    REQUIRE(marks.size() == 4);
    for (std::size_t i = 0; i < 3; ++i) heights.insert(marks[i].attribute("cy"));
    CHECK(heights.size() == 3);
    CHECK(marks[3].attribute("cy") == marks[0].attribute("cy"));
}
