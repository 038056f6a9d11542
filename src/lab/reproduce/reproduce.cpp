#include "lab/reproduce/reproduce.h"

#include <algorithm>
#include <atomic>
#include <filesystem>
#include <mutex>
#include <optional>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "files/report/markup.h"

namespace muster {
namespace {

/// One run and its results.
struct Job {
    std::size_t experiment = 0;
    RunRequest request;
    std::optional<Result<RunSample>> sample;
};

using Experiments = std::vector<std::unique_ptr<Experiment>>;

/// The requested experiments, in the paper's order.
Result<Experiments> choose(const std::vector<std::string>& wanted) {
    Experiments all = paperExperiments();
    std::string known;
    for (const auto& experiment : all) known += (known.empty() ? "" : ", ") + experiment->text().id;
    for (const std::string& id : wanted) {
        const bool found = std::any_of(all.begin(), all.end(), [&](const auto& experiment) {
            return lowerCase(experiment->text().id) == lowerCase(id);
        });
        if (!found)
            return Status(StatusCode::NotFound,
                          "found the experiment \"" + id.substr(0, 40) + "\", expected some of " + known);
    }
    if (wanted.empty()) return all;
    Experiments chosen;
    for (auto& experiment : all) {
        const std::string id = lowerCase(experiment->text().id);
        if (std::any_of(wanted.begin(), wanted.end(),
                        [&](const std::string& w) { return lowerCase(w) == id; }))
            chosen.push_back(std::move(experiment));
    }
    return chosen;
}

/// All runs. The first seed of every experiment goes first, so that an experiment that cannot run is found
/// early; then come the other seeds, experiment by experiment.
std::vector<Job> jobsOf(const Experiments& experiments, const ReproduceDef& def, bool timed) {
    std::vector<Job> jobs;
    const auto add = [&](std::size_t e, std::int32_t from, std::int32_t to) {
        if (experiments[e]->timed() != timed) return;
        for (std::int32_t seed = from; seed <= to; ++seed)
            for (const Arm& arm : experiments[e]->arms())
                jobs.push_back(
                    {e, {arm, static_cast<std::uint64_t>(seed), seed == 1, def.folder, def.settings}, {}});
    };
    for (std::size_t e = 0; e < experiments.size(); ++e) add(e, 1, 1);
    for (std::size_t e = 0; e < experiments.size(); ++e) add(e, 2, def.seeds);
    return jobs;
}

using Progress = std::function<void(const ReproduceProgress&)>;

/// Makes the runs and reports the progress. Once a run has failed no other begins.
class Runner {
public:
    Runner(const Experiments& experiments, const ReproduceDef& def, const Progress& watch)
        : experiments_(experiments), def_(def), watch_(watch), done_(experiments.size(), 0) {
        for (const auto& experiment : experiments_) all_ += runsOf(*experiment);
    }

    void make(Job& job) {
        if (failed_) return;
        const Experiment& experiment = *experiments_[job.experiment];
        job.sample = experiment.run(job.request);
        if (!job.sample->ok()) failed_ = true;
        const std::lock_guard lock(mutex_);
        ++doneInAll_;
        ++done_[job.experiment];
        const ExperimentText text = experiment.text();
        if (watch_ && !failed_)
            watch_({doneInAll_, all_, text.id, text.title, job.request.arm.title, done_[job.experiment],
                    runsOf(experiment)});
    }

private:
    std::int32_t runsOf(const Experiment& experiment) const {
        return static_cast<std::int32_t>(experiment.arms().size()) * def_.seeds;
    }

    const Experiments& experiments_;
    const ReproduceDef& def_;
    const Progress& watch_;
    std::mutex mutex_;
    std::vector<std::int32_t> done_;  // Runs done, by experiment.
    std::int32_t doneInAll_ = 0;
    std::int32_t all_ = 0;
    std::atomic<bool> failed_ = false;
};

ExperimentResult summarise(const Experiment& experiment, std::size_t seeds, Samples samples) {
    ExperimentResult result{.text = experiment.text(),
                            .arms = experiment.arms(),
                            .figures = experiment.figures(),
                            .samples = std::move(samples)};
    Judge judge(seeds);
    experiment.judge(result.samples, judge);
    result.verdicts = judge.verdicts();
    result.charts = experiment.charts(result.samples);
    return result;
}

}  // namespace

bool Reproduction::passed() const {
    for (const ExperimentResult& experiment : experiments)
        for (const Verdict& verdict : experiment.verdicts)
            if (verdict.binding && !verdict.pass) return false;
    return true;
}

Status checkReproduce(const ReproduceDef& def) {
    if (def.seeds < 1 || def.seeds > 1000)
        return invalidArgument("found " + std::to_string(def.seeds) + " seeds, expected 1 to 1000");
    auto chosen = choose(def.experiments);
    if (!chosen.ok()) return chosen.status();
    std::error_code error;
    if (!std::filesystem::is_directory(def.folder, error))
        return {StatusCode::NotFound,
                def.folder + ": found no such folder, expected the one with the paper's scenarios"};
    for (const auto& experiment : *chosen) {
        const ExperimentText text = experiment->text();
        const std::string path = def.folder + "/" + text.scenario + ".json";
        if (!text.scenario.empty() && !std::filesystem::is_regular_file(path, error))
            return {StatusCode::NotFound, path + ": found no such file, expected the scenario of " + text.id};
    }
    return {};
}

Result<Reproduction> reproduce(const ReproduceDef& def,
                               const std::function<void(const ReproduceProgress&)>& progress) {
    if (Status s = checkReproduce(def); !s.ok()) return s;
    const Experiments experiments = std::move(choose(def.experiments)).value();
    const Stopwatch watch;
    std::vector<Job> jobs = jobsOf(experiments, def, false), timed = jobsOf(experiments, def, true);
    Runner runner(experiments, def, progress);
    ThreadPool pool(def.threads);
    pool.run(static_cast<std::int32_t>(jobs.size()),
             [&](std::int32_t item, std::int32_t) { runner.make(jobs[item]); });
    for (Job& job : timed) runner.make(job);

    for (const std::vector<Job>* list : {&jobs, &timed})
        for (const Job& job : *list)
            if (job.sample && !job.sample->ok())
                return job.sample->status().within(experiments[job.experiment]->text().id);
    std::vector<Samples> samples(experiments.size());
    for (std::vector<Job>* list : {&jobs, &timed})
        for (Job& job : *list)
            samples[job.experiment].add(job.request.arm.id, job.request.arm.preset,
                                        std::move(*job.sample).value());
    Reproduction result{.seeds = def.seeds};
    for (std::size_t e = 0; e < experiments.size(); ++e)
        result.experiments.push_back(
            summarise(*experiments[e], static_cast<std::size_t>(def.seeds), std::move(samples[e])));
    result.seconds = watch.milliseconds() / 1000.0;
    return result;
}

}  // namespace muster
