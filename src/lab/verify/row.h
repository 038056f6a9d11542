// The rows of the table: one test of a standard, or one comparison with data.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lab/verify/sample.h"

namespace muster {

/// Whose a tolerance is.
enum class Whose : std::uint8_t {
    Standard,  ///< The standard says so.
    Own,       ///< No standard's: ours, or that of the project whose test is cited.
    Data,      ///< It follows from measured data.
};

/// One thing that is judged: a value that is to lie between two limits, both included.
struct VerifyCheck {
    std::string what;    ///< "time for 40 m"
    double value = 0.0;  ///< kUnmeasured fails.
    double low = 0.0;    ///< -infinity for none.
    double high = 0.0;   ///< infinity for none.
    std::string unit;    ///< "s"
    Whose whose = Whose::Standard;
    bool binding = true;  ///< False: shown for comparison.
    /// True where the value lies between the limits.
    bool pass() const { return value >= low && value <= high; }
};

/// A curve or a cloud of points in a plot.
struct PlotSeries {
    std::string title;
    std::vector<Vec2> points;
    enum class Look : std::uint8_t { Line, Marks, Dots } look = Look::Line;
};

/// A plot: series over a band of what is expected.
struct VerifyPlot {
    std::string title, xTitle, yTitle;
    std::vector<PlotSeries> series;
    std::vector<Vec2> bandLow, bandHigh;  ///< The same x in both; may be empty.
    std::string bandTitle;
};

/// What a judge says.
struct RowReport {
    std::vector<VerifyCheck> checks;
    std::vector<std::string> notes;  ///< Sentences beside the checks.
    std::vector<VerifyPlot> plots;

    void atMost(const std::string& what, double value, double high, const std::string& unit, Whose whose);
    void atLeast(const std::string& what, double value, double low, const std::string& unit, Whose whose);
    void within(const std::string& what, double value, double low, double high, const std::string& unit,
                Whose whose);
    /// A value for comparison, which decides nothing.
    void shown(const std::string& what, double value, const std::string& unit);
    void note(const std::string& sentence) { notes.push_back(sentence); }
};

/// A test.
struct RowDef {
    std::string id;        ///< "RiMEA 4"
    std::string suite;     ///< "RiMEA", "IMO", "NIST", "ISO", "Data"
    std::string title;     ///< "Fundamental diagram"
    std::string source;    ///< Where the test is from.
    std::string expected;  ///< What is expected, and why.
    std::string setup;     ///< Geometry and people.
    std::string scene;     ///< Id of the scene that it looks at; empty for a test that cannot be run.
    std::vector<std::string> variants;
    std::int32_t seeds = 1;       ///< Runs of each variant.
    std::int32_t briefSeeds = 0;  ///< The same in the short set; 0 where it is not part of it.
    std::string missing;          ///< Why it cannot be run; empty where it can.
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
