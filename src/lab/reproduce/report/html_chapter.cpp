// The chapter of one experiment.
#include <algorithm>
#include <cmath>

#include "files/report/markup.h"
#include "lab/reproduce/report/drawings.h"
#include "lab/reproduce/report/html_parts.h"

namespace muster {
namespace {

std::string section(const std::string& title, const std::string& content) {
    return content.empty() ? std::string() : "<h3>" + title + "</h3>\n" + content;
}

std::string filmOf(const ExperimentResult& experiment, const Arm& arm, const std::vector<FilmFrame>& film) {
    std::string html = "<section class=\"film\">\n";
    if (experiment.arms.size() > 1)
        html += "<h4>" + escaped(arm.title) + " <small>" + escaped(arm.preset) + "</small></h4>\n";
    html += "<div class=\"frames c" + std::to_string(stripColumns(film.size())) + "\">\n";
    for (std::size_t i = 0; i < film.size(); ++i) {
        const FilmFrame& frame = film[i];
        const std::string prefix = anchorOf(experiment) + "-" +
                                   std::to_string(&arm - experiment.arms.data()) + "-" + std::to_string(i) +
                                   "-";
        const std::string picture = nestedPicture(
            frame.svg, " role=\"img\" aria-label=\"" + escaped(frame.caption) + "\"", prefix);
        html += "<figure>" + (picture.empty() ? "<p class=\"missing\">no picture</p>" : picture) +
                "<figcaption><b>" + fixedNumber(frame.time, 1) + " s</b> " + escaped(frame.caption) +
                "</figcaption></figure>\n";
    }
    return html + "</div>\n</section>\n";
}

/// Arms with the same id share colour and mark, whatever their preset.
std::size_t seriesOf(const ExperimentResult& experiment, const Arm& arm) {
    std::vector<std::string> ids;
    for (const Arm& other : experiment.arms) {
        if (other.id == arm.id) return ids.size();
        if (std::find(ids.begin(), ids.end(), other.id) == ids.end()) ids.push_back(other.id);
    }
    return ids.size();
}

StripPlotDef plotOf(const ExperimentResult& experiment, const FigureInfo& figure) {
    StripPlotDef plot{figure.title, figure.decimals <= 0, {}};
    for (const Arm& arm : experiment.arms) {
        StripRow row{armTitle(arm), seriesOf(experiment, arm), arm.preset != "muster", {}, 0};
        bool measured = false;
        for (const RunSample& run : experiment.samples.runs(arm.id, arm.preset)) {
            const auto found = run.figures.find(figure.name);
            if (found == run.figures.end()) continue;
            measured = true;
            if (std::isnan(found->second))
                ++row.missing;
            else
                row.values.push_back(found->second);
        }
        if (measured) plot.rows.push_back(std::move(row));
    }
    return plot;
}

/// True where a plot shows more than one dot in one place.
bool varies(const StripPlotDef& plot) {
    const double* first = nullptr;
    for (const StripRow& row : plot.rows) {
        for (const double& value : row.values) {
            if (first != nullptr && value != *first) return true;
            first = &value;
        }
    }
    return false;
}

std::string joined(const std::vector<std::string>& words) {
    std::string list;
    for (std::size_t i = 0; i < words.size(); ++i)
        list += (i == 0 ? "" : i + 1 == words.size() ? " and " : ", ") + words[i];
    return list;
}

std::string chartsOf(const ExperimentResult& experiment) {
    std::string html;
    for (const ChartDef& chart : experiment.charts)
        html += "<figure class=\"plot\"><figcaption>" + escaped(chart.title) + "</figcaption>" +
                chartSvg(chart) + "</figure>\n";
    return html.empty() ? html : "<div class=\"plots charts\">\n" + html + "</div>\n";
}

std::string again(const ExperimentResult& experiment, std::int32_t seeds) {
    const std::string& name = experiment.text.scenario;
    std::string commands = "muster reproduce " + experiment.text.id + " --seeds " + std::to_string(seeds);
    std::string html = "<p>The figures:</p><pre>" + escaped(commands) + "</pre>\n";
    if (!name.empty())
        html += "<p>In the studio, where Watch plays the touches that the scenario carries:</p><pre>" +
                escaped("muster studio paper/" + name) +
                "</pre>\n<p>As figures of one run on the command line:</p><pre>" +
                escaped("muster play scenarios/paper/" + name + ".json --demo") + "</pre>\n";
    return html +
           "<p>The world’s hash at the end of the run with seed 1. Whoever gets the same hash got the same "
           "run, bit "
           "for bit.</p>\n" +
           hashTable(experiment);
}

std::string chapterHead(const ExperimentResult& experiment) {
    const CriteriaCount count = countCriteria(experiment);
    const bool whole = count.passed == count.judged;
    return "<h2><span class=\"id\">" + escaped(experiment.text.id) + "</span> " +
           escaped(experiment.text.title) + "</h2>\n<p class=\"verdict " + (whole ? "pass" : "fail") + "\">" +
           shareText(count) + " " + holdText(count) + "</p>\n";
}

}  // namespace

std::string films(const ExperimentResult& experiment) {
    std::string html;
    std::size_t longest = 0;
    for (const Arm& arm : experiment.arms) {
        const std::vector<RunSample>& runs = experiment.samples.runs(arm.id, arm.preset);
        if (runs.empty() || runs.front().film.empty()) continue;
        html += filmOf(experiment, arm, runs.front().film);
        longest = std::max(longest, runs.front().film.size());
    }
    if (html.empty()) return html;
    // Short films are placed side by side, so that arms can be compared.
    const std::string kind = longest <= 2 ? " n" + std::to_string(longest) : "";
    return "<p class=\"help\">Pictures of the run with seed 1.</p>\n<div class=\"films" + kind + "\">\n" +
           html + "</div>\n";
}

std::string stripPlots(const ExperimentResult& experiment) {
    std::string html;
    std::vector<std::string> alike, never;
    for (const FigureInfo& figure : experiment.figures) {
        const StripPlotDef plot = plotOf(experiment, figure);
        if (plot.rows.empty()) continue;
        const bool any = std::any_of(plot.rows.begin(), plot.rows.end(),
                                     [](const StripRow& row) { return !row.values.empty(); });
        if (!varies(plot)) {
            (any ? alike : never).push_back(figure.title);
            continue;
        }
        html += "<figure class=\"plot\"><figcaption>" + escaped(figure.title) +
                (figure.unit.empty() ? "" : " <span class=\"unit\">[" + escaped(figure.unit) + "]</span>") +
                "</figcaption>" + stripPlot(plot) + "</figure>\n";
    }
    if (!html.empty())
        html =
            "<p class=\"help\">A mark is a seed, the bar the median; hollow marks are of the preset "
            "paper.</p>\n<div "
            "class=\"plots\">\n" +
            html + "</div>\n";
    if (!never.empty())
        html += "<p class=\"help\">Without a value in any run: " + escaped(joined(never)) + ".</p>\n";
    if (!alike.empty())
        html += "<p class=\"help\">Not plotted, because all runs gave one value: " + escaped(joined(alike)) +
                ".</p>\n";
    return html;
}

std::string chapter(const ExperimentResult& experiment, std::int32_t seeds) {
    return "<article class=\"chapter\" id=\"" + anchorOf(experiment) + "\">\n" + chapterHead(experiment) +
           "<div class=\"pair\">\n<div>" +
           section("What the paper shows", paragraphs(experiment.text.paper)) + "</div>\n<div>" +
           section("Our scene", paragraphs(experiment.text.scene)) + "</div>\n</div>\n" +
           section("Film", films(experiment)) + section("Criteria", criteriaTable(experiment, seeds)) +
           section("Findings",
                   experiment.text.findings.empty()
                       ? ""
                       : "<div class=\"words\">" + paragraphs(experiment.text.findings) + "</div>\n") +
           section("Figures over the seeds", figuresTables(experiment, seeds)) + stripPlots(experiment) +
           section("Charts", chartsOf(experiment)) +
           section("See it again", "<div class=\"again\">" + again(experiment, seeds) + "</div>\n") +
           "</article>\n";
}

}  // namespace muster
