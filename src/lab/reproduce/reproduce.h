// Runs experiments and writes the report.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "lab/reproduce/experiments/experiment.h"
#include "muster/status.h"

namespace muster {

/// Options of a reproduction.
struct ReproduceDef {
    std::vector<std::string> experiments;  ///< Ids such as "X4"; empty for all.
    std::int32_t seeds = 10;               ///< Number of runs of each arm, 1 to 1,000.
    /// Number of runs at the same time; 0 takes the number of processors. Changes no result.
    std::int32_t threads = 0;
    std::string folder;  ///< Folder of the paper's scenarios.
    /// Parameters by name; a parameter that an arm sets stays.
    std::vector<std::pair<std::string, double>> settings = {};
};

/// Results of one experiment.
struct ExperimentResult {
    ExperimentText text;
    std::vector<Arm> arms;
    std::vector<FigureInfo> figures;
    Samples samples;
    std::vector<Verdict> verdicts;
    std::vector<ChartDef> charts;
};

/// Results of all experiments, in their order.
struct Reproduction {
    std::vector<ExperimentResult> experiments;
    std::int32_t seeds = 0;  ///< Number of runs of each arm.
    double seconds = 0.0;    ///< Wall time of all runs [s].
    std::string version;     ///< Version of the program, for the report; left empty by reproduce().
    std::string when;        ///< Date of the runs, for the report; left empty by reproduce().
    /// True if no binding criterion failed.
    bool passed() const;
};

/// Progress, reported after each run.
struct ReproduceProgress {
    std::int32_t done = 0;            ///< Number of runs of all experiments that are done.
    std::int32_t of = 0;              ///< Number of runs of all experiments.
    std::string experiment;           ///< Id of the experiment whose run has just ended: "X4".
    std::string title;                ///< Title of the experiment.
    std::string arm;                  ///< Title of the run's arm.
    std::int32_t experimentDone = 0;  ///< Number of runs of this experiment that are done.
    std::int32_t experimentOf = 0;    ///< Number of runs of this experiment.
};

/// Checks all that is known before the first run. Fails naming an unknown experiment, the number of seeds, a
/// missing folder or a missing scenario.
Status checkReproduce(const ReproduceDef& def);

/// Runs the experiments. `progress` is called from one thread at a time. Fails as checkReproduce() does, or
/// naming the experiment and the scenario that cannot be run; then no further run begins.
Result<Reproduction> reproduce(const ReproduceDef& def,
                               const std::function<void(const ReproduceProgress&)>& progress);

/// DIR/results.json: an array of {experiment, criterion, preset, value, threshold, pass, binding, seeds, low,
/// high}.
std::string resultsJson(const Reproduction& reproduction);
/// DIR/index.html: one file that needs no other.
std::string reportHtml(const Reproduction& reproduction);
/// DIR/summary.md: the table of criteria for other documents.
std::string summaryMarkdown(const Reproduction& reproduction);
/// The verdicts and the number of criteria that hold, as lines for a terminal or a log.
std::string summaryText(const Reproduction& reproduction);
/// Writes index.html, results.json, summary.md and one SVG document per film strip (DIR/x4-film.svg), into a
/// folder that is created if needed. Fails with IoError.
Status writeReport(const Reproduction& reproduction, const std::string& folder);

}  // namespace muster
