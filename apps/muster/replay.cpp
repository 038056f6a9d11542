// muster replay
#include <algorithm>
#include <memory>
#include <optional>
#include <string>

#include "base/hash.h"
#include "commands.h"
#include "muster/scenario.h"
#include "muster/take.h"
#include "options.h"
#include "report.h"

namespace muster {
namespace {

struct ReplayOptions {
    std::string take;
    std::string gestures;
    int threads = 1;
    bool json = false;
};

int replay(const ReplayOptions& options) {
    if (Status s = differentFiles({options.take}, {options.gestures}); !s.ok()) return reportFailure(s);
    const auto take = readTake(options.take);
    if (!take.ok()) return reportFailure(take.status());
    if (!options.gestures.empty()) {
        const Status saved = saveGestures(take->commands, take->def.parameters.stepTime, options.gestures);
        if (!saved.ok()) return reportFailure(saved);
    }
    if (take->tornBytes > 0) {
        std::fprintf(stderr, "muster: %s: the last record is torn; %zu bytes are left out\n",
                     options.take.c_str(), take->tornBytes);
    }
    Progress progress("replaying");
    const std::uint32_t steps = take->steps();
    std::optional<RunMetrics> metrics;
    Json figures;
    const auto report = replayTake(*take, options.threads, [&](const World& world) {
        if (options.json) {
            if (!metrics) metrics.emplace(world);
            metrics->observe(world);
            if (world.stepCount() == steps) figures = figuresJson(metrics->figures(world, false));
        }
        progress.show(static_cast<double>(world.stepCount()) / std::max(1u, steps));
        return true;
    });
    const bool differs = !report.ok() && report.status().code() == StatusCode::Corrupt;
    if (!report.ok() && !differs) return reportFailure(report.status().within(options.take));
    if (options.json) {
        Json value = {{"reproduced", !differs}, {"steps", nullptr}, {"hash", nullptr}};
        value["marks"] = take->marks.size();
        value["commands"] = take->commands.size();
        value["events"] = take->events.size();
        value["finished"] = take->finished;
        value["torn_bytes"] = take->tornBytes;
        if (!differs) {
            value["steps"] = report->steps;
            value["unmarked_steps"] = report->unmarked;
            value["hash"] = toHex(report->hash);
            value["figures"] = figures;
        }
        if (differs) value["message"] = report.status().message();
        printJsonValue(value);
    } else if (!differs) {
        std::printf("reproduced: %u steps, %u hashes compared, the last is %s\n", report->steps,
                    report->compared, toHex(report->hash).c_str());
        if (report->unmarked > 0)
            std::printf("unfinished: its last %u steps bear no hash and were compared with nothing\n",
                        report->unmarked);
    }
    if (!differs) return kExitOk;
    std::fprintf(stderr, "muster: %s: %s%s\n", options.take.c_str(), report.status().message().c_str(),
                 take->frames.empty() ? "" : "; its stored frames can still be shown and exported");
    return kExitNotReproduced;
}

}  // namespace

void addReplayCommand(CommandLine& line) {
    Subcommand command = line.add("replay", "Simulates a take again and compares every hash.");
    auto options = std::make_shared<ReplayOptions>();
    command.option("TAKE", options->take, "Take file.").required();
    command.option("--gestures", options->gestures,
                   "Also writes the take's touches and other commands as a gestures file for muster play.");
    command.option("--threads", options->threads, "Threads; 0 takes what the machine has.").range(0, 256);
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "Ends with 3 where a hash differs; the message names the first step that does. With --json it also "
        "gives the\n"
        "figures of muster play. A take that was never finished is replayed to its last command; the steps "
        "behind its\n"
        "last hash are compared with nothing.\n"
        "Examples:\n"
        "  muster replay cars.take\n"
        "  muster replay cars.take --threads 4 --json\n"
        "  muster replay cars.take --gestures cars.json && muster play scenarios/cars.json --gestures "
        "cars.json");
    command.run([options] { return replay(*options); });
}

}  // namespace muster
