// Figures and messages of the commands, for people and as JSON.
#pragma once

#include <string>

#include "base/json.h"
#include "base/stopwatch.h"
#include "muster/status.h"
#include "muster/world_def.h"
#include "world/metrics.h"

namespace muster {

/// The figures by the names that docs/scenario-format.md and `muster play --help` list; unreached times are
/// null.
Json figuresJson(const RunFigures& figures);
/// The same as lines of text on standard output.
void printFigures(const RunFigures& figures);
/// "12.3", or "-" below zero.
std::string timeText(double seconds);
/// One JSON value on standard output.
void printJsonValue(const Json& value);
/// One sentence on standard error; returns kExitFailure.
int reportFailure(const Status& status);
/// What is likely a mistake in a scenario, on standard error: the first few warnings, and how many more there
/// are.
void printWarnings(const WorldDef& def, const std::string& path);

/// A line on standard error that is rewritten as long work goes on; silent where standard error is no
/// terminal.
class Progress {
public:
    /// `what` stands before the percentage.
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Shows the share that is done and what is done just now, at most a few times a second and not within
    /// the first second.
    void show(double share, const std::string& detail = {});

private:
    std::string what_;
    double last_ = 0.0;
    bool shown_ = false;
    bool terminal_ = false;
    Stopwatch watch_;
};

}  // namespace muster
