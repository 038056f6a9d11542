#include "others.h"

#include <array>
#include <cmath>
#include <cstdio>
#include <map>
#include <optional>
#include <sstream>

#include "files/report/markup.h"

namespace muster {
namespace {

/// Figures of JuPedSim's models by name, printed as "name value" by a program for Python; what it needs is in
/// the package `jupedsim` and its `shapely`.
constexpr const char* kJupedsimScript = R"python(
import sys
try:
    import jupedsim as jps
    from shapely import Polygon, union_all
except ImportError:
    sys.exit(3)

def box(a, b, c, d):
    return Polygon([(a, b), (c, b), (c, d), (a, d)])

def crossings(rooms, exit_box, start_box, count, speed, line, most):
    sim = jps.Simulation(model=jps.CollisionFreeSpeedModel(), geometry=union_all(rooms), dt=0.01)
    out = sim.add_exit_stage(list(exit_box.exterior.coords)[:-1])
    journey = sim.add_journey(jps.JourneyDescription([out]))
    places = jps.distribute_by_number(polygon=start_box, number_of_agents=count, distance_to_agents=0.42,
                                      distance_to_polygon=0.22, seed=1)
    for place in places:
        sim.add_agent(jps.CollisionFreeSpeedModelAgentParameters(
            position=place, journey_id=journey, stage_id=out, desired_speed=speed, radius=0.2))
    before, crossed = {}, {}
    while sim.agent_count() > 0 and sim.elapsed_time() < most:
        sim.iterate()
        for agent in sim.agents():
            x = agent.position[0]
            if before.get(agent.id, x) < line <= x:
                crossed.setdefault(agent.id, sim.elapsed_time())
            before[agent.id] = x
    return sorted(crossed.values())

corridor = box(0, 0, 60, 2)
times = crossings([corridor], box(58, 0, 60, 2), box(0.5, 0.5, 1.5, 1.5), 1, 1.33, 41.0, 120)
print("corridor_s", times[0] if times else "nan")
for w in (0.8, 1.0, 1.2, 2.0):
    rooms = [box(0, 0, 12, 12), box(12, 6 - w / 2, 12.4, 6 + w / 2), box(12.4, 2, 17, 10)]
    times = crossings(rooms, box(15, 2, 17, 10), box(3, 0.5, 11.5, 11.5), 120, 1.34, 12.2, 300)
    k = len(times) // 5
    print("door_%g" % w, (len(times) - 1 - 2 * k) / (times[-1 - k] - times[k]) if len(times) > 9 else "nan")
)python";

/// What the script printed; none where Python or the package is missing.
std::optional<std::map<std::string, double>> jupedsimFigures() {
    const std::string command = "python3 - 2>/dev/null <<'MUSTER_END'\n" + std::string(kJupedsimScript) +
                                "MUSTER_END\n";
    std::FILE* pipe = popen(command.c_str(), "r");
    if (pipe == nullptr) return std::nullopt;
    std::string text;
    std::array<char, 256> part{};
    while (std::fgets(part.data(), static_cast<int>(part.size()), pipe) != nullptr) text += part.data();
    if (pclose(pipe) != 0) return std::nullopt;
    std::map<std::string, double> figures;
    std::istringstream lines(text);
    for (std::string name, value; lines >> name >> value;) figures[name] = std::atof(value.c_str());
    return figures;
}

/// A value that a row has measured, by the beginning of its words; kUnmeasured where it was not run.
double measured(const Verification& verification, const std::string& row, const std::string& what) {
    for (const RowResult& result : verification.rows)
        if (result.row.id == row)
            for (const VerifyCheck& check : result.report.checks)
                if (check.what.rfind(what, 0) == 0) return check.value;
    return kUnmeasured;
}

struct OtherScene {
    const char* title;
    const char* row;  // Ours.
    const char* what;
    double factor;         // From our value to the one shown.
    const char* jupedsim;  // Name of its figure; empty for none.
    const char* recorded;  // Figures that others have published.
};

constexpr OtherScene kOtherScenes[] = {
    {"40 m at 1.33 m/s from rest [s]", "RiMEA 1", "time for 40 m, from rest", 1.0, "corridor_s",
     "window 26 to 34"},
    {"door of 0.8 m [1/s]", "Data 3", "specific flow at 0.8", 0.8, "door_0.8",
     "Kretz 2006 1.42; Seyfried 2009 1.29"},
    {"door of 1.0 m [1/s]", "Data 3", "specific flow at 1.0", 1.0, "door_1",
     "Kretz 2006 1.86; Seyfried 2009 1.90"},
    {"door of 1.2 m [1/s]", "Data 3", "specific flow at 1.2", 1.2, "door_1.2",
     "Kretz 2006 2.14; Seyfried 2009 2.36"},
    {"door of 2.0 m [1/s]", "Data 3", "specific flow at 2.0", 2.0, "door_2", "EG 2006 3.55; Nagai 2006 3.87"},
    {"IMO 4, exit of 1 m [1/s]", "IMO 4", "flow that emerges", 1.0, "", "FDS+Evac 1.24, other setting 1.54"},
    {"IMO 8, nobody against [s]", "IMO 8", "last of 100 in the other room, 0 ", 1.0, "", "FDS+Evac 50"},
    {"IMO 8, 10 against [s]", "IMO 8", "last of 100 in the other room, 10 ", 1.0, "", "FDS+Evac 75"},
    {"IMO 8, 50 against [s]", "IMO 8", "last of 100 in the other room, 50 ", 1.0, "", "FDS+Evac 107"},
    {"IMO 8, 100 against [s]", "IMO 8", "last of 100 in the other room, 100 ", 1.0, "", "FDS+Evac 136"},
    {"IMO 9, four doors [s]", "IMO 9", "last one out by 4 doors", 1.0, "",
     "FDS+Evac 220.7, other setting 171.3"},
    {"IMO 9, two doors [s]", "IMO 9", "last one out by 2 doors", 1.0, "",
     "FDS+Evac 412.9, other setting 322.9"},
    {"Jain 2025, score [%]", "Data 9", "score by our reading", 1.0, "",
     "UPL 57.14 (the paper's own cut-offs)"},
};

std::string column(const std::string& text, std::size_t width) {
    return text + std::string(text.size() < width ? width - text.size() : 1, ' ');
}

}  // namespace

std::string besideOthers(const Verification& verification) {
    const auto found = jupedsimFigures();
    std::string text = "Beside others (JuPedSim: " +
                       std::string(found ? "its Python package, collision-free speed model"
                                         : "not found; `pip install jupedsim` puts it beside") +
                       ")\n" + column("Scene", 34) + column("Muster", 10) + column("JuPedSim", 10) +
                       "Recorded\n";
    for (const OtherScene& scene : kOtherScenes) {
        const double own = scene.factor * measured(verification, scene.row, scene.what);
        std::string theirs = "-";
        if (found && found->contains(scene.jupedsim)) theirs = fixedNumber(found->at(scene.jupedsim), 2);
        text += column(scene.title, 34) + column(std::isfinite(own) ? fixedNumber(own, 2) : "-", 10) +
                column(theirs, 10) + scene.recorded + "\n";
    }
    return text;
}

}  // namespace muster
