// ISO 20414:2020, tests 1 to 19.
#include <algorithm>
#include <cmath>

#include "lab/verify/rows/judges.h"

namespace muster {
namespace {

RowDef iso(const std::string& number, const std::string& title, const std::string& setup,
           const std::string& expected, const std::string& scene, std::vector<std::string> variants,
           std::int32_t seeds, std::int32_t briefSeeds, JudgeRow judge) {
    return runIn(rowOf("ISO", number, title, setup, expected,
                       "ISO 20414:2020, as jupedsim-web and pyFDS-Evac render it"),
                 scene, std::move(variants), seeds, briefSeeds, std::move(judge));
}

const std::vector<std::string> kStairWidths{"1.0", "1.2", "1.4", "1.6", "1.8"};
const std::vector<std::string> kZones{"60", "120", "240", "360", "480"};

void judgeStairWidths(const VerifySamples& samples, RowReport& report) {
    std::vector<Vec2> flows;
    double least = 1e9;
    for (const std::string& width : kStairWidths) {
        flows.push_back({std::atof(width.c_str()), samples.mean(width, "flow")});
        report.shown("flow at " + width + " m", flows.back().y, "/s");
        if (flows.size() > 1) least = std::min(least, flows.back().y - flows[flows.size() - 2].y);
        if (!std::isfinite(flows.back().y)) least = kUnmeasured;
    }
    report.atLeast("least rise of flow from width to width", least, 0.0, "/s", Whose::Standard);
    report.plots.push_back({"Flow on stairs by width",
                            "width [m]",
                            "flow [1/s]",
                            {{"100 people", flows, PlotSeries::Look::Line}},
                            {},
                            {},
                            ""});
}

void judgeZones(const VerifySamples& samples, RowReport& report) {
    std::vector<Vec2> means;
    double rise = -1e9, fastest = 0.0;
    for (const std::string& count : kZones) {
        const double density = samples.mean(count, "density"), speed = samples.mean(count, "speed"),
                     flow = samples.mean(count, "flow");
        report.within(count + " people: flow at x = 40 over density x speed x 2 m",
                      flow / (density * speed * 2.0), 0.75, 1.25, "", Whose::Own);
        if (!means.empty()) rise = std::max(rise, speed - means.back().y);
        means.push_back({density, speed});
        fastest = std::max(fastest, speed);
    }
    report.atMost("largest rise of speed with density", rise, 0.0, "m/s", Whose::Own);
    report.atMost("largest mean speed", fastest, 1.34 * 1.05, "m/s", Whose::Standard);
    report.plots.push_back({"Speed by density in the middle zone",
                            "density [1/m2]",
                            "speed [m/s]",
                            {{"mean from 3 to 15 s", means, PlotSeries::Look::Marks},
                             {"Weidmann 1993", weidmannCurve(), PlotSeries::Look::Line}},
                            {},
                            {},
                            ""});
}

void judgeLayout(const VerifySamples& samples, RowReport& report) {
    report.atLeast("over the shorter way, of 10", samples.mean("", "short"), 6.0, "", Whose::Standard);
    report.atLeast("out, of 10", samples.least("", "left"), 10.0, "", Whose::Standard);
}

}  // namespace

std::vector<RowDef> isoRows() {
    const std::vector<std::pair<std::string, Distribution>> starts{
        {"uniform", Distribution::uniform(10.0, 100.0)},
        {"normal", Distribution::normal(60.0, 20.0, 0.0, 1e7)},
        {"lognormal", {Spread::LogNormal, 4.586, 0.967, 0.0, 1e7}}};
    return {
        iso("1", "Pre-evacuation times", "Room 8 x 5 m, exit 1 m, 10 people, three distributions",
            "First movements follow the distribution that was set", "premovement",
            {"uniform", "normal", "lognormal"}, 6, 1, judgeStartDistributions(starts)),
        iso("2", "Speed in a corridor", "40 m, one person of 1.0 m/s", "40 s", "corridor", {"1.0"}, 1, 1,
            judgeSpeed("1.0", 40.0, 1.0)),
        iso("3", "Speed on stairs", "Stairs of 10 m, one person, half of 1.0 m/s on them",
            "0.5 m/s: the factor that was set", "free stairs", {"up 1.0 10 0.5"}, 1, 1,
            [](const VerifySamples& samples, RowReport& report) {
                report.within("speed", samples.mean("up 1.0 10 0.5", "speed"), 0.45, 0.55, "m/s", Whose::Own);
            }),
        iso("4", "Corner", "L of 2 m width, 20 people", "All out, nobody outside", "corner", {"1.0"}, 10, 1,
            judgeCorner("1.0")),
        iso("5", "Demographics", "100 people of N(1.2, 0.2) m/s", "Mean and deviation as assigned",
            "demographics", {"normal"}, 1, 1,
            judgeSpeeds("normal", Distribution::normal(1.2, 0.2, 0.3, 2.2), true)),
        iso("6", "Counterflow", "Two rooms 10 x 10 m, corridor 10 x 2 m, 100 people against 0, 10, 50, 100",
            "The time rises from case to case", "counterflow", {"0", "10", "50", "100"}, 10, 1,
            judgeCounterflow()),
        iso("7", "Overtaking of a disabled person", "24 and one slower and larger (room and corridor, ours)",
            "Longer than with equals", "slow one", {"slow", "equal"}, 10, 1, judgeSlowOne()),
        iso("8", "Assigned routes", "12 cabins, 23 people, two exits", "All at their exit", "cabins", {""},
            10, 1, judgeCabins()),
        iso("9", "Exits that are shut", "Two exits, exit 1 lost after 1 s", "The person leaves by exit 2",
            "dynamic exit", {""}, 1, 1, judgeDynamicExit()),
        iso("10", "Jam before stairs", "Room, neck of 2 m, stairs with half of the speed, 100 people",
            "Denser at the neck and at the foot of the stairs than between", "stair jam", {"100"}, 10, 5,
            judgeStairJam("100", false)),
        iso("11", "Largest flow", "Room 8 x 5 m, exit 1 m, 100 people", "At most 1.33 /s/m", "exit flow",
            {"free", "capped"}, 10, 1, judgeExitFlow()),
        iso("12", "Flow on stairs", "Stairs 1.0 to 1.8 m wide, 4.24 m long, 100 people each",
            "Flow rises with width", "stair width", kStairWidths, 10, 1, judgeStairWidths),
        iso("13", "Flow, density, speed", "Corridor 60 x 2 m, 60 to 480 people",
            "Flow, density and speed fit each other and the law, never above the free speed", "zones", kZones,
            10, 1, judgeZones),
        iso("14", "Groups",
            "Group 1: four of 1.25 m/s and one of 0.5; group 2: ten of 0.5 m/s (room 10 x 20 m, ours)",
            "Within 10 s at the exit", "groups", {"0.5"}, 10, 1, judgeGroups("0.5")),
        iso("15", "Social influence", "Room 10 x 12 m, two exits, two, then three people",
            "The share of exit 2 rises", "social", {"without", "with"}, 20, 20, judgeSocial()),
        iso("16", "Affiliation", "Room 10 x 12 m, two exits", "The preferred exit wins", "affiliation",
            {"none", "left", "right"}, 20, 20, judgeAffiliation()),
        iso("17", "Routes by the layout",
            "Ring of corridors 20 x 20 m, a way across it over two stairs, 10 people, unfolded to one floor "
            "(dimensions ours)",
            "Most take the quicker way", "layout", {""}, 10, 1, judgeLayout),
        missingRow("ISO", "18", "Reduced visibility", "The time is that of the model's own law of smoke",
                   "Muster has no smoke, and no law of it"),
        missingRow("ISO", "19", "Incapacitation", "Time to a fractional effective dose of 1",
                   "Muster has no gases"),
    };
}

}  // namespace muster
