// A series of trials of operator models: its list, the run of missing trials, their storage.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/study/models/model_trial.h"
#include "studio/study/store/store.h"

namespace muster {

/// Greatest number of seeds of a series; seeds of people and of tuning come after them.
inline constexpr std::int32_t kMostSeriesSeeds = 100000;

/// The trials of a series: all combinations.
struct SeriesDef {
    std::int32_t seeds = 50;                ///< Number of seeds, which are 1 to this, [1, kMostSeriesSeeds].
    std::vector<std::string> environments;  ///< Names of environments; empty for all.
    std::vector<std::string> schemes;       ///< Names of schemes; empty for all.
    std::vector<std::string> settings{"default"};  ///< Settings of the operators (operator_parameters.h).
    std::int32_t crowd = 36;                       ///< Number of characters.
    bool tuning = false;       ///< Whether seeds begin at kFirstTuningSeed, whose trials are never kept.
    std::int32_t shard = 0;    ///< Number of the part of the trials that is run, [0, shards).
    std::int32_t shards = 1;   ///< Number of parts into which the trials are cut, >= 1.
    std::int32_t threads = 2;  ///< Number of trials side by side; results are the same.
    bool keepInputs = true;    ///< Whether inputs and decisions are kept, not only results.
};

/// One trial of a series.
struct SeriesTrial {
    TrialDef def;         ///< Definition of the trial.
    std::string setting;  ///< Settings of the operator.
};

/// Progress of a series.
struct SeriesProgress {
    std::size_t done = 0;      ///< Number of trials that were there or have been run.
    std::size_t of = 0;        ///< Number of all trials.
    double secondsLeft = 0.0;  ///< Estimated time until all are done [s]; negative before there is one.
};

/// The trials of a series, in the order in which they are run: seed by seed, so that what is there at any
/// time is balanced. Fails where a name is unknown or a number out of range.
Result<std::vector<SeriesTrial>> seriesTrials(const SeriesDef& def);
/// The operators' settings that a word names: "default", "equal-motor", "one-at-a-time", "hypercube", or one
/// setting itself.
Result<std::vector<std::string>> seriesSettings(const std::string& word);

/// Runs those trials that the store does not have, and keeps each as it ends. All series of the same versions
/// share one run of the store, so that shards that write one file give what one series gives. `version`: of
/// Muster. Fails for tuning seeds: no report may have them.
Status runSeries(const SeriesDef& def, StudyStore& store, const std::string& version,
                 const std::function<void(const SeriesProgress&)>& progress);
/// Runs all trials and gives each to `done` in any order, one at a time; nothing is kept.
Status trySeries(const SeriesDef& def,
                 const std::function<void(const SeriesTrial&, const ModelTrial&)>& done);
/// Copies all runs of models of another database, except trials that are there.
Status mergeSeries(StudyStore& from, StudyStore& into);

}  // namespace muster
