// The study's trials as the report needs them: never models with people, never versions together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/study/statistics/describe.h"
#include "studio/study/store/store.h"

namespace muster {

/// Trials that are reported together.
struct StudyGroup {
    RunKind kind = RunKind::Models;  ///< Whether models or people directed.
    std::int32_t environments = 0;   ///< Version of the environments.
    std::int32_t operators = 0;      ///< Version of the operators; 0 for people.
    friend auto operator<=>(const StudyGroup&, const StudyGroup&) = default;
};

/// Trials that are compared within a group.
struct CellKey {
    /// Names of environment, scheme and setting; the setting of people is empty.
    std::string environment, scheme, setting;
    std::int32_t crowd = 0;  ///< Number of characters.
    friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

/// Trials by seed of models, or by run of people: one each, the first that is complete.
using Cell = std::map<std::uint64_t, StudyTrial>;

/// All data of the report, by group and cell.
struct StudyData {
    std::vector<StudyRun> runs;                           ///< All runs, tests too.
    std::map<StudyGroup, std::map<CellKey, Cell>> cells;  ///< Complete trials without practice and tests.
    std::map<std::int64_t, std::vector<StudyAnswer>> answers;  ///< Answers by run, of people.
    std::map<StudyGroup, int> brokenOff;                       ///< Number of trials begun and not completed.
};

/// Reads the data.
Result<StudyData> readStudy(StudyStore& store);

/// Times of a cell [s]; the limit for a censored trial.
std::vector<double> timesOf(const Cell& cell);
/// Pairs of times of two cells, by seed or person.
struct PairedTimes {
    std::vector<double> first, second;
};
/// Times of the trials that are in both cells.
PairedTimes pairedTimes(const Cell& first, const Cell& second);
/// The cell of that key; an empty one where there is none.
const Cell& cellOf(const std::map<CellKey, Cell>& cells, const CellKey& key);
/// The full mouse control with the lower median, as it stands in the same environment, crowd and setting;
/// empty for none. People have one mouse control.
std::string bestMouse(const std::map<CellKey, Cell>& cells, const CellKey& key);

/// Number of draws of the hypercube that touch won.
struct DrawShare {
    int draws = 0;  ///< Number of draws in which both controls were run.
    int won = 0;    ///< Number of draws in which the median of touch is lower than that of the better mouse.
};
/// Draws that touch won in one environment.
DrawShare drawShare(const std::map<CellKey, Cell>& cells, const std::string& environment, std::int32_t crowd);

}  // namespace muster
