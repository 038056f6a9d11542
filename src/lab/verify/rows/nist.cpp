// NIST Technical Note 1822 (Ronchi et al. 2013), section 3.1.
#include "lab/verify/rows/judges.h"

namespace muster {
namespace {

RowDef nist(const std::string& number, const std::string& title, const std::string& setup,
            const std::string& expected, const std::string& scene, std::vector<std::string> variants,
            std::int32_t seeds, std::int32_t briefSeeds, JudgeRow judge) {
    return runIn(
        rowOf("NIST", number, title, setup, expected, "NIST TN 1822 (2013), as jupedsim-web renders it"),
        scene, std::move(variants), seeds, briefSeeds, std::move(judge));
}

}  // namespace

std::vector<RowDef> nistRows() {
    const std::vector<std::pair<std::string, Distribution>> starts{
        {"uniform", Distribution::uniform(10.0, 100.0)},
        {"gamma", {Spread::Gamma, 1.291, 103.901, 0.0, 1e7}},
        {"lognormal", {Spread::LogNormal, 4.586, 0.967, 0.0, 1e7}},
        {"weibull", {Spread::Weibull, 139.285, 1.195, 0.0, 1e7}}};
    return {
        nist("1.1", "Pre-evacuation times", "Room 8 x 5 m, exit 1 m, 10 people, four distributions",
             "First movements follow the distribution that was set", "premovement",
             {"uniform", "gamma", "lognormal", "weibull"}, 6, 1, judgeStartDistributions(starts)),
        nist("2.1", "Speed in a corridor", "40 m, one person of 1.0 m/s", "40 s", "corridor", {"1.0"}, 1, 1,
             judgeSpeed("1.0", 40.0, 1.0)),
        nist("2.2", "Speed on stairs", "Stairs of 100 m, one person of 1.0 m/s on them, up and down", "100 s",
             "free stairs", {"up 1.0 100 1.0", "down 1.0 100 1.0"}, 1, 1,
             [](const VerifySamples& samples, RowReport& report) {
                 judgeSpeed("up 1.0 100 1.0", 100.0, 1.0)(samples, report);
                 judgeSpeed("down 1.0 100 1.0", 100.0, 1.0)(samples, report);
             }),
        nist("2.3", "Corner", "L of 2 m width, 20 people", "Nobody passes a wall, all are out", "corner",
             {"1.0"}, 10, 1, judgeCorner("1.0")),
        nist("2.4", "Demographics", "100 people of N(1.2, 0.2) m/s", "Speeds as assigned", "demographics",
             {"normal"}, 1, 1, judgeSpeeds("normal", Distribution::normal(1.2, 0.2, 0.3, 2.2), true)),
        missingRow("NIST", "2.5", "Reduced visibility", "The time is that of the model's own law of smoke",
                   "Muster has no smoke, and no law of it"),
        missingRow("NIST", "2.6", "Incapacitation", "Time to a fractional effective dose of 1",
                   "Muster has no gases"),
        missingRow("NIST", "2.7", "Elevators", "Not established", "needs floors and lifts"),
        nist("2.8", "Counterflow",
             "Two rooms 10 x 10 m, corridor 10 x 2 m, 100 people against 0, 10, 50, 100",
             "The time rises from case to case", "counterflow", {"0", "10", "50", "100"}, 10, 1,
             judgeCounterflow()),
        nist("2.9", "Groups",
             "Group 1: four of 1.25 m/s and one of 0.5; group 2: ten of 0.2 m/s (room 10 x 20 m, ours)",
             "Group 1 is at the exit within 10 s of each other", "groups", {"0.2"}, 10, 1,
             judgeGroups("0.2")),
        nist("2.10", "Movement disabilities",
             "24 of 1.25 m/s and one of 0.8 m/s with a radius of 0.4 m; 25 equal (room and corridor, ours)",
             "With the slow one it takes longer", "slow one", {"slow", "equal"}, 10, 1, judgeSlowOne()),
        nist("3.1", "Assigned routes", "12 cabins, 23 people, two exits",
             "Everybody leaves by the assigned exit", "cabins", {""}, 10, 1, judgeCabins()),
        nist("3.2", "Social influence",
             "Room 10 x 12 m, two exits, two who follow others by 5 s; then a third, bound to exit 2",
             "The share of exit 2 rises", "social", {"without", "with"}, 20, 20, judgeSocial()),
        nist("3.3", "Affiliation", "Room 10 x 12 m, two exits, one person who prefers one by 5 s",
             "Without a preference alike, with it the preferred one", "affiliation",
             {"none", "left", "right"}, 20, 20, judgeAffiliation()),
        nist("4.1", "Exits that are shut", "Room 10 x 12 m, two exits, exit 1 shut after 1 s",
             "The person leaves by exit 2", "dynamic exit", {""}, 1, 1, judgeDynamicExit()),
        nist("5.1", "Congestion", "Room 8 x 5 m, corridor 12 x 2 m, stairs, 100 people",
             "Jams at the exit of the room and at the foot of the stairs, steady between", "stair jam",
             {"100"}, 10, 5, judgeStairJam("100", false)),
        nist("5.2", "Largest flow", "Room 8 x 5 m, exit 1 m, 100 people",
             "The cap of a restricted flow is obeyed: 1.33 /s", "exit flow", {"free", "capped"}, 10, 1,
             judgeExitFlow()),
    };
}

}  // namespace muster
