#include "lab/study/series/trial_series.h"

#include <atomic>
#include <mutex>

#include "base/parallel.h"
#include "base/stopwatch.h"

namespace muster {
namespace {

constexpr const char* kNote = "operator models";

Status checkNumbers(const SeriesDef& def) {
    if (def.seeds < 1 || def.seeds > kMostSeriesSeeds)
        return invalidArgument("found " + std::to_string(def.seeds) + " seeds, expected 1 to " +
                               std::to_string(kMostSeriesSeeds));
    if (def.shards < 1 || def.shard < 0 || def.shard >= def.shards)
        return invalidArgument("found shard " + std::to_string(def.shard) + " of " +
                               std::to_string(def.shards) + ", expected 0 to one less than their number");
    return {};
}

StudyTrial storedTrial(std::int64_t run, const SeriesTrial& trial, const ModelTrial& done) {
    return {.run = run,
            .def = trial.def,
            .setting = trial.setting,
            .state = RunState::Complete,
            .result = done.result,
            .misses = done.misses,
            .operatorSeconds = done.operatorSeconds};
}

Status keep(StudyStore& store, std::int64_t run, const SeriesTrial& trial, const ModelTrial& done,
            bool inputs) {
    return store.batch([&]() -> Status {
        const auto id = store.addTrial(storedTrial(run, trial, done));
        if (!id.ok()) return id.status();
        if (!inputs) return {};
        if (Status s = store.addInputs(*id, done.inputs); !s.ok()) return s;
        std::vector<StudyDecision> decisions;
        for (const ModelDecision& decision : done.decisions)
            decisions.push_back({decision.step, decision.kind, decision.seconds, decision.text});
        return store.addDecisions(*id, decisions);
    });
}

/// The run of models of these versions, made where there is none.
Result<StudyRun> runOf(StudyStore& store, const StudyRun& wanted) {
    StudyRun found = wanted;
    const Status status = store.batch([&]() -> Status {
        const auto runs = store.runs();
        if (!runs.ok()) return runs.status();
        for (const StudyRun& run : *runs) {
            const bool same = run.kind == RunKind::Models && run.version == wanted.version &&
                              run.environments == wanted.environments && run.operators == wanted.operators;
            if (!same) continue;
            found = run;
            return {};
        }
        const auto id = store.addRun(wanted);
        if (!id.ok()) return id.status();
        found.id = *id;
        return {};
    });
    if (!status.ok()) return status;
    return found;
}

TrialKey keyOf(const SeriesTrial& trial) {
    return {RunKind::Models, kEnvironmentVersion, kOperatorVersion, trial.def, trial.setting};
}

Result<std::vector<SeriesTrial>> missingTrials(const std::vector<SeriesTrial>& all, StudyStore& store) {
    std::vector<SeriesTrial> missing;
    for (const SeriesTrial& trial : all) {
        const auto there = store.hasTrial(keyOf(trial));
        if (!there.ok()) return there.status();
        if (!*there) missing.push_back(trial);
    }
    return missing;
}

/// Runs trials side by side; `done` is called for one at a time.
Status runAll(const std::vector<SeriesTrial>& trials, std::int32_t threads,
              const std::function<Status(const SeriesTrial&, const ModelTrial&)>& done) {
    std::mutex mutex;
    std::atomic<bool> failed = false;
    Status status;
    ThreadPool pool(threads);
    pool.run(static_cast<std::int32_t>(trials.size()), [&](std::int32_t item, std::int32_t) {
        if (failed) return;
        const SeriesTrial& trial = trials[static_cast<std::size_t>(item)];
        const auto result = runModelTrial(trial.def, trial.setting);
        const std::scoped_lock lock(mutex);
        const Status now = result.ok() ? done(trial, *result) : result.status();
        if (now.ok() || failed) return;
        failed = true;
        status = now;
    });
    return status;
}

}  // namespace

Result<std::vector<std::string>> seriesSettings(const std::string& word) {
    if (word == "one-at-a-time") return oneAtATimeSettings();
    if (word == "hypercube") {
        std::vector<std::string> draws;
        for (std::int32_t row = 0; row < kHypercubeDraws; ++row)
            draws.push_back("draw " + std::to_string(row));
        return draws;
    }
    if (const auto setting = operatorSetting(word); !setting.ok()) return setting.status();
    return std::vector<std::string>{word};
}

Result<std::vector<SeriesTrial>> seriesTrials(const SeriesDef& def) {
    if (Status s = checkNumbers(def); !s.ok()) return s;
    std::vector<std::string> environments = def.environments;
    std::vector<std::string> schemes = def.schemes;
    if (environments.empty())
        for (const StudyEnvironment& environment : studyEnvironments())
            environments.emplace_back(environment.name);
    if (schemes.empty())
        for (const NamedScheme& scheme : namedSchemes()) schemes.emplace_back(scheme.name);
    for (const std::string& name : environments) {
        const auto environment = studyEnvironment(name);
        if (!environment.ok()) return environment.status();
        if (const auto world = studyWorld(*environment, def.crowd, 1, false); !world.ok())
            return world.status();
    }
    for (const std::string& name : schemes)
        if (const auto scheme = namedScheme(name); !scheme.ok()) return scheme.status();
    for (const std::string& setting : def.settings)
        if (const auto parameters = operatorSetting(setting); !parameters.ok()) return parameters.status();
    std::vector<SeriesTrial> trials;
    std::int32_t number = 0;
    const std::uint64_t first = def.tuning ? kFirstTuningSeed : 1;
    for (std::int32_t seed = 0; seed < def.seeds; ++seed)
        for (const std::string& setting : def.settings)
            for (const std::string& environment : environments)
                for (const std::string& scheme : schemes) {
                    if (number++ % def.shards != def.shard) continue;
                    trials.push_back(
                        {{environment, def.crowd, scheme, first + static_cast<std::uint64_t>(seed), false},
                         setting});
                }
    return trials;
}

Status runSeries(const SeriesDef& def, StudyStore& store, const std::string& version,
                 const std::function<void(const SeriesProgress&)>& progress) {
    if (def.tuning) return invalidArgument("trials with tuning seeds are never kept");
    const auto all = seriesTrials(def);
    if (!all.ok()) return all.status();
    StudyRun wanted{.version = version,
                    .environments = kEnvironmentVersion,
                    .operators = kOperatorVersion,
                    .note = kNote};
    auto run = runOf(store, wanted);
    if (!run.ok()) return run.status();
    const auto missing = missingTrials(*all, store);
    if (!missing.ok()) return missing.status();
    SeriesProgress now{all->size() - missing->size(), all->size(), -1.0};
    progress(now);
    const Stopwatch watch;
    std::size_t count = 0;
    const Status status = runAll(
        *missing, def.threads, [&](const SeriesTrial& trial, const ModelTrial& done) {
            if (Status s = keep(store, run->id, trial, done, def.keepInputs); !s.ok()) return s;
            ++now.done;
            ++count;
            const double each = watch.milliseconds() / 1000.0 / static_cast<double>(count);
            now.secondsLeft = each * static_cast<double>(now.of - now.done);
            progress(now);
            return Status();
        });
    if (!status.ok()) return status;
    run->state = RunState::Complete;
    return store.updateRun(*run);
}

Status trySeries(const SeriesDef& def,
                 const std::function<void(const SeriesTrial&, const ModelTrial&)>& done) {
    const auto all = seriesTrials(def);
    if (!all.ok()) return all.status();
    return runAll(*all, def.threads, [&](const SeriesTrial& trial, const ModelTrial& result) {
        done(trial, result);
        return Status();
    });
}

Status mergeSeries(StudyStore& from, StudyStore& into) {
    const auto runs = from.runs();
    if (!runs.ok()) return runs.status();
    for (const StudyRun& source : *runs) {
        if (source.kind != RunKind::Models) continue;
        auto run = runOf(into, source);
        if (!run.ok()) return run.status();
        const auto trials = from.trials(source.id);
        if (!trials.ok()) return trials.status();
        for (StudyTrial trial : *trials) {
            if (trial.state != RunState::Complete) continue;
            const auto there = into.hasTrial(
                {RunKind::Models, source.environments, source.operators, trial.def, trial.setting});
            if (!there.ok()) return there.status();
            if (*there) continue;
            const auto inputs = from.inputs(trial.id);
            if (!inputs.ok()) return inputs.status();
            const auto decisions = from.decisions(trial.id);
            if (!decisions.ok()) return decisions.status();
            trial.run = run->id;
            const Status copied = into.batch([&]() -> Status {
                const auto id = into.addTrial(trial);
                if (!id.ok()) return id.status();
                if (Status s = into.addInputs(*id, *inputs); !s.ok()) return s;
                return into.addDecisions(*id, *decisions);
            });
            if (!copied.ok()) return copied;
        }
        if (source.state != RunState::Complete) continue;
        run->state = RunState::Complete;
        if (Status s = into.updateRun(*run); !s.ok()) return s;
    }
    return {};
}

}  // namespace muster
