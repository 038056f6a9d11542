// The parts of the report's page. All return well-formed, escaped XHTML.
#pragma once

#include <string>
#include <vector>

#include "lab/reproduce/reproduce.h"

namespace muster {

/// Counts of criteria. Only binding criteria decide over the outcome.
struct CriteriaCount {
    std::size_t judged = 0;  ///< Binding ones.
    std::size_t passed = 0;  ///< Of these.
};

/// "3 of 6".
std::string shareText(const CriteriaCount& count);
/// The words after the count: "criteria hold".
std::string holdText(const CriteriaCount& count);

/// Of one experiment.
CriteriaCount countCriteria(const ExperimentResult& experiment);
/// Of all.
CriteriaCount countCriteria(const Reproduction& reproduction);

/// One criterion with the verdict of each preset; null if a preset was not judged.
struct CriterionRow {
    std::vector<const Verdict*> byPreset;  ///< As presetsOf() lists them.
    const Verdict& any() const;            ///< One that is there.
};
/// The presets that were judged, "muster" first.
std::vector<std::string> presetsOf(const ExperimentResult& experiment);
/// Criteria in the order they were judged; verdicts with the same words, unit and threshold share a row.
std::vector<CriterionRow> criterionRows(const ExperimentResult& experiment);

/// "x4": names the chapter in links.
std::string anchorOf(const ExperimentResult& experiment);
/// "at least 36 in every seed", as text.
std::string requirementText(const Verdict& verdict);
/// "36 s", or "no value", as text.
std::string verdictValueText(const Verdict& verdict);
/// "34 to 36, 10 seeds", as text; names seeds without a value.
std::string verdictRangeText(const Verdict& verdict, std::int32_t seeds);
/// "fast plan", as text: the method of the arm's plans.
std::string planOf(const ExperimentResult& experiment, const Arm& arm);
/// "Transport (paper)", as text: the preset is named where it is not "muster".
std::string armTitle(const Arm& arm);
/// The symbol for pass or fail, with its word.
std::string resultSign(const Verdict& verdict);

/// The table of all criteria.
std::string summaryTable(const Reproduction& reproduction);
/// The criteria of one experiment, with a column per preset.
std::string criteriaTable(const ExperimentResult& experiment, std::int32_t seeds);
/// Medians and ranges of all figures and arms.
std::string figuresTables(const ExperimentResult& experiment, std::int32_t seeds);
/// The hash of the first seed, by arm.
std::string hashTable(const ExperimentResult& experiment);
/// One plot per figure that differs between runs.
std::string stripPlots(const ExperimentResult& experiment);
/// The pictures of the first seed, a strip per arm.
std::string films(const ExperimentResult& experiment);
/// All about one experiment.
std::string chapter(const ExperimentResult& experiment, std::int32_t seeds);

}  // namespace muster
