// muster study models
#include <algorithm>
#include <cinttypes>
#include <cstdio>
#include <map>
#include <memory>
#include <tuple>

#include "base/text_file.h"
#include "lab/study/series/trial_series.h"
#include "lab/study/statistics/describe.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "report.h"
#include "sweep_parts.h"

namespace muster {
namespace {

constexpr double kLineEvery = 5.0;    // Time between lines of progress [s].
constexpr int kSensitivitySeeds = 5;  // Of each setting of the sensitivity.
constexpr const char* kSensitive[] = {"touch", "mouse-full-continuum", "mouse-full-free"};

struct StudyModelsOptions {
    std::string db;
    std::string slurm;
    std::string shard;
    std::vector<std::string> settings{"default"};
    std::vector<std::string> merge;
    SeriesDef series;
    bool sensitivity = false;
    bool tuning = false;
};

std::string leftText(double seconds) {
    if (seconds < 0.0) return "";
    char text[64];
    if (seconds >= 90.0)
        std::snprintf(text, sizeof(text), ", %.0f min left", seconds / 60.0);
    else
        std::snprintf(text, sizeof(text), ", %.0f s left", seconds);
    return text;
}

/// Whole lines, so that they can be read in the log of a job.
class Lines {
public:
    void show(const SeriesProgress& now) {
        const double time = watch_.milliseconds() / 1000.0;
        const bool last = now.done == now.of;
        if (shown_ && !last && time - last_ < kLineEvery) return;
        last_ = time;
        shown_ = true;
        std::fprintf(stderr, "%zu of %zu trials%s\n", now.done, now.of,
                     last ? "" : leftText(now.secondsLeft).c_str());
    }

private:
    Stopwatch watch_;
    double last_ = 0.0;
    bool shown_ = false;
};

Status readShard(const std::string& text, SeriesDef& def) {
    if (text.empty()) return {};
    char end = 0;
    if (std::sscanf(text.c_str(), "%" SCNd32 "/%" SCNd32 "%c", &def.shard, &def.shards, &end) == 2) return {};
    return invalidArgument("found shard '" + text.substr(0, 40) + "', expected NUMBER/OF, as 0/8");
}

/// The series that the options ask for.
Result<std::vector<SeriesDef>> seriesOf(const StudyModelsOptions& options) {
    SeriesDef def = options.series;
    def.tuning = options.tuning;
    if (Status s = readShard(options.shard, def); !s.ok()) return s;
    def.settings.clear();
    for (const std::string& word : options.settings) {
        const auto settings = seriesSettings(word);
        if (!settings.ok()) return settings.status();
        def.settings.insert(def.settings.end(), settings->begin(), settings->end());
    }
    if (!options.sensitivity) return std::vector<SeriesDef>{def};
    std::vector<SeriesDef> all;
    for (const char* word : {"one-at-a-time", "hypercube"}) {
        def.settings = *seriesSettings(word);
        def.seeds = std::min(def.seeds, kSensitivitySeeds);
        if (def.schemes.empty()) def.schemes.assign(std::begin(kSensitive), std::end(kSensitive));
        def.keepInputs = false;
        all.push_back(def);
    }
    return all;
}

/// A job of a Slurm array: each task runs its shard into a file of its own; the last line merges them.
std::string slurmJob(const StudyModelsOptions& options, const SeriesDef& def) {
    std::string command = "muster study models --seeds " + std::to_string(options.series.seeds) +
                          " --crowd " + std::to_string(def.crowd) + " --threads 1";
    const auto list = [&](const char* option, const std::vector<std::string>& values) {
        if (values.empty()) return;
        command += std::string(" ") + option + " '";
        for (std::size_t i = 0; i < values.size(); ++i) command += (i > 0 ? "," : "") + values[i];
        command += "'";
    };
    list("--environments", options.series.environments);
    list("--schemes", options.series.schemes);
    if (options.sensitivity)
        command += " --sensitivity";
    else
        list("--settings", options.settings);
    const std::string count = std::to_string(def.shards);
    const std::string about =
        "# Trials of operator models as a Slurm array. Every task writes a database of its own and goes on\n"
        "# where it was cut off when it is submitted again. When all tasks are done:\n"
        "#   muster study models --merge DB.0 --merge DB.1 ... --db DB\n"
        "# or, in the folder of the job, bash THIS_FILE merge\n";
    return slurmHead(about, "muster-study", static_cast<std::size_t>(def.shards)) +
           "#SBATCH --mem=1G\n"
           "#SBATCH --time=04:00:00\n"
           "set -euo pipefail\n"
           "db='" +
           options.db +
           "'\n"
           "if [ \"${1:-}\" = merge ]; then\n"
           "  parts=()\n"
           "  for k in $(seq 0 " +
           std::to_string(def.shards - 1) +
           "); do parts+=(--merge \"$db.$k\"); done\n"
           "  exec \"${MUSTER:-muster}\" study models \"${parts[@]}\" --db \"$db\"\n"
           "fi\n"
           "\"${MUSTER:-muster}\"" +
           command.substr(6) + " --shard \"$SLURM_ARRAY_TASK_ID/" + count +
           "\" --db \"$db.$SLURM_ARRAY_TASK_ID\"\n";
}

int mergeAll(const StudyModelsOptions& options) {
    auto into = StudyStore::open(options.db, StoreMode::Create);
    if (!into.ok()) return reportFailure(into.status());
    for (const std::string& path : options.merge) {
        auto from = StudyStore::open(path, StoreMode::Existing);
        if (!from.ok()) return reportFailure(from.status());
        if (Status s = mergeSeries(*from, *into); !s.ok()) return reportFailure(s);
    }
    return kExitOk;
}

/// What a cell of trials came to.
struct TriedCell {
    std::vector<double> seconds, commandsPerMinute, idle, misses;
    std::int32_t censored = 0;
};

int tryAll(const std::vector<SeriesDef>& all) {
    std::map<std::tuple<std::string, std::string, std::string>, TriedCell> cells;
    for (const SeriesDef& def : all) {
        const Status status = trySeries(def, [&](const SeriesTrial& trial, const ModelTrial& done) {
            TriedCell& cell = cells[{trial.def.environment, trial.setting, trial.def.scheme}];
            cell.seconds.push_back(done.result.seconds);
            cell.commandsPerMinute.push_back(60.0 * done.result.gestures / done.result.seconds);
            cell.idle.push_back(done.result.idleSeconds);
            cell.misses.push_back(done.misses);
            cell.censored += done.result.done ? 0 : 1;
        });
        if (!status.ok()) return reportFailure(status);
    }
    std::printf("%-15s %-12s %-21s %8s %9s %6s %6s %8s\n", "environment", "setting", "control", "median s",
                "gest./min", "idle s", "misses", "censored");
    for (const auto& [key, cell] : cells)
        std::printf("%-15s %-12s %-21s %8.2f %9.1f %6.1f %6.1f %8d\n", std::get<0>(key).c_str(),
                    std::get<1>(key).c_str(), std::get<2>(key).c_str(), statistics::median(cell.seconds),
                    statistics::median(cell.commandsPerMinute), statistics::median(cell.idle),
                    statistics::median(cell.misses), cell.censored);
    return kExitOk;
}

int studyModels(const StudyModelsOptions& options) {
    const auto all = seriesOf(options);
    if (!all.ok()) return reportFailure(all.status());
    for (const SeriesDef& def : *all)
        if (const auto trials = seriesTrials(def); !trials.ok()) return reportFailure(trials.status());
    if (options.tuning) return tryAll(*all);
    if (options.db.empty()) return reportFailure(invalidArgument("--db is missing: where trials are kept"));
    if (!options.slurm.empty()) {
        if (Status s = writeTextFile(options.slurm, slurmJob(options, all->front())); !s.ok())
            return reportFailure(s);
        std::printf("%s\n", options.slurm.c_str());
        return kExitOk;
    }
    if (!options.merge.empty()) return mergeAll(options);
    auto store = StudyStore::open(options.db, StoreMode::Create);
    if (!store.ok()) return reportFailure(store.status());
    for (const SeriesDef& def : *all) {
        Lines lines;
        const Status status = runSeries(def, *store, MUSTER_VERSION,
                                        [&](const SeriesProgress& now) { lines.show(now); });
        if (!status.ok()) return reportFailure(status);
    }
    return kExitOk;
}

}  // namespace

void addStudyModelsCommand(Subcommand& study) {
    Subcommand command = study.add(kStudyModelsCommand.name, kStudyModelsCommand.about);
    auto options = std::make_shared<StudyModelsOptions>();
    command.option("--db", options->db, "The study's database; it is made where it is missing.");
    command
        .option("--seeds", options->series.seeds, "Seeds 1 to this number; each is a pair over all controls.")
        .range(1, kMostSeriesSeeds);
    command.option("--environments", options->series.environments, "Some of them, separated by commas.")
        .separatedBy(',');
    command.option("--schemes", options->series.schemes, "Some control schemes, separated by commas.")
        .separatedBy(',');
    command.option("--crowd", options->series.crowd, "Number of characters; the study has 36, 16 and 100.")
        .range(1, 400);
    command
        .option("--settings", options->settings,
                "Operators' constants: default, equal-motor, one-at-a-time, hypercube, NAME=VALUE, 'draw N'.")
        .separatedBy(',');
    command.flag(
        "--sensitivity", options->sensitivity,
        "One constant at a time and all draws of the hypercube, 5 seeds each, for touch and the full mice.");
    command.option("--threads", options->series.threads, "Trials side by side. Results are the same.")
        .range(1, 256);
    command.option("--shard", options->shard, "Only part NUMBER of OF equal ones: 0/8 to 7/8.");
    command.option("--slurm", options->slurm,
                   "Writes the job file of a Slurm array with as many tasks as --shard says.");
    command
        .option("--merge", options->merge,
                "Copies the trials of another database into --db; may be repeated.")
        .oneValueEach();
    command.flag("--tuning", options->tuning,
                 "Prints medians of trials with tuning seeds, which are never kept and in no report.");
    command.footer(
        "Trials that are there are not run again: a series that was cut off goes on. Operator models are no "
        "people.\n"
        "Examples:\n"
        "  muster study models --seeds 50 --db study.db\n"
        "  muster study models --sensitivity --db study.db\n"
        "  muster study models --seeds 50 --db study.db --shard 0/40 --slurm study.sh && sbatch study.sh\n"
        "  muster study models --tuning --seeds 4 --environments corridor --schemes touch,mouse-full-free");
    command.run([options] { return studyModels(*options); });
}

}  // namespace muster
