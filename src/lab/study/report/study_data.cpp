#include "lab/study/report/study_data.h"

namespace muster {

Result<StudyData> readStudy(StudyStore& store) {
    StudyData data;
    auto runs = store.runs();
    if (!runs.ok()) return runs.status();
    data.runs = std::move(runs).value();
    for (const StudyRun& run : data.runs) {
        if (run.kind == RunKind::Test) continue;
        const bool people = run.kind == RunKind::People;
        const StudyGroup group{run.kind, run.environments, people ? 0 : run.operators};
        const auto trials = store.trials(run.id);
        if (!trials.ok()) return trials.status();
        for (const StudyTrial& trial : *trials) {
            if (trial.practice) continue;
            if (trial.state != RunState::Complete) {
                ++data.brokenOff[group];
                continue;
            }
            const CellKey key{trial.def.environment, trial.def.scheme, trial.setting, trial.def.crowd};
            const auto unit = people ? static_cast<std::uint64_t>(run.id) : trial.def.seed;
            data.cells[group][key].emplace(unit, trial);
        }
        if (!people) continue;
        auto answers = store.answers(run.id);
        if (!answers.ok()) return answers.status();
        data.answers[run.id] = std::move(answers).value();
    }
    return data;
}

std::vector<double> timesOf(const Cell& cell) {
    std::vector<double> times;
    for (const auto& [unit, trial] : cell) times.push_back(trial.result.seconds);
    return times;
}

PairedTimes pairedTimes(const Cell& first, const Cell& second) {
    PairedTimes pairs;
    for (const auto& [unit, trial] : first) {
        const auto other = second.find(unit);
        if (other == second.end()) continue;
        pairs.first.push_back(trial.result.seconds);
        pairs.second.push_back(other->second.result.seconds);
    }
    return pairs;
}

const Cell& cellOf(const std::map<CellKey, Cell>& cells, const CellKey& key) {
    static const Cell none;
    const auto found = cells.find(key);
    return found == cells.end() ? none : found->second;
}

std::string bestMouse(const std::map<CellKey, Cell>& cells, const CellKey& key) {
    std::string best;
    double least = 0.0;
    for (const char* name : {"mouse-full-continuum", "mouse-full-free"}) {
        CellKey mouse = key;
        mouse.scheme = name;
        const Cell& cell = cellOf(cells, mouse);
        if (cell.empty()) continue;
        const double middle = statistics::median(timesOf(cell));
        if (!best.empty() && middle >= least) continue;
        best = name;
        least = middle;
    }
    return best;
}

DrawShare drawShare(const std::map<CellKey, Cell>& cells, const std::string& environment,
                    std::int32_t crowd) {
    DrawShare share;
    for (const auto& [key, cell] : cells) {
        if (key.environment != environment || key.crowd != crowd || key.scheme != "touch") continue;
        if (key.setting.rfind("draw ", 0) != 0) continue;
        CellKey mouse = key;
        mouse.scheme = bestMouse(cells, key);
        const PairedTimes pairs = pairedTimes(cell, cellOf(cells, mouse));
        if (pairs.first.empty()) continue;
        ++share.draws;
        share.won += statistics::median(pairs.first) < statistics::median(pairs.second);
    }
    return share;
}

}  // namespace muster
