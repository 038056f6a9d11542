// IMO MSC.1/Circ.1238 (2007), Annex 3, taken over by MSC.1/Circ.1533 (2016).
#include "lab/verify/rows/judges.h"

namespace muster {
namespace {

RowDef imo(const std::string& number, const std::string& title, const std::string& setup,
           const std::string& expected, const std::string& scene, std::vector<std::string> variants,
           std::int32_t seeds, std::int32_t briefSeeds, JudgeRow judge) {
    return runIn(rowOf("IMO", number, title, setup, expected,
                       "IMO MSC.1/Circ.1238 and 1533, Annex 3, as FDS+Evac renders it"),
                 scene, std::move(variants), seeds, briefSeeds, std::move(judge));
}

}  // namespace

std::vector<RowDef> imoRows() {
    return {
        imo("1", "Speed in a corridor", "Corridor 40 x 2 m, one person of 1.0 m/s",
            "40 s for 40 m: the speed that was set", "corridor", {"1.0"}, 1, 1, judgeSpeed("1.0", 40.0, 1.0)),
        imo("2", "Speed up stairs", "Stairs 10 x 2 m, one person of 1.0 m/s on them", "10 s for 10 m",
            "free stairs", {"up 1.0 10 1.0"}, 1, 1, judgeSpeed("up 1.0 10 1.0", 10.0, 1.0)),
        imo("3", "Speed down stairs", "As 2, downwards", "10 s for 10 m", "free stairs", {"down 1.0 10 1.0"},
            1, 1, judgeSpeed("down 1.0 10 1.0", 10.0, 1.0)),
        imo("4", "Flow of an exit", "Room 8 x 5 m, exit 1 m, 100 people",
            "At most 1.33 /s over the whole period: the design capacity", "exit flow", {"free", "capped"}, 10,
            1, judgeExitFlow()),
        imo("5", "Response time", "Room of 4, 10 people, 10 to 100 s", "Each starts at its own time",
            "premovement", {"uniform"}, 10, 1, judgeStarts()),
        imo("6", "Corner", "L of 2 m width, 20 people of 1.0 m/s", "All round, nobody passes a wall",
            "corner", {"1.0"}, 10, 1, judgeCorner("1.0")),
        imo("7", "Demographics", "50 men of 30 to 50 years, 0.97 to 1.62 m/s",
            "Speeds follow the distribution that was set", "demographics", {"men"}, 1, 1,
            judgeSpeeds("men", Distribution::uniform(0.97, 1.62), false)),
        imo("8", "Counterflow", "Two rooms 10 x 10 m, corridor 10 x 2 m, 100 people against 0, 10, 50, 100",
            "The time of the last of 100 in the other room rises from case to case", "counterflow",
            {"0", "10", "50", "100"}, 10, 1, judgeCounterflow()),
        imo("9", "Public room", "Room 30 x 20 m, 1000 people, four doors of 1 m, then two",
            "The time about doubles", "public room", {"4", "2"}, 3, 0, judgePublicRoom()),
        imo("10", "Assigned routes", "12 cabins, 23 people, two exits",
            "15 by the main exit, 8 by the second one", "cabins", {""}, 10, 1, judgeCabins()),
        imo("11", "Stairs", "Room 8 x 5 m, corridor 12 x 2 m, stairs 3 x 2 m, 150 people",
            "A jam at the exit of the room, steady flow, a growing jam at the foot of the stairs",
            "stair jam", {"150"}, 10, 1, judgeStairJam("150", true)),
    };
}

}  // namespace muster
