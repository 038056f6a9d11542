// The parts of the report's page. All return well-formed, escaped XHTML.
#pragma once

#include <string>
#include <vector>

#include "lab/reproduce/reproduce.h"

namespace muster {

/// Counts of criteria. Only binding criteria decide over the outcome.
struct CriteriaCount {
    std::size_t judged = 0;  ///< Number of binding criteria.
    std::size_t passed = 0;  ///< Number of binding criteria that pass.
};

/// Words such as "3 of 6".
std::string shareText(const CriteriaCount& count);
/// The words after the count: "criteria hold".
std::string holdText(const CriteriaCount& count);

/// Counts the criteria of one experiment.
CriteriaCount countCriteria(const ExperimentResult& experiment);
/// Counts the criteria of all experiments.
CriteriaCount countCriteria(const Reproduction& reproduction);

/// One criterion with the verdict of each preset; null if a preset was not judged.
struct CriterionRow {
    std::vector<const Verdict*> byPreset;  ///< Verdicts in the order of presetsOf().
    const Verdict& any() const;            ///< The first verdict that is there.
};
/// The presets that were judged, "muster" first.
std::vector<std::string> presetsOf(const ExperimentResult& experiment);
/// Criteria in the order they were judged; verdicts with the same words, unit and threshold share a row.
std::vector<CriterionRow> criterionRows(const ExperimentResult& experiment);

/// Anchor such as "x4", which names the chapter in links.
std::string anchorOf(const ExperimentResult& experiment);
/// Text such as "at least 36 in every seed".
std::string requirementText(const Verdict& verdict);
/// Text such as "36 s", or "no value".
std::string verdictValueText(const Verdict& verdict);
/// Text such as "34 to 36, 10 seeds"; it names seeds without a value.
std::string verdictRangeText(const Verdict& verdict, std::int32_t seeds);
/// Text such as "fast plan": the method of the arm's plans.
std::string planOf(const ExperimentResult& experiment, const Arm& arm);
/// Text such as "Transport (paper)": the preset is named where it is not "muster".
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
/// The chapter of one experiment.
std::string chapter(const ExperimentResult& experiment, std::int32_t seeds);

}  // namespace muster
