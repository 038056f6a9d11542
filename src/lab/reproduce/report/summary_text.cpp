// The verdicts for a terminal or a log.
#include <algorithm>

#include "files/report/markup.h"
#include "lab/reproduce/report/html_parts.h"

namespace muster {
namespace {

constexpr std::size_t kColumns = 100;

std::string padded(std::string text, std::size_t width) {
    text.resize(std::max(text.size(), width), ' ');
    return text;
}

std::string indented(const std::string& words, const std::string& before) {
    std::string text;
    for (const std::string& line : wrapped(words, kColumns - before.size())) text += before + line + "\n";
    return text;
}

}  // namespace

std::string summaryText(const Reproduction& reproduction) {
    std::string text;
    for (const ExperimentResult& experiment : reproduction.experiments) {
        const CriteriaCount count = countCriteria(experiment);
        text += padded(experiment.text.id, 4) + experiment.text.title + ": " + shareText(count) + "\n";
        for (const CriterionRow& row : criterionRows(experiment)) {
            text += indented(row.any().criterion + "; required " + requirementText(row.any()), "    ");
            for (const Verdict* verdict : row.byPreset) {
                if (verdict == nullptr) continue;
                text += padded(verdict->pass      ? "      pass"
                               : verdict->binding ? "      FAIL"
                                                  : "      fail",
                               12) +
                        padded(verdict->preset, 8) + verdictValueText(*verdict) + " (" +
                        verdictRangeText(*verdict, reproduction.seeds) + ")" +
                        (verdict->binding ? "" : ", for comparison") + "\n";
            }
        }
    }
    const CriteriaCount all = countCriteria(reproduction);
    return text + shareText(all) + " " + holdText(all) + "; " +
           counted(static_cast<std::size_t>(reproduction.seeds), "seed", "seeds") + ", " +
           fixedNumber(reproduction.seconds, reproduction.seconds < 10.0 ? 1 : 0) + " s\n";
}

}  // namespace muster
