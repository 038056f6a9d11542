// The parts of a sweep: one value with one experiment each. They can be run on several machines and
// collected.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

#include "json/json.h"
#include "lab/reproduce/reproduce.h"
#include "muster/status.h"

namespace muster {

/// A parameter with its values, and what is run with each.
struct SweepPlan {
    std::string parameter;
    std::vector<double> values;
    std::vector<std::string> experiments;  ///< Ids: "X4"...
    std::int32_t seeds = 3;

    /// The number of parts: every value with every experiment, values first.
    std::size_t parts() const { return values.size() * experiments.size(); }
    double valueOf(std::size_t part) const { return values[part / experiments.size()]; }
    const std::string& experimentOf(std::size_t part) const { return experiments[part % experiments.size()]; }

    friend bool operator==(const SweepPlan&, const SweepPlan&) = default;
};

/// A row of the table: its title, then its value for each setting.
struct SweepRow {
    std::string title;
    std::vector<std::string> cells;
};

/// Everything of a sweep.
struct SweepResults {
    std::vector<SweepRow> rows;
    Json entries = Json::array();  ///< Of results.json, each with the parameter's value.

    /// Adds the results of a value: a column.
    void add(const SweepPlan& plan, double value, const Reproduction& reproduction);
};

/// The text of one part's file.
std::string sweepPartText(const SweepPlan& plan, std::size_t part, const SweepResults& results);
/// Puts the parts of a folder together, in the order in which one machine runs them. Fails naming the file
/// that is missing, cannot be read, or is of another sweep.
Result<SweepResults> collectSweep(const std::string& folder, SweepPlan& plan);
/// A job array for Slurm: each task runs one part. `program` and `scenarios` are paths; parts are written
/// into `folder`.
std::string slurmScript(const SweepPlan& plan, const std::string& program, const std::string& scenarios,
                        const std::string& folder);

/// The first lines of a job array of so many tasks, each on one core. `about` are comments, each line with
/// its
/// "# " and its end.
inline std::string slurmHead(const std::string& about, const std::string& name, std::size_t tasks) {
    std::string text = "#!/bin/bash\n" + about;
    text += "#SBATCH --job-name=" + name + "\n";
    text += "#SBATCH --array=0-" + std::to_string(tasks - 1) + "\n";
    text +=
        "#SBATCH --ntasks=1\n"
        "#SBATCH --cpus-per-task=1\n";
    return text;
}

}  // namespace muster
