// Plays every scenario with its gestures, by each solver of plans, and prints the hash of its state every two
// seconds. The same lines must come out of every compiler, build type, number of threads, and of WebAssembly.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <string>
#include <vector>

#include "base/hash.h"
#include "muster/scenario.h"
#include "muster/world.h"

namespace {

int fail(const muster::Status& status) {
    std::fprintf(stderr, "%s\n", status.message().c_str());
    return 1;
}

int play(const std::filesystem::path& path, muster::PlanSolver solver, double seconds, int threads) {
    auto def = muster::loadScenario(path.string());
    if (!def.ok()) return fail(def.status());
    def->parameters.plan.solver = solver;
    const char* plan = solver == muster::PlanSolver::Fast ? "fast" : "exact";
    auto world = muster::World::create(*def, threads);
    if (!world.ok()) return fail(world.status());
    const auto gestures = path.parent_path() / "gestures" / path.filename();
    if (std::filesystem::exists(gestures)) {
        const auto commands = muster::loadGestures(gestures.string(), def->parameters.stepTime);
        if (!commands.ok()) return fail(commands.status());
        for (const muster::Command& command : *commands) {
            const muster::Status status = world->submit(command);
            if (!status.ok()) return fail(status);
        }
    }
    const auto steps = static_cast<int>(seconds / def->parameters.stepTime + 0.5);
    for (int step = 1; step <= steps; ++step) {
        world->step();
        if (step % 120 == 0 || step == steps)
            std::printf("%s/%s %d %s\n", path.stem().c_str(), plan, step,
                        muster::toHex(world->hash()).c_str());
    }
    return 0;
}

}  // namespace

// Arguments: the scenarios' folder, seconds, threads.
int main(int argc, char** argv) {
    if (argc != 4) {
        std::fprintf(stderr, "usage: scenario_hashes FOLDER SECONDS THREADS\n");
        return 2;
    }
    std::vector<std::filesystem::path> paths;
    for (const auto& entry : std::filesystem::directory_iterator(argv[1]))
        if (entry.path().extension() == ".json" &&
            entry.path().stem().string().find("schema") == std::string::npos)
            paths.push_back(entry.path());
    std::sort(paths.begin(), paths.end());
    if (paths.empty()) {
        std::fprintf(stderr, "no scenario in %s\n", argv[1]);
        return 1;
    }
    for (const auto& path : paths)
        for (const auto solver : {muster::PlanSolver::Exact, muster::PlanSolver::Fast})
            if (const int code = play(path, solver, std::atof(argv[2]), std::atoi(argv[3])); code != 0)
                return code;
    return 0;
}
