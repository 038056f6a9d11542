// RiMEA: guideline 4.1.1 of 2025, and tests 12 and 13 of version 3.0.
#include <algorithm>
#include <cmath>

#include "lab/measures/series.h"
#include "lab/verify/rows/judges.h"

namespace muster {
namespace {

constexpr const char* kRimeaSource = "RiMEA 4.1.1 (2025) and 3.0, as public test suites render them";
const std::vector<std::string> kRingDensities{"0.5 equal", "1 equal", "2 equal", "3 equal",
                                              "4 equal",   "5 equal", "6 equal"};

RowDef rimea(const std::string& number, const std::string& title, const std::string& setup,
             const std::string& expected) {
    return rowOf("RiMEA", number, title, setup, expected, kRimeaSource);
}

JudgeRow judgeStairTime(const std::string& variant) {
    return [variant](const VerifySamples& samples, RowReport& report) {
        report.within("time for 10 m at 0.5 m/s", samples.mean(variant, "time"), 19.0, 21.0, "s", Whose::Own);
    };
}

void judgeDiagram(const VerifySamples& samples, RowReport& report) {
    VerifyPlot plot{"Speed by density", "density [1/m2]", "speed [m/s]", {}, {}, {}, "Weidmann +- 0.1 m/s"};
    std::vector<Vec2> means, points;
    for (const std::string& variant : kRingDensities) {
        const double density = std::atof(variant.c_str()), speed = samples.mean(variant, "speed");
        if (density < 5.4)
            report.within("speed at " + variant.substr(0, variant.find(' ')) + " /m2", speed,
                          weidmannSpeed(density) - 0.1, weidmannSpeed(density) + 0.1, "m/s", Whose::Own);
        else
            report.shown("speed at 6 /m2", speed, "m/s");
        means.push_back({density, speed});
        const auto more = samples.points(variant, "points");
        points.insert(points.end(), more.begin(), more.end());
    }
    for (const Vec2 p : weidmannCurve()) {
        plot.bandLow.push_back({p.x, std::max(0.0, p.y - 0.1)});
        plot.bandHigh.push_back({p.x, p.y + 0.1});
    }
    plot.series = {{"on 2 x 2 m, each second", points, PlotSeries::Look::Dots},
                   {"mean over the ring", means, PlotSeries::Look::Marks},
                   {"Weidmann 1993", weidmannCurve(), PlotSeries::Look::Line}};
    report.plots.push_back(plot);
    VerifyPlot flow{"Flow by density", "density [1/m2]", "flow [1/m/s]", {}, {}, {}, ""};
    for (Vec2& p : means) p.y *= p.x;
    auto curve = weidmannCurve();
    for (Vec2& p : curve) p.y *= p.x;
    flow.series = {{"mean over the ring", means, PlotSeries::Look::Marks},
                   {"Weidmann 1993", curve, PlotSeries::Look::Line}};
    report.plots.push_back(flow);
    report.note("A ring of 20 x 4 m in the place of a corridor of 1000 x 10 m, as crowdsim does.");
}

void judgeAges(const VerifySamples& samples, RowReport& report) {
    const auto points = samples.points("ages", "speeds");
    VerifyPlot plot{"Free speeds by age", "age [years]", "speed [m/s]", {}, {}, {}, "range +- 0.03 m/s"};
    std::vector<Vec2> persons;
    const double low[] = {1.60, 1.52, 1.46, 1.39, 1.27, 1.07}, high[] = {1.64, 1.56, 1.50, 1.43, 1.27, 1.07};
    for (int k = 0; k < 6; ++k) {
        const double age = 20.0 + 10.0 * k, set = walkingSpeedAtAge(age);
        double sum = 0.0, count = 0.0;
        for (const Vec2 p : points)
            if (std::abs(p.x - set) < 1e-6) sum += p.y, count += 1.0, persons.push_back({age, p.y});
        report.within("mean speed at " + std::to_string(20 + 10 * k), sum / count, low[k] - 0.03,
                      high[k] + 0.03, "m/s", Whose::Own);
        plot.bandLow.push_back({age, low[k] - 0.03});
        plot.bandHigh.push_back({age, high[k] + 0.03});
    }
    plot.series = {{"persons", persons, PlotSeries::Look::Marks}};
    report.plots.push_back(plot);
}

void judgeChoice(const VerifySamples& samples, RowReport& report) {
    const double near = samples.mean("", "near"), far = samples.mean("", "far");
    report.atLeast("more by the near exit than by the far one", near - far, 1.0, "", Whose::Standard);
    report.atLeast("by the far exit", samples.least("", "far"), 1.0, "", Whose::Standard);
    report.shown("by the near exit", near, "");
    report.shown("last one out", samples.mean("", "time"), "s");
}

void judgeOldBottleneck(const VerifySamples& samples, RowReport& report) {
    report.atLeast("flow of the corridor less that of the exit",
                   samples.mean("", "corridor") - samples.mean("", "exit"), -0.05, "/s", Whose::Own);
    report.atLeast("most people before the corridor over those before the exit",
                   samples.mean("", "before corridor") / std::max(1.0, samples.mean("", "before exit")), 1.0,
                   "", Whose::Standard);
    report.shown("most people on 2 x 4 m before the corridor", samples.mean("", "before corridor"), "");
    report.shown("most people on 2 x 4 m before the exit", samples.mean("", "before exit"), "");
    report.shown("flow of the corridor", samples.mean("", "corridor"), "/s");
    VerifyPlot plot = curvesPlot(samples, {""}, "N-t corridor", "People through the corridor and the exit");
    if (!samples.runs("").empty())
        plot.series = {{"corridor", samples.points("", "N-t corridor"), PlotSeries::Look::Line},
                       {"exit", samples.points("", "N-t exit"), PlotSeries::Look::Line}};
    report.plots.push_back(plot);
}

const std::vector<std::string> kGoals{"0 0.2 1", "1 0.2 1", "2 0.2 1", "4 0.2 1", "6 0.2 1", "10 0.2 1"};

void judgeBottlenecks(const VerifySamples& samples, RowReport& report) {
    std::vector<Vec2> times;
    for (const std::string& goal : kGoals)
        times.push_back({std::atof(goal.c_str()), samples.mean(goal, "time")});
    report.atLeast("a: time with the goal 10 m behind over that in the bottleneck",
                   times.back().y / times.front().y, 1.0, "", Whose::Standard);
    report.within("a: time at 10 m over that at 6 m: constant", times.back().y / times[4].y, 0.9, 1.1, "",
                  Whose::Own);
    report.atLeast("b: longer through 5 m than through 0.2 m",
                   samples.mean("4 5 1", "time") - samples.mean("4 0.2 1", "time"), 0.0, "s",
                   Whose::Standard);
    const double narrow = samples.mean("4 5 0.8", "flow"), middle = samples.mean("4 5 1", "flow"),
                 wide = samples.mean("4 5 1.2", "flow");
    report.atLeast("d: least rise of flow over widths of 0.8, 1.0, 1.2 m",
                   std::min(middle - narrow, wide - middle), 0.0, "/s", Whose::Standard);
    report.plots.push_back({"a: time by the distance of the goal",
                            "distance [m]",
                            "time [s]",
                            {{"150 people", times, PlotSeries::Look::Line}},
                            {},
                            {},
                            ""});
    report.plots.push_back(
        {"d: flow by width",
         "width [m]",
         "flow [1/s]",
         {{"measured here", {{0.8, narrow}, {1.0, middle}, {1.2, wide}}, PlotSeries::Look::Marks},
          {"1.9 /s/m", {{0.8, 1.52}, {1.2, 2.28}}, PlotSeries::Look::Line}},
         {},
         {},
         ""});
}

void judgeCongestion(const VerifySamples& samples, RowReport& report) {
    report.atLeast("most people before bottleneck 1 less those before 2",
                   samples.mean("", "queue 1") - samples.mean("", "queue 2"), 1.0, "", Whose::Own);
    report.shown("most people on 3 x 6 m before bottleneck 1", samples.mean("", "queue 1"), "");
    report.shown("most people on 3 x 6 m before bottleneck 2", samples.mean("", "queue 2"), "");
    report.shown("flow 1", samples.mean("", "flow 1"), "/s");
    report.shown("flow 2", samples.mean("", "flow 2"), "/s");
    report.plots.push_back({"People before both bottlenecks",
                            "time [s]",
                            "people",
                            {{"bottleneck 1", samples.points("", "people 1"), PlotSeries::Look::Line},
                             {"bottleneck 2", samples.points("", "people 2"), PlotSeries::Look::Line}},
                            {},
                            {},
                            ""});
}

double shareInside(const std::vector<Vec2>& points, const Band& band) {
    double inside = 0.0, all = 0.0;
    for (const Vec2 p : points)
        if (band.covers(p)) all += 1.0, inside += band.contains(p) ? 1.0 : 0.0;
    return all > 0.0 ? inside / all : kUnmeasured;
}

void judgeStairs(const VerifySamples& samples, RowReport& report) {
    double means[2] = {};
    for (const bool up : {true, false}) {
        const std::string way = up ? "up" : "down";
        const auto points = samples.points(way, "points");
        const Band& band = rimeaStairBand(up);
        report.atLeast(way + ": share of samples in the band", shareInside(points, band), 0.5, "",
                       Whose::Own);
        double sum = 0.0, count = 0.0;
        for (const Vec2 p : points)
            if (band.covers(p)) sum += p.y, count += 1.0;
        means[up ? 0 : 1] = sum / count;
        report.plots.push_back({"Stairs " + way,
                                "density [1/m2]",
                                "speed [m/s]",
                                {{"each second", points, PlotSeries::Look::Dots}},
                                band.low,
                                band.high,
                                "figure 16 of the guideline"});
    }
    report.atLeast("down less up, at 0.6 to 1.5 /m2", means[1] - means[0], 0.0, "m/s", Whose::Standard);
}

void judgeWideCorner(const VerifySamples& samples, RowReport& report) {
    const double near = samples.mean("44", "time"), corner = samples.mean("corner", "time"),
                 far = samples.mean("75.4", "time");
    report.atLeast("corner less straight 44 m", corner - near, 0.0, "s", Whose::Standard);
    report.atLeast("straight 75.4 m less corner", far - corner, 0.0, "s", Whose::Standard);
    report.shown("straight 44 m", near, "s");
    report.shown("corner", corner, "s");
    report.shown("straight 75.4 m", far, "s");
    report.plots.push_back(curvesPlot(samples, {"44", "corner", "75.4"}, "N-t", "People at the goal"));
}

const std::vector<std::string> kFiles{"8", "14", "20", "25", "28", "34", "39", "45", "50", "56"};

void judgeFile(const VerifySamples& samples, RowReport& report) {
    // Bins of a tenth of a person per metre: their mean is to lie in the band.
    std::vector<Vec2> points;
    for (const std::string& count : kFiles) {
        const auto more = samples.points(count, "points");
        points.insert(points.end(), more.begin(), more.end());
    }
    std::vector<Vec2> means;
    double good = 0.0;
    for (int bin = 1; bin < 60; ++bin) {
        double sum = 0.0, count = 0.0;
        for (const Vec2 p : points)
            if (p.x >= bin / 10.0 && p.x < (bin + 1) / 10.0) sum += p.y, count += 1.0;
        if (count < 20.0) continue;
        means.push_back({(bin + 0.5) / 10.0, sum / count});
        good += rimeaFileBand().contains(means.back()) ? 1.0 : 0.0;
    }
    report.atLeast("share of bins of density in the band of 10 to 90 %",
                   good / static_cast<double>(means.size()), 0.75, "", Whose::Own);
    std::vector<Vec2> few;
    for (std::size_t i = 0; i < points.size(); i += 1 + points.size() / 1500) few.push_back(points[i]);
    report.plots.push_back(
        {"Single file",
         "density [1/m]",
         "speed [m/s]",
         {{"persons", few, PlotSeries::Look::Dots}, {"mean of bins", means, PlotSeries::Look::Marks}},
         rimeaFileBand().low,
         rimeaFileBand().high,
         "10 to 90 % (guideline, figure 20)"});
}

}  // namespace

std::vector<RowDef> rimeaRows() {
    std::vector<RowDef> rows;
    rows.push_back(runIn(
        rimea(
            "1", "Speed in a corridor", "Corridor 40 x 2 m, one person of 1.33 m/s",
            "26 to 34 s for 40 m: 30.1 s, give or take the size of a body, 1 s of reaction and 5 % of speed"),
        "corridor", {"1.33"}, 1, 1, judgeFromRest("1.33", 26.0, 34.0)));
    rows.push_back(runIn(rimea("2", "Speed up stairs", "Stairs 10 x 2 m, one person of 0.5 m/s on them",
                               "20 s +- 5 %: the speed that was set"),
                         "free stairs", {"up 1.0 10 0.5"}, 1, 1, judgeStairTime("up 1.0 10 0.5")));
    rows.push_back(
        runIn(rimea("3", "Speed down stairs", "As 2, downwards", "20 s +- 5 %: the speed that was set"),
              "free stairs", {"down 1.0 10 0.5"}, 1, 1, judgeStairTime("down 1.0 10 0.5")));
    rows.push_back(runIn(rimea("4", "Fundamental diagram",
                               "Ring 20 x 4 m, 0.5 to 6 people/m2 of 1.2 to 1.4 m/s, 60 s after 10 s",
                               "Speed falls with density: within 0.10 m/s of Weidmann below 5.4 /m2"),
                         "ring", kRingDensities, 10, 1, judgeDiagram));
    rows.push_back(runIn(rimea("5", "Premovement time", "Room 8 x 5 m, exit 1 m, 10 people, 10 to 100 s",
                               "Each starts at the assigned time"),
                         "premovement", {"uniform"}, 10, 1, judgeStarts()));
    rows.push_back(
        runIn(rimea("6", "Corner", "L of 2 m width, 20 people", "All arrive, nobody passes a wall"), "corner",
              {"people"}, 10, 1, judgeCorner("people")));
    rows.push_back(runIn(rimea("7", "Demographics", "50 adults of 20 to 70 years, each on a free way",
                               "Speeds by age are those of the guideline's curve"),
                         "demographics", {"ages"}, 1, 1, judgeAges));
    rows.push_back(missingRow("RiMEA", "8", "Parameter study",
                              "Documentation only: time over each parameter in a building of three floors",
                              "needs floors"));
    rows.push_back(
        runIn(rimea("9", "Large public space", "Room 30 x 20 m, 1000 people, four doors of 1 m, then two",
                    "About twice the time: half of the capacity (not an exclusion criterion)"),
              "public room", {"4", "2"}, 3, 0, judgePublicRoom()));
    rows.push_back(runIn(rimea("10", "Assigned routes", "12 cabins, 23 people, two exits",
                               "Everybody leaves by the assigned exit: 15 and 8"),
                         "cabins", {""}, 10, 1, judgeCabins()));
    rows.push_back(runIn(
        rimea("11", "Choice of exits", "Room 30 x 20 m, 1000 people on the left, two exits on the right",
              "The near exit is preferred, the far one is used, too"),
        "exit choice", {""}, 3, 0, judgeChoice));
    std::vector<std::string> bottlenecks = kGoals;
    bottlenecks.insert(bottlenecks.end(), {"4 5 1", "4 5 0.8", "4 5 1.2"});
    rows.push_back(runIn(rimea("12", "Bottleneck: goal, length, width (a, b, d)",
                               "Room 10 x 10 m, 150 people, bottleneck 0.2 or 5 m long, 0.8 to 1.2 m wide",
                               "Time rises with the distance of the goal and is then constant; a long "
                               "bottleneck takes longer; flow rises with width"),
                         "bottleneck", bottlenecks, 3, 0, judgeBottlenecks));
    rows.push_back(runIn(
        rimea("12c", "Bottleneck: congestion", "Three rooms, two bottlenecks of 1.0 x 0.2 m, 150 people",
              "No jam before the second of two equal bottlenecks"),
        "two bottlenecks", {""}, 10, 1, judgeCongestion));
    rows.push_back(
        runIn(rimea("12 (3.0)", "Bottleneck",
                    "Room 10 x 10 m, corridor 5 x 1 m, room 10 x 10 m, exit 1 m, 150 people",
                    "A jam before the corridor, none before the exit (not an exclusion criterion)"),
              "corridor between", {""}, 10, 1, judgeOldBottleneck));
    rows.push_back(runIn(rimea("13", "Fundamental diagram on stairs",
                               "Room 10 x 10 m, stairs 5 x 2 m, 100 people, up and down",
                               "At least half of the samples in the band of figure 16; faster down than up"),
                         "stair diagram", {"up", "down"}, 10, 1, judgeStairs));
    rows.push_back(runIn(
        rimea("13 (3.0)", "Jam before stairs", "Room 5 x 8 m, corridor 12 x 2 m, stairs 3 x 2 m, 150 people",
              "A jam at the door of the room and a growing one at the foot of the stairs"),
        "stair jam", {"150"}, 10, 1, judgeStairJam("150", true)));
    rows.push_back(missingRow("RiMEA", "14", "Choice of routes",
                              "Documentation only: short over stairs or long on one floor",
                              "needs floors; the guideline's figure has no dimensions"));
    rows.push_back(runIn(rimea("15", "Large crowd round a corner",
                               "20 m wide, 500 people, straight 44 m, corner, straight 75.4 m",
                               "The corner costs time: between both straight ways"),
                         "wide corner", {"44", "corner", "75.4"}, 3, 0, judgeWideCorner));
    rows.push_back(
        runIn(rimea("16", "Single file", "Ring of 26 m, 0.7 m wide, 8 to 56 people",
                    "Speeds by persons per metre in the band of 10 to 90 %, in at least 75 % of bins"),
              "file", kFiles, 10, 1, judgeFile));
    return rows;
}

}  // namespace muster
