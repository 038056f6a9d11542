// muster replay
#include <algorithm>
#include <optional>
#include <string>

#include "commands.h"
#include "muster/base/hash.h"
#include "muster/take/take.h"
#include "report.h"

namespace muster {
namespace {

struct ReplayOptions {
    std::string take;
    int threads = 1;
    bool json = false;
};

int replay(const ReplayOptions& options) {
    const auto take = readTake(options.take);
    if (!take.ok()) return reportFailure(take.status());
    if (take->tornBytes > 0) {
        std::fprintf(stderr, "muster: %s: the last record is torn; %zu bytes are left out\n", options.take.c_str(),
                     take->tornBytes);
    }
    Progress progress("replaying");
    std::optional<RunMetrics> metrics;
    nlohmann::ordered_json figures;
    const auto report = replayTake(*take, options.threads, [&](const World& world) {
        if (options.json) {
            if (!metrics) metrics.emplace(world);
            metrics->observe(world);
            if (world.stepCount() == take->steps()) figures = figuresJson(metrics->figures(world, false));
        }
        progress.show(static_cast<double>(world.stepCount()) / std::max(1u, take->steps()));
        return true;
    });
    const bool differs = !report.ok() && report.status().code() == StatusCode::Corrupt;
    if (!report.ok() && !differs) return reportFailure(report.status().within(options.take));
    if (options.json) {
        nlohmann::ordered_json value = {{"reproduced", !differs}, {"steps", nullptr}, {"hash", nullptr}};
        value["marks"] = take->marks.size();
        value["commands"] = take->commands.size();
        value["finished"] = take->finished;
        value["torn_bytes"] = take->tornBytes;
        if (!differs) {
            value["steps"] = report->steps;
            value["hash"] = toHex(report->hash);
            value["figures"] = figures;
        }
        if (differs) value["message"] = report.status().message();
        printJsonValue(value);
    } else if (!differs) {
        std::printf("reproduced: %u steps, %u hashes compared, the last is %s\n", report->steps, report->compared,
                    toHex(report->hash).c_str());
    }
    if (!differs) return kExitOk;
    std::fprintf(stderr, "muster: %s: %s\n", options.take.c_str(), report.status().message().c_str());
    return kExitNotReproduced;
}

}  // namespace

void addReplayCommand(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("replay", "Simulates a take again and compares every hash.");
    auto options = std::make_shared<ReplayOptions>();
    command->add_option("TAKE", options->take, "Take file.")->required();
    command->add_option("--threads", options->threads, "Threads; 0 takes what the machine has.")
        ->check(CLI::Range(0, 256));
    command->add_flag("--json", options->json, "One JSON value on standard output.");
    command->footer(
        "Ends with 3 where a hash differs; the message names the first step that does. With --json it also gives the\n"
        "figures of muster play.\n"
        "Examples:\n"
        "  muster replay cars.take\n"
        "  muster replay cars.take --threads 4 --json");
    command->callback([options, &exitCode] { exitCode = replay(*options); });
}

}  // namespace muster
