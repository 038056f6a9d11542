// The report of the study, and its tables as CSV (RFC 4180) with a codebook.
#pragma once

#include <string>

#include "base/csv_field.h"
#include "studio/study/store/store.h"

namespace muster {

/// Writes report.html and results.json into a folder, which is made where it is missing. `version` is that of
/// Muster. The same database gives the same bytes.
Status writeStudyReport(StudyStore& store, const std::string& folder, const std::string& version);

/// Word such as "models", "people" or "test".
const char* kindName(RunKind kind);
/// Word such as "running", "complete" or "broken-off".
const char* stateName(RunState state);

/// Writes runs.csv, trials.csv, inputs.csv, decisions.csv, answers.csv, codebook.csv and codebook.md into a
/// folder, which is made where it is missing.
Status exportStudy(StudyStore& store, const std::string& folder);

}  // namespace muster
