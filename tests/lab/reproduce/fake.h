// A reproduction that was never run, with all kinds of content, and what is hard on a page.
#pragma once

#include <limits>
#include <string>
#include <utility>
#include <vector>

#include "lab/reproduce/reproduce.h"

namespace muster::testing {

inline constexpr double kNone = std::numeric_limits<double>::quiet_NaN();

/// A picture with a shape that has an id and one that refers to it.
inline std::string fakePicture(double height, const std::string& colour) {
    const std::string size = std::to_string(static_cast<int>(height));
    return "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"440\" height=\"" + size +
           "\" viewBox=\"0 0 440 " + size +
           "\" font-family=\"Inter, Helvetica, Arial, sans-serif\">\n<rect width=\"100%\" height=\"100%\" "
           "fill=\"#E6E1D9\"/>\n"
           "<circle id=\"dot\" cx=\"120\" cy=\"90\" r=\"40\" fill=\"" +
           colour +
           "\"/><use href=\"#dot\" x=\"150\"/>"
           "<rect x=\"20\" y=\"150\" width=\"200\" height=\"20\" fill=\"url(#dot)\"/>\n</svg>\n";
}

inline RunSample fakeRun(double base, std::uint64_t seed, bool film) {
    const double k = static_cast<double>(seed);
    RunSample run{.figures = {{"through", 36.0},
                              {"time", base + 0.37 * k * k - 1.1 * k},
                              {"slow", seed % 4 == 0 ? kNone : 12345.6 * k},
                              {"same", 2.5},
                              {"never", kNone},
                              {"ratio", 1.0 / k}}};
    if (base > 25.0) run.figures["own"] = k;
    run.hash = 0x0123456789abcdefull + seed;
    if (film) {
        run.film = {
            {
                0.0,
                "at rest",
                fakePicture(300, "#1D5FD1"),
            },
            {4.25,
             "the first <36> of \"them\" duck & go slower where the branches hang low over the narrow path",
             fakePicture(300, "#CB4A0E")},
            {12.5, "half through", fakePicture(220, "#016553")},
            {21.05, "no picture here", ""},
            {40.0, "all there", fakePicture(300, "#87598B")}};
    }
    return run;
}

/// An experiment with arms in both presets, charts, criteria that pass, fail and have no values.
inline ExperimentResult fakeWoodland(std::size_t seeds) {
    ExperimentResult x{
        .text = {"X4", "Dense <woodland> & more",
                 "Figure 7a: \"36 characters\" get through.\nA second paragraph, with a < b && c > d.",
                 "A wood of 120 trunks, 12 m deep; arrival is measured at its far edge.", "x04-woodland",
                 "Those under branches go at 0.6 of their speed.\nWhat differs from the paper: nothing that "
                 "could be seen."},
        .arms = {{"transport", "Transport"},
                 {"fixed", "Fixed places"},
                 {"transport", "Transport", "paper"},
                 {"fixed", "Fixed places", "paper"}},
        .figures = {{"through", "people through the wood", "", 0},
                    {"time", "last one there", "s", 2},
                    {"slow", "way of those under branches", "m", 1},
                    {"same", "a figure that never differs", "m", 2},
                    {"never", "what nobody reached", "s", 2},
                    {"own", "of some arms only", "", 0},
                    {"ratio", "time over the paper's", "", 3}}};
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        double base = 20.0;
        for (const Arm& arm : x.arms)
            x.samples.add(arm.id, arm.preset,
                          fakeRun(base += 3.0, seed, seed == 1 && arm.preset == "muster"));
    }
    Judge judge(seeds);
    for (const char* preset : {"muster", "paper"}) {
        judge.require("36 of 36 through the wood", preset, x.samples.values("transport", preset, "through"),
                      Aggregate::Lowest, Comparison::AtLeast, 36.0);
        judge.require("last one there", preset, x.samples.values("transport", preset, "time"),
                      Aggregate::Median, Comparison::AtMost, 30.0, "s");
        judge.require(
            "transport over fixed places, last one there, where a rather long sentence says what is compared",
            preset,
            ratios(x.samples.values("transport", preset, "time"), x.samples.values("fixed", preset, "time")),
            Aggregate::Median, Comparison::AtMost, 0.5);
    }
    judge.require("what nobody reached", "muster", x.samples.values("transport", "muster", "never"),
                  Aggregate::Median, Comparison::AtMost, 10.0, "s");
    judge.require("way of those under branches", "muster", x.samples.values("transport", "muster", "slow"),
                  Aggregate::Highest, Comparison::AtMost, 1e6, "m");
    x.verdicts = judge.verdicts();
    ChartDef chart{"People through the wood, by time: the paper's preset is slower",
                   "time [s]",
                   "people through",
                   false,
                   false,
                   {}};
    ChartDef cost{"Time of a step by the size of the crowd", "characters", "step [ms]", true, true, {}};
    for (std::size_t s = 0; s < 7; ++s) {
        ChartSeries line{
            "Arm " + std::to_string(s) +
                (s == 2
                     ? ", with a title that is very long indeed and needs more than one line <of the legend>"
                     : ""),
            {},
            s == 5};
        ChartSeries curve = line;
        for (double t = 0.0; t <= 40.0; t += 2.0) {
            line.points.push_back({t, s == 3 && t > 20.0 && t < 25.0
                                          ? kNone
                                          : std::min(36.0, t * (0.6 + 0.2 * static_cast<double>(s)))});
            curve.points.push_back(
                {10.0 * (1.0 + t * t * t), 0.2 * (1.0 + static_cast<double>(s)) * (1.0 + t * t)});
        }
        chart.series.push_back(line);
        if (s < 3) cost.series.push_back(curve);
    }
    x.charts = {chart, cost, {"Nothing was measured", "x", "y", false, false, {{"none", {}, false}}}};
    return x;
}

/// One arm, one criterion that holds, nothing else.
inline ExperimentResult fakeHalves(std::size_t seeds) {
    ExperimentResult x{.text = {"X2", "A line and an area", "Figure 3.", "A square of 64.", "", ""},
                       .arms = {{"both", "Line and area"}},
                       .figures = {{"ratio", "left over right", "", 1}}};
    Judge judge(seeds);
    std::vector<double> values;
    for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
        RunSample run{.figures = {{"ratio", 6.0 + 0.001 * static_cast<double>(seed)}}};
        values.push_back(run.figures["ratio"]);
        if (seed == 1) run.film = {{1.0, "at rest", fakePicture(440, "#1D5FD1")}};
        x.samples.add("both", "muster", std::move(run));
    }
    judge.require("left half over right half", "muster", values, Aggregate::Median, Comparison::AtLeast, 5.0);
    x.verdicts = judge.verdicts();
    return x;
}

inline Reproduction fakeReproduction(std::size_t seeds = 10) {
    return {.experiments = {fakeHalves(seeds), fakeWoodland(seeds)},
            .seeds = static_cast<std::int32_t>(seeds),
            .seconds = 812.4,
            .version = "0.1.0",
            .when = "2026-01-02 03:04 UTC"};
}

}  // namespace muster::testing
