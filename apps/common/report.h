// Results and messages of the commands, as text and as JSON.
#pragma once

#include <string>

#include "base/stopwatch.h"
#include "engine/world/metrics.h"
#include "json/json.h"
#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// The results by the names that docs/scenario-format.md and `muster play --help` list. Times that were not
/// reached are null.
Json figuresJson(const RunFigures& figures);
/// Prints the results as lines of text on standard output, the mean time of every stage of a step if
/// `timings`.
void printFigures(const RunFigures& figures, bool timings = false);
/// Formats as "12.3", or as "-" where negative.
std::string timeText(double seconds);
/// Date and time to the minute, in UTC.
std::string minuteNow();
/// Prints one JSON value on standard output.
void printJsonValue(const Json& value);
/// Prints one sentence on standard error; returns kExitFailure.
int reportFailure(const Status& status);
/// Prints the first few warnings about a scenario on standard error, and the number of the others.
void printWarnings(const WorldDef& def, const std::string& path);

/// A progress line on standard error that is rewritten during long work. It is silent where standard error is
/// no terminal.
class Progress {
public:
    /// `what` precedes the percentage.
    explicit Progress(std::string what);
    ~Progress();
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;
    /// Shows the completed share and the present activity, at most a few times per second and not within the
    /// first second.
    void show(double share, const std::string& detail = {});

private:
    std::string what_;
    double last_ = 0.0;
    bool shown_ = false;
    bool terminal_ = false;
    Stopwatch watch_;
};

}  // namespace muster
