// Parts of the study's report. All return well-formed, escaped XHTML.
#pragma once

#include <string>

#include "lab/study/report/study_data.h"

namespace muster {

/// The display title of a control scheme or environment; its name where it is unknown.
std::string schemeTitle(const std::string& name);
std::string environmentTitle(const std::string& name);
/// Word such as "models" or "people".
std::string groupWord(const StudyGroup& group);

/// A row of box plots.
struct BoxRow {
    std::string title;           ///< Title at the left of the row.
    std::size_t series = 0;      ///< Number of the row's colour.
    std::vector<double> values;  ///< Values, at least one.
};
/// Draws box plots beside one axis from 0.
std::string boxPlot(const std::string& title, const std::string& unit, const std::vector<BoxRow>& rows);
/// A plan of an environment: blocks, start, items of seed 1.
std::string planDrawing(const StudyEnvironment& environment);

/// The rules and environments.
std::string environmentSection();
/// The sections about the models of one group of versions.
std::string modelSections(const StudyGroup& group, const StudyData& data);
/// The sections about the people of one version.
std::string peopleSections(const StudyGroup& group, const StudyData& data);

}  // namespace muster
