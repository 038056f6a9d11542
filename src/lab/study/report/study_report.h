// The report of the study.
#pragma once

#include <string>

#include "studio/study/store/store.h"

namespace muster {

/// Writes report.html and results.json into a folder, which is made where it is missing. `version` is that of
/// Muster. The same database gives the same bytes.
Status writeStudyReport(StudyStore& store, const std::string& folder, const std::string& version);

}  // namespace muster
