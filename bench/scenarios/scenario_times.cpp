// Times the steps of scenarios with their gestures. Prints for each one its name, the milliseconds of all
// steps (the shortest of several plays), the worst step of that play, and the hash of its end. bench/wasm.mjs
// sets builds beside each other.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>

#include "base/hash.h"
#include "muster/scenario.h"
#include "muster/world.h"

namespace {

using Clock = std::chrono::steady_clock;

struct Play {
    double total = 0.0;  ///< Time of all steps [ms].
    double worst = 0.0;  ///< Time of the longest step but the first [ms].
    std::string hash;
};

muster::Result<Play> play(const std::filesystem::path& path, double seconds, int threads) {
    auto def = muster::loadScenario(path.string());
    if (!def.ok()) return def.status();
    auto world = muster::World::create(*def, threads);
    if (!world.ok()) return world.status();
    const auto commands = muster::loadScenarioGestures(path.string(), *def);
    if (!commands.ok()) return commands.status();
    for (const muster::Command& command : *commands)
        if (const muster::Status status = world->submit(command); !status.ok()) return status;
    Play result;
    const auto steps = static_cast<int>(std::lround(seconds / def->parameters.stepTime));
    for (int step = 1; step <= steps; ++step) {
        const auto began = Clock::now();
        world->step();
        const double time = std::chrono::duration<double, std::milli>(Clock::now() - began).count();
        result.total += time;
        if (step > 1) result.worst = std::max(result.worst, time);
    }
    result.hash = muster::toHex(world->hash());
    return result;
}

/// The plays of one scenario: prints the shortest.
int timeScenario(const std::filesystem::path& path, double seconds, int threads, int plays) {
    Play best;
    for (int i = 0; i < plays; ++i) {
        auto now = play(path, seconds, threads);
        if (!now.ok()) {
            std::fprintf(stderr, "%s: %s\n", path.string().c_str(), now.status().message().c_str());
            return 1;
        }
        if (i == 0 || now->total < best.total) best = *now;
    }
    std::printf("%s %.3f %.3f %s\n", path.stem().c_str(), best.total, best.worst, best.hash.c_str());
    return 0;
}

}  // namespace

// Arguments: seconds of world time, threads, plays of each scenario, the scenarios' files.
int main(int argc, char** argv) {
    if (argc < 5) {
        std::fprintf(stderr, "usage: scenario_times SECONDS THREADS PLAYS SCENARIO...\n");
        return 2;
    }
    for (int i = 4; i < argc; ++i)
        if (const int code = timeScenario(argv[i], std::atof(argv[1]), std::atoi(argv[2]),
                                          std::atoi(argv[3]));
            code != 0)
            return code;
    return 0;
}
