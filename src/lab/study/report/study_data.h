// The study's trials as the report needs them: never models with people, never versions together.
#pragma once

#include <map>
#include <string>
#include <vector>

#include "lab/study/statistics/describe.h"
#include "studio/study/store/store.h"

namespace muster {

/// What is reported together.
struct StudyGroup {
    RunKind kind = RunKind::Models;  ///< Models or people.
    std::int32_t environments = 0;   ///< Version of the environments.
    std::int32_t operators = 0;      ///< Version of the operators; 0 for people.
    friend auto operator<=>(const StudyGroup&, const StudyGroup&) = default;
};

/// What is compared within a group.
struct CellKey {
    std::string environment, scheme, setting;  ///< Names; the setting of people is empty.
    std::int32_t crowd = 0;                    ///< Number of characters.
    friend auto operator<=>(const CellKey&, const CellKey&) = default;
};

/// Trials by seed of models, or by run of people: one each, the first that is complete.
using Cell = std::map<std::uint64_t, StudyTrial>;

/// All that counts, by group and cell.
struct StudyData {
    std::vector<StudyRun> runs;                           ///< All, tests too.
    std::map<StudyGroup, std::map<CellKey, Cell>> cells;  ///< Complete trials without practice and tests.
    std::map<std::int64_t, std::vector<StudyAnswer>> answers;  ///< By run, of people.
    std::map<StudyGroup, int> brokenOff;                       ///< Trials begun and not completed.
};

/// Reads it.
Result<StudyData> readStudy(StudyStore& store);

/// Times of a cell [s]; those of censored trials are the limit.
std::vector<double> timesOf(const Cell& cell);
/// Pairs of times of two cells, by seed or person.
struct PairedTimes {
    std::vector<double> first, second;
};
/// Those that are in both.
PairedTimes pairedTimes(const Cell& first, const Cell& second);
/// The cell of that key; an empty one where there is none.
const Cell& cellOf(const std::map<CellKey, Cell>& cells, const CellKey& key);
/// The full mouse control with the lower median, as it stands in the same environment, crowd and setting;
/// empty for none. People have one mouse control.
std::string bestMouse(const std::map<CellKey, Cell>& cells, const CellKey& key);

/// Over draws of the hypercube: how often touch won.
struct DrawShare {
    int draws = 0;  ///< Draws in which both controls were run.
    int won = 0;    ///< Those in which the median of touch is lower than that of the better mouse.
};
/// In one environment.
DrawShare drawShare(const std::map<CellKey, Cell>& cells, const std::string& environment, std::int32_t crowd);

}  // namespace muster
