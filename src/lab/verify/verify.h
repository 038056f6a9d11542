// Runs the standard tests of pedestrian dynamics and reports them.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "lab/verify/row.h"
#include "lab/verify/scene.h"
#include "muster/status.h"

namespace muster {

/// What is run.
struct VerifyDef {
    std::vector<std::string> only;  ///< "RiMEA 4", "rimea4", or a suite: "NIST"; empty for all.
    bool brief = false;             ///< True: the short set only.
    std::int32_t seeds = 0;    ///< Runs of each variant, 0 to 1,000; 0 for as many as each test asks for.
    std::int32_t threads = 0;  ///< Runs at the same time; 0 for all processors. Changes no result.
};

/// The outcome of a row.
enum class Outcome : std::uint8_t {
    Pass,
    Fail,
    Missing,  ///< It cannot be run here, and counts as not passed.
};

/// A row with its results.
struct RowResult {
    RowDef row;
    RowReport report;
    Outcome outcome = Outcome::Fail;
    std::int32_t seeds = 0;             ///< Runs of each variant.
    std::vector<std::string> pictures;  ///< SVG documents, by variant.
    std::vector<std::string> pictureTitles;
};

/// The results of all rows.
struct Verification {
    std::vector<RowResult> rows;
    double seconds = 0.0;  ///< Wall time [s].
    std::string version;   ///< Of the program; left empty by verify().
    std::string when;      ///< When it was run; left empty by verify().
    std::string others;    ///< The table beside other programs, as text; left empty by verify().

    std::size_t count(Outcome outcome) const;
    /// True where no row failed.
    bool passed() const { return count(Outcome::Fail) == 0; }
    /// The program's: 0 where no row failed, else 1. Missing rows fail nothing, and pass nothing.
    int exitCode() const { return passed() ? 0 : 1; }
};

/// Gets the share of work that is done, 0 to 1, and what has just ended.
using VerifyProgress = std::function<void(double, const std::string&)>;

/// The rows that a definition asks for. Fails naming what is not known.
Result<std::vector<RowDef>> chosenRows(const VerifyDef& def, const std::vector<RowDef>& rows);

/// Runs the rows that are asked for. Fails as chosenRows() does, or naming the scene that cannot be run.
Result<Verification> verify(const VerifyDef& def, const VerifyProgress& progress = {});
/// The same of other rows and scenes, for tests.
Result<Verification> verifyRowsOf(const VerifyDef& def, const std::vector<RowDef>& rows,
                                  const std::vector<SceneDef>& scenes, const VerifyProgress& progress = {});

/// The table for a terminal, columns aligned: test, expected, measured, outcome, seeds; and the counts.
std::string verificationText(const Verification& verification);
/// The same as a table in Markdown, for documents.
std::string verificationMarkdown(const Verification& verification);
/// An object with `rows`, each with its checks, and the counts.
std::string verificationJson(const Verification& verification);
/// One page that needs no other file.
std::string verificationPage(const Verification& verification);
/// "pass", "fail", "missing".
const char* outcomeName(Outcome outcome);
/// "standard", "[own]", "data".
const char* whoseName(Whose whose);

}  // namespace muster
