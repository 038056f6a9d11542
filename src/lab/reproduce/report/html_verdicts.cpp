// Verdicts as text and table cells.
#include <algorithm>
#include <cctype>
#include <cmath>

#include "files/report/markup.h"
#include "lab/reproduce/report/html_parts.h"

namespace muster {
namespace {

bool sameNumber(double a, double b) {
    return a == b || (std::isnan(a) && std::isnan(b));
}

/// True if both are the same criterion; presets may differ.
bool sameCriterion(const Verdict& a, const Verdict& b) {
    return a.criterion == b.criterion && a.unit == b.unit && a.comparison == b.comparison &&
           a.aggregate == b.aggregate && sameNumber(a.threshold, b.threshold);
}

const char* aggregateWords(Aggregate aggregate) {
    switch (aggregate) {
        case Aggregate::Median:
            return "in the median";
        case Aggregate::Lowest:
        case Aggregate::Highest:
            return "in every seed";
    }
    return "";
}

}  // namespace

std::string shareText(const CriteriaCount& count) {
    return std::to_string(count.passed) + " of " + std::to_string(count.judged);
}

std::string holdText(const CriteriaCount& count) {
    return std::string(count.judged == 1 ? "criterion" : "criteria") +
           (count.judged == 1 || count.passed == 1 ? " holds" : " hold");
}

CriteriaCount countCriteria(const ExperimentResult& experiment) {
    CriteriaCount count;
    for (const Verdict& verdict : experiment.verdicts) {
        if (!verdict.binding) continue;
        ++count.judged;
        count.passed += verdict.pass ? 1 : 0;
    }
    return count;
}

CriteriaCount countCriteria(const Reproduction& reproduction) {
    CriteriaCount sum;
    for (const ExperimentResult& experiment : reproduction.experiments) {
        const CriteriaCount count = countCriteria(experiment);
        sum.judged += count.judged;
        sum.passed += count.passed;
    }
    return sum;
}

const Verdict& CriterionRow::any() const {
    return **std::find_if(byPreset.begin(), byPreset.end(),
                          [](const Verdict* verdict) { return verdict != nullptr; });
}

std::vector<std::string> presetsOf(const ExperimentResult& experiment) {
    std::vector<std::string> presets;
    for (const Verdict& verdict : experiment.verdicts) {
        if (std::find(presets.begin(), presets.end(), verdict.preset) != presets.end()) continue;
        presets.insert(verdict.preset == "muster" ? presets.begin() : presets.end(), verdict.preset);
    }
    return presets;
}

std::vector<CriterionRow> criterionRows(const ExperimentResult& experiment) {
    const std::vector<std::string> presets = presetsOf(experiment);
    std::vector<CriterionRow> rows;
    for (const Verdict& verdict : experiment.verdicts) {
        const auto column = static_cast<std::size_t>(
            std::find(presets.begin(), presets.end(), verdict.preset) - presets.begin());
        auto row = std::find_if(rows.begin(), rows.end(), [&](const CriterionRow& r) {
            return r.byPreset[column] == nullptr && sameCriterion(r.any(), verdict);
        });
        if (row == rows.end()) row = rows.insert(row, {std::vector<const Verdict*>(presets.size(), nullptr)});
        row->byPreset[column] = &verdict;
    }
    return rows;
}

std::string anchorOf(const ExperimentResult& experiment) {
    std::string name;
    for (const char c : experiment.text.id)
        if (std::isalnum(static_cast<unsigned char>(c)) != 0)
            name += static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
    return name.empty() ? "experiment" : name;
}

std::string requirementText(const Verdict& verdict) {
    return std::string(verdict.comparison == Comparison::AtLeast ? "at least " : "at most ") +
           withUnit(plainNumber(verdict.threshold), verdict.unit) + " " + aggregateWords(verdict.aggregate);
}

std::string verdictValueText(const Verdict& verdict) {
    if (std::isnan(verdict.value)) return missingWord(verdict.unit);
    return withUnit(judgedNumber(verdict.value, verdict.threshold), verdict.unit);
}

std::string verdictRangeText(const Verdict& verdict, std::int32_t seeds) {
    const std::string all = counted(static_cast<std::size_t>(std::max(seeds, verdict.seeds)), "seed",
                                    "seeds");
    if (verdict.seeds == 0) return "in none of " + all;
    const std::string low = judgedNumber(verdict.low, verdict.threshold),
                      high = judgedNumber(verdict.high, verdict.threshold);
    const std::string range = low == high ? low : low + " to " + high;
    if (verdict.seeds < seeds)
        return range + ", " + missingWord(verdict.unit) + " in " + std::to_string(seeds - verdict.seeds) +
               " of " + all;
    if (seeds == 1) return all;
    return low == high ? "the same in " + all : range + ", " + all;
}

std::string planOf(const ExperimentResult& experiment, const Arm& arm) {
    std::string names;
    for (const RunSample& run : experiment.samples.runs(arm.id, arm.preset))
        if (!run.plan.empty() && names.find(run.plan) == std::string::npos)
            names += (names.empty() ? "" : " and ") + run.plan;
    return names.empty() ? "no plan" : names + " plan";
}

std::string armTitle(const Arm& arm) {
    return arm.title + (arm.preset == "muster" ? "" : " (" + arm.preset + ")");
}

std::string resultSign(const Verdict& verdict) {
    const std::string word = verdict.pass ? "✓ pass" : "✗ fail";
    return std::string("<span class=\"sign ") + (verdict.pass ? "pass" : "fail") +
           (verdict.binding ? "" : " aside") + "\">" + word + "</span>";
}

}  // namespace muster
