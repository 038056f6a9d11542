// Sections about people.
#include <cmath>
#include <limits>

#include "files/report/markup.h"
#include "lab/study/report/study_parts.h"
#include "lab/study/statistics/describe.h"
#include "lab/study/statistics/mixed_model.h"
#include "lab/study/statistics/rank_tests.h"

namespace muster {
namespace {

using Cells = std::map<CellKey, Cell>;

std::string pText(double p) {
    return p < 0.0001 ? "below 0.0001" : fixedNumber(p, 4);
}

/// The mouse control that people had.
std::string mouseOf(const Cells& cells) {
    for (const auto& [key, cell] : cells)
        if (key.scheme.rfind("mouse", 0) == 0) return key.scheme;
    return {};
}

std::vector<statistics::MixedRow> mixedRows(const Cells& cells) {
    std::vector<statistics::MixedRow> rows;
    std::map<std::string, std::int32_t> layouts;
    std::map<std::uint64_t, double> began;
    for (const auto& [key, cell] : cells)
        for (const auto& [run, trial] : cell)
            if (key.scheme == "touch") began[run] = trial.period == 1 ? 1.0 : 0.0;
    std::int32_t number = 0;
    for (const StudyEnvironment& environment : studyEnvironments()) {
        for (const auto& [key, cell] : cells) {
            if (key.environment != environment.name) continue;
            for (const auto& [run, trial] : cell) {
                const std::string layout = key.environment + std::to_string(trial.def.seed) +
                                           (trial.def.mirrored ? "m" : "");
                const auto place = layouts.emplace(layout, static_cast<std::int32_t>(layouts.size()))
                                       .first->second;
                rows.push_back({std::log(trial.result.seconds), number, key.scheme == "touch",
                                static_cast<double>(trial.period), began[run], static_cast<std::int32_t>(run),
                                place});
            }
        }
        ++number;
    }
    return rows;
}

std::string mainAnalysis(const Cells& cells) {
    const auto model = statistics::fitMixedModel(mixedRows(cells));
    if (!model.ok())
        return "<p class=\"none\">" + escaped("No main analysis: " + model.status().message() + ".") +
               "</p>\n";
    std::string html =
        "<p class=\"words\">" +
        escaped("Log time by a linear mixed model, " + std::to_string(model->people) + " people, " +
                std::to_string(model->trials) + " trials: control in each environment, period and order, " +
                "random person with a slope for the control, random layout; Satterthwaite's degrees of " +
                "freedom, Holm over the environments.") +
        "</p><div class=\"scroll\"><table><thead><tr><th>Environment (people)</th><th>Ratio of geometric "
        "means, touch to mouse</th><th>95 %</th><th>df</th><th>p, Holm</th></tr></thead><tbody>\n";
    for (const statistics::MixedEffect& effect : model->effects)
        html += "<tr><td>" +
                escaped(studyEnvironments()[static_cast<std::size_t>(effect.environment)].title) +
                "</td><td>" + fixedNumber(effect.ratio.value, 2) + "</td><td>" +
                fixedNumber(effect.ratio.low, 2) + " to " + fixedNumber(effect.ratio.high, 2) + "</td><td>" +
                fixedNumber(effect.df, 1) + "</td><td>" + pText(effect.holm) + "</td></tr>\n";
    return html + "</tbody></table></div>\n";
}

/// Differences of times, touch less mouse; a censored trial is worst.
std::vector<double> differencesOf(const Cell& touch, const Cell& mouse) {
    std::vector<double> differences;
    const double worst = std::numeric_limits<double>::infinity();
    for (const auto& [run, trial] : touch) {
        const auto other = mouse.find(run);
        if (other == mouse.end()) continue;
        const bool a = trial.result.done, b = other->second.result.done;
        differences.push_back(a && b   ? trial.result.seconds - other->second.result.seconds
                              : a == b ? 0.0
                              : a      ? -worst
                                       : worst);
    }
    return differences;
}

std::string robust(const Cells& cells) {
    std::string html =
        "<div class=\"scroll\"><table><thead><tr><th>Environment (people)</th><th>Pairs</th><th>p, signed "
        "rank</th><th>Rank-biserial r</th><th>Hodges-Lehmann difference [s]</th><th>95 % "
        "[s]</th></tr></thead><tbody>\n";
    for (const StudyEnvironment& environment : studyEnvironments()) {
        const std::string name(environment.name);
        std::vector<double> differences;
        for (const auto& [key, cell] : cells)
            if (key.environment == name && key.scheme == "touch")
                differences = differencesOf(cell,
                                            cellOf(cells, {name, mouseOf(cells), key.setting, key.crowd}));
        const statistics::SignedRank test = statistics::signedRank(differences);
        const statistics::Estimate middle = statistics::hodgesLehmann(differences);
        html += "<tr><td>" + escaped(environment.title) + "</td><td>" + std::to_string(differences.size()) +
                "</td><td>" + pText(test.p) + "</td><td>" + fixedNumber(test.rankBiserial, 2) + "</td><td>" +
                fixedNumber(middle.value, 1) + "</td><td>" + fixedNumber(middle.low, 1) + " to " +
                fixedNumber(middle.high, 1) + "</td></tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

/// Scores of published questionnaires of one person and control, where all items were answered.
void addScores(const std::string& instrument, const std::vector<double>& numbers, const std::string& scheme,
               std::map<std::string, std::map<std::string, std::vector<double>>>& values) {
    const auto add = [&](const char* name, double score) {
        if (std::isfinite(score)) values[name][scheme].push_back(score);
    };
    if (instrument == "sus") add("SUS score, 0 to 100", statistics::susScore(numbers));
    if (instrument == "tlx") add("Raw NASA-TLX, 0 to 100", statistics::rawTlx(numbers));
    if (instrument != "ueq-s") return;
    add("UEQ-S pragmatic, -3 to 3", statistics::ueqShort(numbers).pragmatic);
    add("UEQ-S hedonic, -3 to 3", statistics::ueqShort(numbers).hedonic);
}

/// Every question that has numbers, as box plots by control.
std::string questionnaires(const StudyData& data, const std::vector<std::int64_t>& runs) {
    std::map<std::string, std::map<std::string, std::vector<double>>> values;
    std::string reasons;
    for (const std::int64_t run : runs) {
        const auto answers = data.answers.find(run);
        if (answers == data.answers.end()) continue;
        std::map<std::pair<std::string, std::string>, std::vector<double>> sheets;
        for (const StudyAnswer& answer : answers->second) {
            if (!answer.scheme.empty()) sheets[{answer.instrument, answer.scheme}].push_back(answer.number);
            if (answer.instrument == "preference")
                reasons += "<li>" + escaped(answer.item + ": " + answer.text) + "</li>\n";
            else if (std::isfinite(answer.number) && !answer.scheme.empty())
                values[answer.instrument + ", " + answer.item][answer.scheme].push_back(answer.number);
        }
        for (const auto& [sheet, numbers] : sheets) addScores(sheet.first, numbers, sheet.second, values);
    }
    if (values.empty() && reasons.empty()) return "<p class=\"none\">There are no answers of people.</p>\n";
    std::string html = "<div class=\"plots charts\">\n";
    for (const auto& [question, schemes] : values) {
        std::vector<BoxRow> rows;
        std::size_t most = 0;
        for (const auto& [scheme, numbers] : schemes) {
            rows.push_back(
                {schemeTitle(scheme), scheme == "touch" ? std::size_t{0} : std::size_t{3}, numbers});
            most = std::max(most, numbers.size());
        }
        const std::string title = question + ": people, n = " + std::to_string(most);
        html += "<figure class=\"plot\"><figcaption>" + escaped(title) + "</figcaption>" +
                boxPlot(title, "answer", rows) + "</figure>\n";
    }
    html += "</div>\n<h3>Preferences of people, with reasons</h3>\n";
    return html + (reasons.empty() ? "<p class=\"none\">No person gave a preference.</p>\n"
                                   : "<ul>" + reasons + "</ul>\n");
}

}  // namespace

std::string peopleSections(const StudyGroup& group, const StudyData& data) {
    const auto found = data.cells.find(group);
    const Cells cells = found == data.cells.end() ? Cells() : found->second;
    std::vector<std::int64_t> runs;
    for (const StudyRun& run : data.runs)
        if (run.kind == RunKind::People && run.environments == group.environments) runs.push_back(run.id);
    std::string html = "<section class=\"chapter\"><h2>" +
                       escaped("People, environments of version " + std::to_string(group.environments) +
                               ", n = " + std::to_string(runs.size())) +
                       "</h2>\n<h3>Main analysis of people's times</h3>\n" + mainAnalysis(cells) +
                       "<h3>Robust companion, people</h3>\n" + robust(cells) +
                       "<h3>Answers of people</h3>\n" + questionnaires(data, runs);
    return html + "</section>\n";
}

}  // namespace muster
