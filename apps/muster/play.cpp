// muster play
#include <cstdio>
#include <memory>
#include <string>

#include "base/generated/enumeration_words.h"
#include "commands.h"
#include "muster/scenario.h"
#include "options.h"
#include "overrides.h"
#include "report.h"
#include "runner.h"
#include "touches.h"

namespace muster {
namespace {

struct PlayOptions {
    std::string scenario;
    Touches touches;
    Overrides overrides;
    RunDef run;
    bool timings = false;
    bool json = false;
};

/// Says that a run ended before everybody had arrived or left.
void printCutOff(const RunOutcome& outcome, const WorldDef& def, const std::string& path) {
    const RunFigures& f = outcome.figures;
    std::uint32_t waiting = 0;
    for (const SourceFigures& source : f.departures.sources) waiting += source.waiting;
    const std::string wait = waiting > 0 ? " and " + std::to_string(waiting) + " waiting at sources" : "";
    const std::string who = f.departures.exits.empty()
                                ? "before all had arrived"
                                : "with " + std::to_string(f.characters) + " persons inside" + wait;
    std::fprintf(stderr, "muster: %s: the run ended after %.0f s, %s; --seconds lets it go on\n",
                 path.c_str(), f.steps * def.parameters.stepTime, who.c_str());
}

/// By groups, how many stand as each word tells.
Json standingsJson(const RunOutcome& outcome) {
    Json groups = Json::array();
    for (const RunOutcome::GroupStandings& group : outcome.standings) {
        Json one = {{"group", group.name}};
        for (std::size_t k = 0; k < group.counts.size(); ++k) one[kStandingWords[k]] = group.counts[k];
        groups.push(one);
    }
    return groups;
}

int play(const PlayOptions& options) {
    const RunDef& run = options.run;
    auto def = loadScenario(options.scenario);
    if (!def.ok()) return reportFailure(def.status());
    if (Status s = options.overrides.apply(*def); !s.ok()) return reportFailure(s);
    const auto gestures = options.touches.file(options.scenario, *def);
    if (!gestures.ok()) return reportFailure(gestures.status());
    if (Status s = differentFiles({options.scenario, *gestures}, {run.takePath, run.trajectoryPath}); !s.ok())
        return reportFailure(s);
    const auto commands = options.touches.load(options.scenario, *def);
    if (!commands.ok()) return reportFailure(commands.status());
    auto world = World::create(*def, run.threads);
    if (!world.ok()) return reportFailure(world.status().within(options.scenario));
    printWarnings(*def, options.scenario);
    const auto outcome = runWorld(*std::move(world), *def, *commands, run);
    if (!outcome.ok()) return reportFailure(outcome.status());
    if (outcome->cutOff) printCutOff(*outcome, *def, options.scenario);
    if (options.json) {
        Json value = figuresJson(outcome->figures);
        value["cut_off"] = outcome->cutOff;
        value["standings"] = standingsJson(*outcome);
        printJsonValue(value);
    } else {
        printFigures(outcome->figures, options.timings);
        for (const RunOutcome::GroupStandings& group : outcome->standings)
            std::printf("%-26s %s\n", group.name.c_str(), standingSentence(group.counts).c_str());
    }
    return kExitOk;
}

}  // namespace

void addPlayCommand(CommandLine& line) {
    Subcommand command = line.add("play", "Simulates a scenario without a window and reports figures.");
    auto options = std::make_shared<PlayOptions>();
    command.option("SCENARIO", options->scenario, "Scenario file.").required();
    options->touches.addTo(command);
    command
        .option(
            "--seconds", options->run.seconds,
            "Simulated time; without it until all have arrived and stand or have left and nobody comes any "
            "more, at most 120 s after the last command.")
        .finite(0.0, 1e6);
    options->overrides.addTo(command);
    command
        .option("--threads", options->run.threads,
                "Threads; 0 takes what the machine has. Results are the same.")
        .range(0, 256);
    command.option("--take", options->run.takePath, "Records a take into this file.");
    const Option trajectory = command.option(
        "--trajectory", options->run.trajectoryPath,
        "Writes t,id,x,y,place_x,place_y,group,heading,motion,goal for every step into this CSV file.");
    command
        .option("--every", options->run.every,
                "Writes the trajectory of every N-th step only; there are 60 a second, unless step.time says "
                "other.")
        .range(1, 1000000)
        .needs(trajectory);
    command.flag("--timings", options->timings, "Also prints the mean time of every stage of a step.");
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "Examples:\n"
        "  muster play scenarios/block.json --demo\n"
        "  muster play scenarios/open.json --seconds 10 --set character.maxSpeed=1.5 --json\n"
        "  muster play hall.json --seconds 600 --seed 7 --trajectory hall.csv --every 6\n"
        "  muster play scenarios/cars.json --gestures scenarios/gestures/cars.json --take cars.take");
    command.run([options] { return play(*options); });
}

}  // namespace muster
