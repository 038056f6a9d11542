// muster study replay
#include <algorithm>
#include <cstdio>
#include <memory>
#include <string>

#include "base/hash.h"
#include "commands.h"
#include "folders.h"
#include "host_loop.h"
#include "report.h"
#include "studio/study/host/replay_host.h"
#include "studio/study/store/store.h"

namespace muster {
namespace {

struct StudyReplayOptions {
    std::string db;
    int trial = 0;
    bool studio = false;
    ServeOptions serve;
};

struct StoredTrial {
    StudyTrial trial;
    RunKind kind = RunKind::People;
};

Result<StoredTrial> findTrial(StudyStore& store, std::int64_t id) {
    const auto trials = store.trials();
    if (!trials.ok()) return trials.status();
    const auto found = std::find_if(trials->begin(), trials->end(),
                                    [&](const StudyTrial& trial) { return trial.id == id; });
    if (found == trials->end())
        return Status(StatusCode::NotFound, "the database holds no trial " + std::to_string(id) +
                                                "; it has " + std::to_string(trials->size()) + " trials");
    const auto runs = store.runs();
    if (!runs.ok()) return runs.status();
    StoredTrial stored{*found};
    for (const StudyRun& run : runs.value())
        if (run.id == found->run) stored.kind = run.kind;
    return stored;
}

// Runs it to its end and compares.
int compareTrial(TrialReplay replay, const StudyTrial& trial, const ServeOptions& options) {
    while (!replay.atEnd())
        if (Status status = replay.step(); !status.ok()) return reportFailure(status);
    const TrialResult result = replay.trial().result();
    const bool stored = trial.state != RunState::Running;
    const bool same = stored && result.hash == trial.result.hash;
    if (options.json) {
        printJsonValue({{"trial", trial.id},
                        {"reproduced", same},
                        {"steps", result.steps},
                        {"seconds", result.seconds},
                        {"collected", result.collected},
                        {"items", result.items},
                        {"hash", toHex(result.hash)}});
    } else {
        std::printf("trial %lld, %s, %s: %u steps, %d of %d items, hash %s\n",
                    static_cast<long long>(trial.id), trial.def.environment.c_str(), trial.def.scheme.c_str(),
                    result.steps, result.collected, result.items, toHex(result.hash).c_str());
    }
    if (!stored) {
        std::fprintf(stderr, "muster: the trial was cut off, so that no hash is stored to compare with\n");
        return kExitOk;
    }
    if (same) return kExitOk;
    std::fprintf(stderr, "muster: found the hash %s, expected %s\n", toHex(result.hash).c_str(),
                 toHex(trial.result.hash).c_str());
    return kExitNotReproduced;
}

int studyReplay(const StudyReplayOptions& options) {
    auto store = StudyStore::open(options.db, StoreMode::Existing);
    if (!store.ok()) return reportFailure(store.status());
    const auto stored = findTrial(store.value(), options.trial);
    if (!stored.ok()) return reportFailure(stored.status());
    auto inputs = store->inputs(stored->trial.id);
    if (!inputs.ok()) return reportFailure(inputs.status());
    const bool ended = stored->trial.state != RunState::Running;
    auto replay = TrialReplay::create(stored->trial.def, std::move(inputs).value(),
                                      ended ? stored->trial.result.steps : 0);
    if (!replay.ok()) return reportFailure(replay.status());
    if (!options.studio) return compareTrial(std::move(replay).value(), stored->trial, options.serve);
    ReplayHostDef def{.version = MUSTER_VERSION, .trial = stored->trial, .kind = stored->kind};
    ReplayHost host(std::move(replay).value(), std::move(def));
    return serve(host, options.serve);
}

}  // namespace

void addStudyReplayCommand(Subcommand& study) {
    Subcommand command = study.add("replay", "Runs a trial again from its stored inputs.");
    auto options = std::make_shared<StudyReplayOptions>();
    options->serve.mode = "study";
    options->serve.title = "Muster study, replay";
    command.option("--db", options->db, "The study's database.").required();
    command.option("--trial", options->trial, "Number of the trial, as exports have it.")
        .required()
        .range(1, 2147483647);
    const Option studio = command.flag("--studio", options->studio,
                                       "Shows the trial in the browser, at 1 to 8 times its speed.");
    command.option("--port", options->serve.port, "Port; the next free one where it is in use.")
        .range(1, 65535)
        .needs(studio);
    command.option("--page", options->serve.pageFolder, "Folder of the built page.")
        .existingFolder()
        .needs(studio);
    command.flag("--open", options->serve.openBrowser, "Opens the page in the desktop's browser.")
        .needs(studio);
    command.flag("--json", options->serve.json, "One JSON value on standard output.");
    command.footer(
        "Prints the hash of the world at the end; ends with 3 where it is not the stored one.\n"
        "Examples:\n"
        "  muster study replay --db study.db --trial 12\n"
        "  muster study replay --db study.db --trial 12 --studio --open");
    command.run([options] {
        if (options->serve.pageFolder.empty()) options->serve.pageFolder = pageFolder();
        return studyReplay(*options);
    });
}

}  // namespace muster
