// The summary as Markdown.
#include "files/report/markup.h"
#include "lab/reproduce/report/html_parts.h"

namespace muster {
namespace {

/// One line per experiment: which plan each arm used.
std::string planLines(const Reproduction& reproduction) {
    std::string text = "\nPlans of the arms:\n\n";
    for (const ExperimentResult& experiment : reproduction.experiments) {
        text += "- " + experiment.text.id + ": ";
        for (std::size_t a = 0; a < experiment.arms.size(); ++a)
            text += (a == 0 ? "" : ", ") + armTitle(experiment.arms[a]) + ": " +
                    planOf(experiment, experiment.arms[a]);
        text += "\n";
    }
    return text;
}

}  // namespace

std::string summaryMarkdown(const Reproduction& reproduction) {
    const CriteriaCount count = countCriteria(reproduction);
    std::string text = shareText(count) + " " + holdText(count) + " over " +
                       counted(static_cast<std::size_t>(reproduction.seeds), "seed", "seeds") +
                       ". Criteria of the preset `muster` decide; those of others, in brackets, are for "
                       "comparison.\n\n"
                       "| Experiment | Criterion | Preset | Value | Lowest to highest | Required | Result |\n"
                       "| --- | --- | --- | ---: | --- | --- | --- |\n";
    for (const ExperimentResult& experiment : reproduction.experiments) {
        for (const CriterionRow& row : criterionRows(experiment)) {
            for (const Verdict* verdict : row.byPreset) {
                if (verdict == nullptr) continue;
                const std::string result = verdict->binding ? (verdict->pass ? "pass" : "**fail**")
                                                            : (verdict->pass ? "(pass)" : "(fail)");
                text += "| " + markdownCell(experiment.text.id + " " + experiment.text.title) + " | " +
                        markdownCell(verdict->criterion) + " | " + markdownCell(verdict->preset) + " | " +
                        markdownCell(verdictValueText(*verdict)) + " | " +
                        markdownCell(verdictRangeText(*verdict, reproduction.seeds)) + " | " +
                        markdownCell(requirementText(*verdict)) + " | " + result + " |\n";
            }
        }
    }
    return text + planLines(reproduction);
}

}  // namespace muster
