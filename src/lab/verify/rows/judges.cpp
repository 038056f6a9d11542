#include "lab/verify/rows/judges.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "lab/measures/series.h"

namespace muster {
namespace {

/// The smallest step from each value to the next.
double leastRise(const std::vector<double>& values) {
    double least = std::numeric_limits<double>::infinity();
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (!std::isfinite(values[i])) return kUnmeasured;
        least = std::min(least, values[i] - values[i - 1]);
    }
    return least;
}

std::vector<double> heightsOf(const std::vector<Vec2>& points) {
    std::vector<double> values;
    for (const Vec2 p : points) values.push_back(p.y);
    return values;
}

}  // namespace

JudgeRow judgeFromRest(const std::string& variant, double low, double high) {
    return [=](const VerifySamples& samples, RowReport& report) {
        report.within("time for 40 m, from rest", samples.mean(variant, "fromRest"), low, high, "s",
                      Whose::Standard);
        report.shown("time for 40 m, after 10 m of run-in", samples.mean(variant, "time"), "s");
    };
}

JudgeRow judgeSpeed(const std::string& variant, double length, double speed) {
    return [=](const VerifySamples& samples, RowReport& report) {
        const double time = samples.mean(variant, "time");
        report.within("speed over " + std::to_string(static_cast<int>(length)) + " m", length / time,
                      0.95 * speed, 1.05 * speed, "m/s", Whose::Own);
        report.shown("time", time, "s");
    };
}

JudgeRow judgeStarts() {
    return [](const VerifySamples& samples, RowReport& report) {
        report.atMost("first movement away from the assigned time, the worst",
                      samples.most("uniform", "worst"), 0.5, "s", Whose::Own);
        report.shown("set out before its time, at most", samples.most("uniform", "early"), "s");
        report.shown("set out after its time, at most", samples.most("uniform", "late"), "s");
        report.shown("pushed from their spots by 5 cm before their time, of 10",
                     samples.mean("uniform", "pushed"), "");
        double least = samples.runs("uniform").empty() ? kUnmeasured : 1e9;
        for (const Vec2 p : samples.points("uniform", "starts")) least = std::min(least, p.x);
        report.within("smallest assigned time", least, 10.0, 100.0, "s", Whose::Standard);
        report.plots.push_back({"Assigned time and first movement",
                                "assigned time [s]",
                                "first movement [s]",
                                {{"equal", {{0, 0}, {100, 100}}, PlotSeries::Look::Line},
                                 {"persons", samples.points("uniform", "starts"), PlotSeries::Look::Marks}},
                                {},
                                {},
                                ""});
    };
}

JudgeRow judgeStartDistributions(const std::vector<std::pair<std::string, Distribution>>& spreads) {
    return [spreads](const VerifySamples& samples, RowReport& report) {
        for (const auto& [name, spread] : spreads) {
            const auto points = samples.points(name, "starts");
            report.atLeast(name + ": p of first movements, " + std::to_string(points.size()) + " persons",
                           kolmogorovSmirnov(heightsOf(points), spread), 0.05, "", Whose::Own);
            report.shown(name + ": first movement away from the assigned time, the worst",
                         samples.most(name, "worst"), "s");
        }
    };
}

JudgeRow judgeCorner(const std::string& variant) {
    return [variant](const VerifySamples& samples, RowReport& report) {
        report.atLeast("round the corner, of 20", samples.least(variant, "left"), 20.0, "", Whose::Standard);
        report.atMost("farthest off the ground", 1000.0 * samples.most(variant, "outside"), 1.0, "mm",
                      Whose::Own);
    };
}

JudgeRow judgeSpeeds(const std::string& variant, const Distribution& spread, bool meanAndDeviation) {
    return [=](const VerifySamples& samples, RowReport& report) {
        const auto points = samples.points(variant, "speeds");
        const auto values = heightsOf(points);
        report.atLeast("p of free speeds, " + std::to_string(values.size()) + " persons",
                       kolmogorovSmirnov(values, spread), 0.05, "", Whose::Own);
        if (values.empty()) return;
        const MeanAndDeviation found = meanOf(values);
        if (meanAndDeviation) {
            report.within("mean", found.mean, spread.a - 0.05, spread.a + 0.05, "m/s", Whose::Own);
            report.within("deviation", found.deviation, spread.b - 0.05, spread.b + 0.05, "m/s", Whose::Own);
        } else {
            report.within("slowest", *std::min_element(values.begin(), values.end()), 0.97 * 0.97, 1.62,
                          "m/s", Whose::Own);
            report.within("fastest", *std::max_element(values.begin(), values.end()), 0.97, 1.62 * 1.03,
                          "m/s", Whose::Own);
            report.shown("mean", found.mean, "m/s");
        }
    };
}

JudgeRow judgeCounterflow() {
    return [](const VerifySamples& samples, RowReport& report) {
        std::vector<double> times;
        for (const char* others : {"0", "10", "50", "100"}) {
            times.push_back(samples.mean(others, "time"));
            report.shown(std::string("last of 100 in the other room, ") + others + " against", times.back(),
                         "s");
        }
        report.atLeast("least rise from case to case", leastRise(times), 0.0, "s", Whose::Standard);
        report.plots.push_back(
            curvesPlot(samples, {"0", "10", "50", "100"}, "N-t", "People in the other room"));
    };
}

JudgeRow judgePublicRoom() {
    return [](const VerifySamples& samples, RowReport& report) {
        const double four = samples.mean("4", "time"), two = samples.mean("2", "time");
        report.shown("last one out by 4 doors", four, "s");
        report.shown("last one out by 2 doors", two, "s");
        report.within("ratio", two / four, 1.6, 2.4, "", Whose::Own);
        report.plots.push_back(curvesPlot(samples, {"4", "2"}, "N-t", "People outside"));
    };
}

JudgeRow judgeCabins() {
    return [](const VerifySamples& samples, RowReport& report) {
        report.atLeast("by their own exit, of 23", samples.least("", "right"), 23.0, "", Whose::Standard);
        report.shown("last one out", samples.mean("", "time"), "s");
    };
}

JudgeRow judgeExitFlow() {
    return [](const VerifySamples& samples, RowReport& report) {
        report.atMost("flow over the whole period, the exit's rate set to 1.33 /s (restricted flow)",
                      std::round(100.0 * samples.most("capped", "flow")) / 100.0, 1.33, "/s",
                      Whose::Standard);
        report.shown("flow that emerges without a rate", samples.mean("free", "flow"), "/s");
        report.note(
            "The limit is one of capacity for design. People pass more through a door of 1 m (1.8 to 2.0 /s "
            "in the "
            "measured data), and so do ours; who wants the limit sets the exit's rate.");
        report.plots.push_back(curvesPlot(samples, {"free", "capped"}, "N-t", "People outside"));
    };
}

JudgeRow judgeStairJam(const std::string& variant, bool grows) {
    return [=](const VerifySamples& samples, RowReport& report) {
        const double middle = samples.mean(variant, "density middle");
        report.atLeast("density before the door over that in the corridor",
                       samples.mean(variant, "density door") / middle, 1.0, "", Whose::Standard);
        report.atLeast("density at the foot of the stairs over that in the corridor",
                       samples.mean(variant, "density foot") / middle, 1.0, "", Whose::Standard);
        if (grows)
            report.atLeast("density at the foot, second half over first half",
                           samples.mean(variant, "late foot") / samples.mean(variant, "early foot"), 1.0, "",
                           Whose::Standard);
        report.shown("density in the corridor", middle, "/m2");
        report.shown("flow through the door", samples.mean(variant, "flow door"), "/s");
        report.shown("flow at the foot", samples.mean(variant, "flow foot"), "/s");
        VerifyPlot plot{"Density in time", "time [s]", "density [1/m2]", {}, {}, {}, ""};
        for (const char* where : {"door", "middle", "foot"})
            if (!samples.runs(variant).empty()) {
                const auto& curves = samples.runs(variant).front().curves;
                const auto at = curves.find(std::string("density ") + where);
                if (at != curves.end()) plot.series.push_back({where, at->second, PlotSeries::Look::Line});
            }
        report.plots.push_back(plot);
    };
}

JudgeRow judgeGroups(const std::string& variant) {
    return [variant](const VerifySamples& samples, RowReport& report) {
        report.atMost("first to last of group 1 at the exit", samples.most(variant, "spread"), 10.0, "s",
                      Whose::Standard);
        report.shown("last of group 1", samples.mean(variant, "last"), "s");
    };
}

JudgeRow judgeSlowOne() {
    return [](const VerifySamples& samples, RowReport& report) {
        const double slow = samples.mean("slow", "time"), equal = samples.mean("equal", "time");
        report.atLeast("longer with the slow one", slow - equal, 0.0, "s", Whose::Standard);
        report.shown("with the slow one", slow, "s");
        report.shown("25 equal", equal, "s");
    };
}

JudgeRow judgeSocial() {
    return [](const VerifySamples& samples, RowReport& report) {
        const double without = samples.mean("without", "share"), with = samples.mean("with", "share");
        report.atLeast("rise of the share of exit 2", with - without, 0.01, "", Whose::Standard);
        report.shown("share of exit 2 without the third", without, "");
        report.shown("share of exit 2 with the third", with, "");
    };
}

JudgeRow judgeAffiliation() {
    return [](const VerifySamples& samples, RowReport& report) {
        report.within("share of exit 2 without a preference", samples.mean("none", "right"), 0.3, 0.7, "",
                      Whose::Own);
        report.atLeast("share of exit 2, which is preferred", samples.mean("right", "right"), 0.8, "",
                       Whose::Own);
        report.atMost("share of exit 2, exit 1 is preferred", samples.mean("left", "right"), 0.2, "",
                      Whose::Own);
    };
}

JudgeRow judgeDynamicExit() {
    return [](const VerifySamples& samples, RowReport& report) {
        report.within("exit of the person", samples.mean("", "exit"), 2.0, 2.0, "", Whose::Standard);
        report.shown("exit that it went to before", samples.mean("", "first"), "");
        report.shown("time", samples.mean("", "time"), "s");
    };
}

RowDef rowOf(const std::string& suite, const std::string& number, const std::string& title,
             const std::string& setup, const std::string& expected, const std::string& source) {
    return {.id = suite + " " + number,
            .suite = suite,
            .title = title,
            .source = source,
            .expected = expected,
            .setup = setup};
}

RowDef runIn(RowDef row, const std::string& scene, std::vector<std::string> variants, std::int32_t seeds,
             std::int32_t briefSeeds, JudgeRow judge) {
    row.scene = scene;
    row.variants = std::move(variants);
    row.seeds = seeds;
    row.briefSeeds = briefSeeds;
    row.judge = std::move(judge);
    return row;
}

RowDef missingRow(const std::string& suite, const std::string& number, const std::string& title,
                  const std::string& expected, const std::string& why) {
    RowDef row = rowOf(suite, number, title, "", expected, "");
    row.missing = why;
    return row;
}

VerifyPlot curvesPlot(const VerifySamples& samples, const std::vector<std::string>& variants,
                      const std::string& curve, const std::string& title) {
    VerifyPlot plot{title, "time [s]", "persons", {}, {}, {}, ""};
    for (const std::string& variant : variants) {
        const auto& runs = samples.runs(variant);
        if (runs.empty()) continue;
        const auto at = runs.front().curves.find(curve);
        if (at != runs.front().curves.end())
            plot.series.push_back({variant, at->second, PlotSeries::Look::Line});
    }
    return plot;
}

}  // namespace muster
