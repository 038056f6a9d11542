// muster play
#include <memory>
#include <string>
#include <vector>

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
    bool json = false;
};

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
    const auto figures = runWorld(*std::move(world), *def, *commands, run);
    if (!figures.ok()) return reportFailure(figures.status());
    if (options.json) {
        printJsonValue(figuresJson(*figures));
    } else {
        printFigures(*figures);
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
        .option("--seconds", options->run.seconds,
                "Simulated time; without it until all have arrived and stand, at most 120 s after the last "
                "command.")
        .finite(0.0, 1e6);
    options->overrides.addTo(command);
    command
        .option("--threads", options->run.threads,
                "Threads; 0 takes what the machine has. Results are the same.")
        .range(0, 256);
    command.option("--take", options->run.takePath, "Records a take into this file.");
    command.option(
        "--trajectory", options->run.trajectoryPath,
        "Writes t,id,x,y,place_x,place_y,group,heading,motion,goal for every step into this CSV file.");
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "Examples:\n"
        "  muster play scenarios/block.json --demo\n"
        "  muster play scenarios/open.json --seconds 10 --set character.maxSpeed=1.5 --json\n"
        "  muster play scenarios/cars.json --gestures scenarios/gestures/cars.json --take cars.take");
    command.run([options] { return play(*options); });
}

}  // namespace muster
