// Runs the standard tests of pedestrian dynamics and reports them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/verify/row.h"
#include "lab/verify/verify_scene.h"
#include "muster/status.h"

namespace muster {

/// The choice of tests and runs.
struct VerifyDef {
    /// Ids such as "RiMEA 4" or "rimea4", or suites such as "NIST"; empty for all.
    std::vector<std::string> only;
    bool brief = false;  ///< Whether only the short set is run.
    /// Number of runs of each variant, 0 to 1,000; 0 for as many as each test asks for.
    std::int32_t seeds = 0;
    std::int32_t threads = 0;  ///< Number of runs at the same time; 0 for all processors. Changes no result.
};

/// The outcome of a row.
enum class Outcome : std::uint8_t {
    Pass,
    Fail,
    Missing,  ///< The row cannot be run here, and counts as not passed.
};

/// A row with its results.
struct RowResult {
    RowDef row;
    RowReport report;
    Outcome outcome = Outcome::Fail;
    std::int32_t seeds = 0;             ///< Number of runs of each variant.
    std::vector<std::string> pictures;  ///< Pictures as SVG documents, by variant.
    std::vector<std::string> pictureTitles;
};

/// The results of all rows.
struct Verification {
    std::vector<RowResult> rows;
    double seconds = 0.0;  ///< Wall time [s].
    std::string version;   ///< Version of the program; left empty by verify().
    std::string when;      ///< Date of the runs; left empty by verify().
    std::string others;    ///< The table beside other programs, as text; left empty by verify().

    std::size_t count(Outcome outcome) const;
    /// True where no row failed.
    bool passed() const { return count(Outcome::Fail) == 0; }
    /// Exit code of the program: 0 where no row failed, else 1. Missing rows fail nothing, and pass nothing.
    int exitCode() const { return passed() ? 0 : 1; }
};

/// Is called with the share of work that is done, 0 to 1, and the name of the run that has just ended.
using VerifyProgress = std::function<void(double, const std::string&)>;

/// The rows that a definition asks for. Fails naming an id that is not known.
Result<std::vector<RowDef>> chosenRows(const VerifyDef& def, const std::vector<RowDef>& rows);

/// Runs the rows that are asked for. Fails as chosenRows() does, or naming the scene that cannot be run.
Result<Verification> verify(const VerifyDef& def, const VerifyProgress& progress = {});
/// Runs other rows and scenes, for tests, as verify() does.
Result<Verification> verifyRowsOf(const VerifyDef& def, const std::vector<RowDef>& rows,
                                  const std::vector<SceneDef>& scenes, const VerifyProgress& progress = {});

/// The table for a terminal, columns aligned: test, expected, measured, outcome, seeds; and the counts.
std::string verificationText(const Verification& verification);
/// The table in Markdown, for documents.
std::string verificationMarkdown(const Verification& verification);
/// An object with `rows`, each with its checks, and the counts.
std::string verificationJson(const Verification& verification);
/// One page that needs no other file.
std::string verificationPage(const Verification& verification);
/// Word such as "pass", "fail" or "missing".
const char* outcomeName(Outcome outcome);
/// Word such as "standard", "[own]" or "data".
const char* whoseName(Whose whose);

}  // namespace muster
