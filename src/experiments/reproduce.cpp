#include "muster/experiments/reproduce.h"

#include <algorithm>
#include <cctype>
#include <mutex>
#include <optional>

#include "muster/base/parallel.h"
#include "muster/base/stopwatch.h"

namespace muster {
namespace {

/// One run that is to be made, and what it gave.
struct Job {
    std::size_t experiment = 0;
    RunRequest request;
    std::optional<Result<RunSample>> sample;
};

using Experiments = std::vector<std::unique_ptr<Experiment>>;

std::string lower(std::string text) {
    for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return text;
}

/// Those asked for, in the paper's order.
Result<Experiments> choose(const std::vector<std::string>& wanted) {
    Experiments all = paperExperiments();
    std::string known;
    for (const auto& experiment : all) known += (known.empty() ? "" : ", ") + experiment->text().id;
    for (const std::string& id : wanted) {
        const bool found = std::any_of(all.begin(), all.end(),
                                       [&](const auto& experiment) { return lower(experiment->text().id) == lower(id); });
        if (!found)
            return Status(StatusCode::NotFound, "found the experiment \"" + id.substr(0, 40) + "\", expected some of " + known);
    }
    if (wanted.empty()) return all;
    Experiments chosen;
    for (auto& experiment : all) {
        const std::string id = lower(experiment->text().id);
        if (std::any_of(wanted.begin(), wanted.end(), [&](const std::string& w) { return lower(w) == id; }))
            chosen.push_back(std::move(experiment));
    }
    return chosen;
}

/// The long ones of each experiment first would need their times; seeds outermost spreads every experiment evenly.
std::vector<Job> jobsOf(const Experiments& experiments, const ReproduceDef& def, bool timed) {
    std::vector<Job> jobs;
    for (std::int32_t seed = 1; seed <= def.seeds; ++seed) {
        for (std::size_t e = 0; e < experiments.size(); ++e) {
            if (experiments[e]->timed() != timed) continue;
            for (const Arm& arm : experiments[e]->arms())
                jobs.push_back({e, {arm, static_cast<std::uint64_t>(seed), seed == 1, def.folder, def.settings}, {}});
        }
    }
    return jobs;
}

ExperimentResult summarise(const Experiment& experiment, std::size_t seeds, Samples samples) {
    ExperimentResult result;
    result.text = experiment.text();
    result.arms = experiment.arms();
    result.figures = experiment.figures();
    result.samples = std::move(samples);
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

Result<Reproduction> reproduce(const ReproduceDef& def,
                               const std::function<void(std::int32_t, std::int32_t, const std::string&)>& progress) {
    if (def.seeds < 1 || def.seeds > 1000)
        return invalidArgument("found " + std::to_string(def.seeds) + " seeds, expected 1 to 1000");
    auto chosen = choose(def.experiments);
    if (!chosen.ok()) return chosen.status();
    const Experiments& experiments = *chosen;
    const Stopwatch watch;
    std::vector<Job> jobs = jobsOf(experiments, def, false), timed = jobsOf(experiments, def, true);
    const auto total = static_cast<std::int32_t>(jobs.size() + timed.size());
    std::mutex mutex;
    std::int32_t done = 0;
    const auto make = [&](Job& job) {
        const Experiment& experiment = *experiments[job.experiment];
        job.sample = experiment.run(job.request);
        const std::lock_guard lock(mutex);
        if (progress) progress(++done, total, experiment.text().id + " " + job.request.arm.title);
    };
    ThreadPool pool(def.threads);
    pool.run(static_cast<std::int32_t>(jobs.size()),
             [&](std::int32_t item, std::int32_t) { make(jobs[static_cast<std::size_t>(item)]); });
    for (Job& job : timed) make(job);

    std::vector<Samples> samples(experiments.size());
    for (std::vector<Job>* list : {&jobs, &timed}) {
        for (Job& job : *list) {
            const std::string id = experiments[job.experiment]->text().id;
            if (!job.sample->ok()) return job.sample->status().within(id);
            samples[job.experiment].add(job.request.arm.id, job.request.arm.preset, std::move(*job.sample).value());
        }
    }
    Reproduction result;
    result.seeds = def.seeds;
    for (std::size_t e = 0; e < experiments.size(); ++e)
        result.experiments.push_back(
            summarise(*experiments[e], static_cast<std::size_t>(def.seeds), std::move(samples[e])));
    result.seconds = watch.milliseconds() / 1000.0;
    return result;
}

}  // namespace muster
