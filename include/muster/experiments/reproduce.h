// Runs experiments and writes the report.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include "muster/base/status.h"
#include "muster/experiments/experiment.h"

namespace muster {

/// What is to be reproduced.
struct ReproduceDef {
    std::vector<std::string> experiments;  ///< "X4"...; empty for all.
    std::int32_t seeds = 10;               ///< Runs of each arm, 1 to 1,000.
    std::int32_t threads = 0;              ///< Runs side by side; 0 takes what the machine has. Changes no result.
    std::string folder;                    ///< Of the paper's scenarios.
    std::vector<std::pair<std::string, double>> settings = {};  ///< Parameters by name; what an arm sets itself stays.
};

/// An experiment as it came out.
struct ExperimentResult {
    ExperimentText text;
    std::vector<Arm> arms;
    std::vector<FigureInfo> figures;
    Samples samples;
    std::vector<Verdict> verdicts;
    std::vector<ChartDef> charts;
};

/// All of them, in their order.
struct Reproduction {
    std::vector<ExperimentResult> experiments;
    std::int32_t seeds = 0;   ///< Of each arm.
    double seconds = 0.0;     ///< Wall time it took [s].
    /// True where no binding criterion failed.
    bool passed() const;
};

/// Runs them. `progress(done, of, what)` is called from one thread at a time. Fails naming an unknown experiment, or
/// the scenario that cannot be run.
Result<Reproduction> reproduce(const ReproduceDef& def,
                               const std::function<void(std::int32_t done, std::int32_t of, const std::string& what)>& progress);

/// DIR/results.json: an array of {experiment, criterion, preset, value, threshold, pass, seeds, low, high}.
std::string resultsJson(const Reproduction& reproduction);
/// DIR/index.html: one file that needs no other.
std::string reportHtml(const Reproduction& reproduction);
/// DIR/summary.md: the table of criteria for other documents.
std::string summaryMarkdown(const Reproduction& reproduction);
/// Writes these, and one SVG document per film strip (DIR/x4-film.svg), into a folder that is made where it is not
/// there. Fails with IoError.
Status writeReport(const Reproduction& reproduction, const std::string& folder);

}  // namespace muster
