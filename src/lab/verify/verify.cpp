#include "lab/verify/verify.h"

#include <algorithm>
#include <atomic>
#include <map>
#include <mutex>
#include <optional>
#include <set>

#include "base/parallel.h"
#include "base/stopwatch.h"
#include "files/report/markup.h"

namespace muster {
namespace {

constexpr std::size_t kMostPictures = 6;  // Greatest number of pictures of a row.

/// The id in plain letters: "RiMEA 4" becomes "rimea4".
std::string plainId(const std::string& id) {
    std::string plain;
    for (const char c : lowerCase(id))
        if (c != ' ' && c != '-' && c != '_') plain += c;
    return plain;
}

struct VerifyJob {
    const SceneDef* scene = nullptr;
    SceneRun run;
    std::optional<Result<VerifySample>> sample;
};

std::int32_t seedsOf(const RowDef& row, const VerifyDef& def) {
    return def.seeds > 0 ? def.seeds : def.brief ? row.briefSeeds : row.seeds;
}

/// All runs that some row looks at, each once; long scenes first.
Result<std::vector<VerifyJob>> jobsFor(const std::vector<RowDef>& rows, const VerifyDef& def,
                                       const std::vector<SceneDef>& scenes) {
    std::map<std::pair<std::string, std::string>, std::int32_t> wanted;
    std::vector<std::pair<std::string, std::string>> order;
    for (const RowDef& row : rows)
        for (const std::string& variant : row.variants) {
            const auto key = std::pair{row.scene, variant};
            if (!wanted.contains(key)) order.push_back(key);
            wanted[key] = std::max(wanted[key], seedsOf(row, def));
        }
    std::vector<VerifyJob> jobs;
    for (const auto& key : order) {
        const auto scene = std::find_if(scenes.begin(), scenes.end(),
                                        [&](const SceneDef& s) { return s.id == key.first; });
        if (scene == scenes.end()) return Status(StatusCode::NotFound, "there is no scene " + key.first);
        for (std::int32_t seed = 1; seed <= wanted[key]; ++seed)
            jobs.push_back({&*scene, {key.second, static_cast<std::uint64_t>(seed), seed == 1}, {}});
    }
    std::stable_sort(jobs.begin(), jobs.end(),
                     [](const VerifyJob& a, const VerifyJob& b) { return a.scene->cost > b.scene->cost; });
    return jobs;
}

Status runJobs(std::vector<VerifyJob>& jobs, std::int32_t threads, const VerifyProgress& progress) {
    double all = 0.0, done = 0.0;
    for (const VerifyJob& job : jobs) all += job.scene->cost;
    std::mutex mutex;
    std::atomic<bool> failed = false;
    ThreadPool pool(threads);
    pool.run(static_cast<std::int32_t>(jobs.size()), [&](std::int32_t item, std::int32_t) {
        VerifyJob& job = jobs[item];
        if (failed) return;
        job.sample = job.scene->run(job.run);
        if (!job.sample->ok()) failed = true;
        const std::lock_guard lock(mutex);
        done += job.scene->cost;
        if (progress)
            progress(done / all,
                     job.scene->id + " " + job.run.variant + " seed " + std::to_string(job.run.seed));
    });
    for (const VerifyJob& job : jobs)
        if (job.sample && !job.sample->ok())
            return job.sample->status().within("scene " + job.scene->id + " " + job.run.variant);
    return {};
}

/// The runs that a row looks at.
VerifySamples samplesOf(const RowDef& row, std::int32_t seeds, const std::vector<VerifyJob>& jobs) {
    VerifySamples samples;
    for (const std::string& variant : row.variants)
        for (const VerifyJob& job : jobs)
            if (job.scene->id == row.scene && job.run.variant == variant &&
                job.run.seed <= static_cast<std::uint64_t>(seeds))
                samples.add(variant, **job.sample);
    return samples;
}

RowResult judged(const RowDef& row, const VerifyDef& def, const std::vector<VerifyJob>& jobs) {
    RowResult result{.row = row};
    if (!row.missing.empty()) {
        result.outcome = Outcome::Missing;
        return result;
    }
    result.seeds = seedsOf(row, def);
    const VerifySamples samples = samplesOf(row, result.seeds, jobs);
    row.judge(samples, result.report);
    const auto& checks = result.report.checks;
    const bool good = std::all_of(checks.begin(), checks.end(),
                                  [](const VerifyCheck& c) { return !c.binding || c.pass(); });
    const bool any = std::any_of(checks.begin(), checks.end(),
                                 [](const VerifyCheck& c) { return c.binding; });
    result.outcome = good && any ? Outcome::Pass : Outcome::Fail;
    for (const std::string& variant : row.variants) {
        const auto& runs = samples.runs(variant);
        if (runs.empty() || runs.front().picture.empty() || result.pictures.size() == kMostPictures) continue;
        result.pictures.push_back(runs.front().picture);
        result.pictureTitles.push_back(variant);
    }
    return result;
}

}  // namespace

std::size_t Verification::count(Outcome outcome) const {
    return static_cast<std::size_t>(std::count_if(
        rows.begin(), rows.end(), [outcome](const RowResult& row) { return row.outcome == outcome; }));
}

const char* outcomeName(Outcome outcome) {
    return outcome == Outcome::Pass ? "pass" : outcome == Outcome::Fail ? "fail" : "missing";
}

const char* whoseName(Whose whose) {
    return whose == Whose::Standard ? "standard" : whose == Whose::Own ? "[own]" : "data";
}

Result<std::vector<RowDef>> chosenRows(const VerifyDef& def, const std::vector<RowDef>& rows) {
    std::set<std::string> wanted;
    for (const std::string& text : def.only) {
        const std::string plain = plainId(text);
        const bool known = std::any_of(rows.begin(), rows.end(), [&](const RowDef& row) {
            return plainId(row.id) == plain || plainId(row.suite) == plain;
        });
        if (!known) {
            std::string suites;
            for (const RowDef& row : rows)
                if (suites.find(row.suite) == std::string::npos)
                    suites += (suites.empty() ? "" : ", ") + row.suite;
            return Status(StatusCode::NotFound, "found the test \"" + text.substr(0, 40) +
                                                    "\", expected one as \"" + rows.front().id +
                                                    "\", or all of " + suites);
        }
        wanted.insert(plain);
    }
    std::vector<RowDef> chosen;
    for (const RowDef& row : rows) {
        const bool named = wanted.contains(plainId(row.id)) || wanted.contains(plainId(row.suite));
        if ((wanted.empty() || named) && (!def.brief || row.briefSeeds > 0 || !row.missing.empty()))
            chosen.push_back(row);
    }
    return chosen;
}

Result<Verification> verifyRowsOf(const VerifyDef& def, const std::vector<RowDef>& rows,
                                  const std::vector<SceneDef>& scenes, const VerifyProgress& progress) {
    if (def.seeds < 0 || def.seeds > 1000)
        return invalidArgument("found " + std::to_string(def.seeds) + " seeds, expected 1 to 1000");
    const auto chosen = chosenRows(def, rows);
    if (!chosen.ok()) return chosen.status();
    const Stopwatch watch;
    auto jobs = jobsFor(*chosen, def, scenes);
    if (!jobs.ok()) return jobs.status();
    if (Status s = runJobs(*jobs, def.threads, progress); !s.ok()) return s;
    Verification verification;
    for (const RowDef& row : *chosen) verification.rows.push_back(judged(row, def, *jobs));
    verification.seconds = watch.milliseconds() / 1000.0;
    return verification;
}

Result<Verification> verify(const VerifyDef& def, const VerifyProgress& progress) {
    return verifyRowsOf(def, verifyRows(), verifyScenes(), progress);
}

}  // namespace muster
