// The report's tables.
#include <algorithm>
#include <cmath>

#include "base/hash.h"
#include "files/report/markup.h"
#include "lab/reproduce/report/html_parts.h"

namespace muster {
namespace {

constexpr std::size_t kArmsAcross = 6;  // Number of arms that a printed page has room for.

/// A cell that names its column, for screens too narrow for columns.
std::string cell(const std::string& column, const std::string& content, const char* kind = "") {
    const std::string named = *kind == 0 ? std::string() : std::string(" class=\"") + kind + "\"";
    return "<td" + named + " data-label=\"" + escaped(column) + "\">" + content + "</td>";
}

std::string small(const std::string& words) {
    return words.empty() ? std::string() : "<small>" + escaped(words) + "</small>";
}

std::string summaryRow(const ExperimentResult& experiment, const Verdict& verdict, std::int32_t seeds,
                       bool first) {
    const std::string link = "<a href=\"#" + anchorOf(experiment) + "\">" + escaped(experiment.text.id) +
                             "</a>";
    std::string row = std::string("<tr class=\"") + (verdict.binding ? "" : "aside ") +
                      (first ? "first" : "") + "\">";
    row += cell("Experiment", link + " " + small(experiment.text.title), "name");
    row += cell("Criterion", escaped(verdict.criterion), "words");
    row += cell("Preset", escaped(verdict.preset));
    row += cell(
        "Value",
        "<b>" + escaped(verdictValueText(verdict)) + "</b> " + small(verdictRangeText(verdict, seeds)),
        "number");
    row += cell("Required", escaped(requirementText(verdict)));
    return row + cell("Result", resultSign(verdict)) + "</tr>\n";
}

/// The cell of one arm and one figure.
std::string figureCell(const ExperimentResult& experiment, const Arm& arm, const FigureInfo& figure) {
    const std::vector<RunSample>& runs = experiment.samples.runs(arm.id, arm.preset);
    const auto measured = static_cast<std::size_t>(std::count_if(
        runs.begin(), runs.end(), [&](const RunSample& run) { return run.figures.contains(figure.name); }));
    if (measured == 0) return cell(armTitle(arm), "<span class=\"none\">–</span>", "number");
    const std::vector<double> values = experiment.samples.values(arm.id, arm.preset, figure.name);
    if (values.empty())
        return cell(armTitle(arm), "<span class=\"missing\">" + missingWord(figure.unit) + "</span>",
                    "number");
    const auto [low, high] = std::minmax_element(values.begin(), values.end());
    const std::string lowText = fixedNumber(*low, figure.decimals),
                      highText = fixedNumber(*high, figure.decimals);
    const double middle = median(values);
    const bool between = figure.decimals <= 0 && std::isfinite(middle) && middle != std::floor(middle);
    std::string content = "<b>" + fixedNumber(middle, between ? 1 : figure.decimals) + "</b>";
    if (*low != *high)
        content += " " + small(lowText == highText ? plainNumber(*low) + " to " + plainNumber(*high)
                                                   : lowText + " to " + highText);
    if (values.size() < measured)
        content += " <small class=\"missing\">" + missingWord(figure.unit) + " in " +
                   std::to_string(measured - values.size()) + " of " + std::to_string(measured) + "</small>";
    if (measured < runs.size())
        content += " " +
                   small("measured in " + std::to_string(measured) + " of " + std::to_string(runs.size()));
    return cell(armTitle(arm), content, "number");
}

std::string figuresTable(const ExperimentResult& experiment, std::size_t from, std::size_t to) {
    std::string
        html = "<div class=\"scroll\"><table class=\"figures\">\n<thead><tr><th scope=\"col\">Figure</th>";
    for (std::size_t a = from; a < to; ++a) {
        const Arm& arm = experiment.arms[a];
        html += "<th scope=\"col\" class=\"number\">" + escaped(arm.title) + " " +
                small(arm.preset + ", " + planOf(experiment, arm)) + "</th>";
    }
    html += "</tr></thead>\n<tbody>\n";
    for (const FigureInfo& figure : experiment.figures) {
        html += "<tr><th scope=\"row\">" + escaped(figure.title) +
                (figure.unit.empty() ? "" : " <span class=\"unit\">[" + escaped(figure.unit) + "]</span>") +
                "</th>";
        for (std::size_t a = from; a < to; ++a) html += figureCell(experiment, experiment.arms[a], figure);
        html += "</tr>\n";
    }
    return html + "</tbody></table></div>\n";
}

}  // namespace

std::string summaryTable(const Reproduction& reproduction) {
    std::string html =
        "<table class=\"stack summary\">\n<thead><tr><th scope=\"col\">Experiment</th><th "
        "scope=\"col\">Criterion</th>"
        "<th scope=\"col\">Preset</th><th scope=\"col\" class=\"number\">Value <small>lowest to "
        "highest</small></th>"
        "<th scope=\"col\">Required</th><th scope=\"col\">Result</th></tr></thead>\n<tbody>\n";
    for (const ExperimentResult& experiment : reproduction.experiments) {
        bool first = true;
        for (const CriterionRow& row : criterionRows(experiment)) {
            for (const Verdict* verdict : row.byPreset) {
                if (verdict == nullptr) continue;
                html += summaryRow(experiment, *verdict, reproduction.seeds, first);
                first = false;
            }
        }
    }
    return html + "</tbody></table>\n";
}

std::string criteriaTable(const ExperimentResult& experiment, std::int32_t seeds) {
    if (experiment.verdicts.empty()) return "<p>No criterion was judged.</p>\n";
    const std::vector<std::string> presets = presetsOf(experiment);
    std::string html =
        "<table class=\"stack criteria\">\n<thead><tr><th scope=\"col\">Criterion</th><th "
        "scope=\"col\">Required</th>";
    for (const std::string& preset : presets)
        html += "<th scope=\"col\">" + escaped(preset) +
                (preset == "muster" ? "" : " <small>for comparison</small>") + "</th>";
    html += "</tr></thead>\n<tbody>\n";
    for (const CriterionRow& row : criterionRows(experiment)) {
        html += "<tr>" + cell("Criterion", escaped(row.any().criterion), "words") +
                cell("Required", escaped(requirementText(row.any())));
        for (std::size_t p = 0; p < presets.size(); ++p) {
            const Verdict* verdict = row.byPreset[p];
            html += verdict == nullptr
                        ? cell(presets[p], "<span class=\"none\">not judged</span>")
                        : cell(presets[p], "<span>" + resultSign(*verdict) + " <b>" +
                                               escaped(verdictValueText(*verdict)) + "</b></span> " +
                                               small(verdictRangeText(*verdict, seeds)));
        }
        html += "</tr>\n";
    }
    return html + "</tbody></table>\n";
}

std::string figuresTables(const ExperimentResult& experiment, std::int32_t seeds) {
    std::string
        html = "<p class=\"help\">" +
               std::string(
                   seeds == 1
                       ? "One run of each arm."
                       : "The median over " + std::to_string(seeds) +
                             " seeds, and lowest to highest; a single number is the same in all of them.") +
               " – is not measured in that arm.</p>\n";
    for (std::size_t from = 0; from < experiment.arms.size(); from += kArmsAcross)
        html += figuresTable(experiment, from, std::min(from + kArmsAcross, experiment.arms.size()));
    return html;
}

std::string hashTable(const ExperimentResult& experiment) {
    std::string html =
        "<table class=\"hashes\">\n<thead><tr><th scope=\"col\">Arm</th><th scope=\"col\">Preset</th>"
        "<th scope=\"col\">Plan</th><th scope=\"col\">Hash</th></tr></thead>\n<tbody>\n";
    for (const Arm& arm : experiment.arms) {
        const std::vector<RunSample>& runs = experiment.samples.runs(arm.id, arm.preset);
        const bool has = !runs.empty() && runs.front().hash != 0;
        html += "<tr><td>" + escaped(arm.title) + "</td><td>" + escaped(arm.preset) + "</td><td>" +
                escaped(planOf(experiment, arm)) + "</td><td><code>" +
                (has ? toHex(runs.front().hash) : "none") + "</code></td></tr>\n";
    }
    return html + "</tbody></table>\n";
}

}  // namespace muster
