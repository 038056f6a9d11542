// The rows of the table: one test of a standard, or one comparison with data.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/verify/sample.h"

namespace muster {

/// The source of a tolerance.
enum class Whose : std::uint8_t {
    Standard,  ///< A standard that sets it.
    Own,       ///< No standard: it is ours, or that of the project whose test is cited.
    Data,      ///< Measured data from which it follows.
};

/// One thing that is judged: a value that is to lie between two limits, both included.
struct VerifyCheck {
    std::string what;    ///< Name such as "time for 40 m".
    double value = 0.0;  ///< Measured value; kUnmeasured fails.
    double low = 0.0;    ///< Lower limit; -infinity for none.
    double high = 0.0;   ///< Upper limit; infinity for none.
    std::string unit;    ///< Unit such as "s".
    Whose whose = Whose::Standard;
    bool binding = true;  ///< False for a value that is shown for comparison.
    /// True where the value lies between the limits.
    bool pass() const { return value >= low && value <= high; }
};

/// A curve or a cloud of points in a plot.
struct PlotSeries {
    std::string title;
    std::vector<Vec2> points;
    enum class Look : std::uint8_t { Line, Marks, Dots } look = Look::Line;
};

/// A plot: series over a band of expected values.
struct VerifyPlot {
    std::string title, xTitle, yTitle;
    std::vector<PlotSeries> series;
    std::vector<Vec2> bandLow, bandHigh;  ///< Both borders of the band, with the same x; may be empty.
    std::string bandTitle;
};

/// The report of a judge.
struct RowReport {
    std::vector<VerifyCheck> checks;
    std::vector<std::string> notes;  ///< Sentences that stand beside the checks.
    std::vector<VerifyPlot> plots;

    void atMost(const std::string& what, double value, double high, const std::string& unit, Whose whose);
    void atLeast(const std::string& what, double value, double low, const std::string& unit, Whose whose);
    void within(const std::string& what, double value, double low, double high, const std::string& unit,
                Whose whose);
    /// Adds a value for comparison, which decides nothing.
    void shown(const std::string& what, double value, const std::string& unit);
    void note(const std::string& sentence) { notes.push_back(sentence); }
};

/// Definition of a test.
struct RowDef {
    std::string id;        ///< Id such as "RiMEA 4".
    std::string suite;     ///< Suite: "RiMEA", "IMO", "NIST", "ISO" or "Data".
    std::string title;     ///< Title such as "Fundamental diagram".
    std::string source;    ///< Source of the test.
    std::string expected;  ///< Expected result, and the reason for it.
    std::string setup;     ///< Geometry and people.
    std::string scene;     ///< Id of the scene that it looks at; empty for a test that cannot be run.
    std::vector<std::string> variants;
    std::int32_t seeds = 1;  ///< Number of runs of each variant.
    /// Number of runs of each variant in the short set; 0 where it is not part of it.
    std::int32_t briefSeeds = 0;
    std::string missing;  ///< Reason why it cannot be run; empty where it can.
    std::function<void(const VerifySamples&, RowReport&)> judge;
};

/// All tests, by suite and number.
const std::vector<RowDef>& verifyRows();

// Parts of the list, one per file.
std::vector<RowDef> rimeaRows();
std::vector<RowDef> imoRows();
std::vector<RowDef> nistRows();
std::vector<RowDef> isoRows();
std::vector<RowDef> dataRows();

}  // namespace muster
