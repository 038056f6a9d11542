// Sections about the environments and about models.
#include <algorithm>
#include <cmath>
#include <set>

#include "files/report/markup.h"
#include "lab/study/models/operator_parameters.h"
#include "lab/study/report/study_parts.h"

namespace muster {
namespace {

using Cells = std::map<CellKey, Cell>;

std::string tableHead(const std::vector<std::string>& names) {
    std::string html = "<div class=\"scroll\"><table><thead><tr>";
    for (const std::string& name : names) html += "<th>" + escaped(name) + "</th>";
    return html + "</tr></thead><tbody>\n";
}

std::string tableRow(const std::vector<std::string>& cells) {
    std::string html = "<tr>";
    for (const std::string& cell : cells) html += "<td>" + escaped(cell) + "</td>";
    return html + "</tr>\n";
}

constexpr const char* kTableEnd = "</tbody></table></div>\n";

std::string ratioText(const Cells& cells, const CellKey& key, const std::string& mouse) {
    if (mouse.empty()) return "no value";
    CellKey other = key;
    other.scheme = mouse;
    const PairedTimes pairs = pairedTimes(cellOf(cells, key), cellOf(cells, other));
    const statistics::Estimate ratio = statistics::ratioOfMedians(pairs.first, pairs.second);
    if (!std::isfinite(ratio.value)) return "no value";
    return fixedNumber(ratio.value, 2) + " (" + fixedNumber(ratio.low, 2) + " to " +
           fixedNumber(ratio.high, 2) + ")";
}

double target(const std::string& environment) {
    if (environment == "single-block") return 0.65;
    if (environment == "corridor") return 0.84;
    return environment == "multiple-paths" ? 0.80 : 0.90;
}

std::string trialRow(const Cells& cells, const CellKey& key, const Cell& cell) {
    std::size_t censored = 0;
    std::vector<double> rate, idle, misses;
    for (const auto& [unit, trial] : cell) {
        censored += !trial.result.done;
        if (trial.result.seconds > 0.0) rate.push_back(60.0 * trial.result.commands / trial.result.seconds);
        idle.push_back(trial.result.idleSeconds);
        misses.push_back(trial.misses);
    }
    const std::string aim = key.scheme == "touch" ? fixedNumber(target(key.environment), 2) : "";
    return tableRow({environmentTitle(key.environment), schemeTitle(key.scheme), std::to_string(cell.size()),
                     fixedNumber(statistics::median(timesOf(cell)), 1),
                     ratioText(cells, key, bestMouse(cells, key)), aim, ratioText(cells, key, "mouse-paper"),
                     std::to_string(censored), fixedNumber(statistics::median(rate), 0),
                     fixedNumber(statistics::median(idle), 1), fixedNumber(statistics::median(misses), 0)});
}

/// Medians and ratios of one crowd and setting.
std::string medianTable(const Cells& cells, std::int32_t crowd, const std::string& setting) {
    std::string rows;
    for (const StudyEnvironment& environment : studyEnvironments()) {
        for (const NamedScheme& scheme : namedSchemes()) {
            const CellKey key{std::string(environment.name), std::string(scheme.name), setting, crowd};
            const Cell& cell = cellOf(cells, key);
            if (!cell.empty()) rows += trialRow(cells, key, cell);
        }
    }
    if (rows.empty()) return "<p class=\"none\">There are no trials of models with these.</p>\n";
    return tableHead({"Environment", "Control", "Models' trials", "Median [s]",
                      "To the better full mouse (95 %)", "Target at most", "To the mouse of the paper (95 %)",
                      "Censored", "Commands a minute", "Idle [s]", "Misses"}) +
           rows + kTableEnd;
}

std::string boxPlots(const Cells& cells) {
    std::string html;
    for (const StudyEnvironment& environment : studyEnvironments()) {
        std::vector<BoxRow> rows;
        std::size_t series = 0, most = 0;
        for (const NamedScheme& scheme : namedSchemes()) {
            const Cell& cell = cellOf(cells, {std::string(environment.name), std::string(scheme.name),
                                              "default", studyCrowds().front()});
            if (!cell.empty()) rows.push_back({std::string(scheme.title), series, timesOf(cell)});
            most = std::max(most, cell.size());
            ++series;
        }
        if (rows.empty()) continue;
        const std::string title = std::string(environment.title) + ": models, n = " + std::to_string(most);
        html += "<figure class=\"plot\"><figcaption>" + escaped(title) + "</figcaption>" +
                boxPlot(title, "completion time [s]", rows) + "</figure>\n";
    }
    if (html.empty()) return "<p class=\"none\">There are no trials of models by default settings.</p>\n";
    return "<div class=\"plots charts\">\n" + html + "</div>\n";
}

std::string drawTable(const Cells& cells) {
    std::string rows;
    for (const StudyEnvironment& environment : studyEnvironments()) {
        const DrawShare share = drawShare(cells, std::string(environment.name), studyCrowds().front());
        if (share.draws == 0) continue;
        rows += tableRow({std::string(environment.title), std::to_string(share.draws),
                          std::to_string(share.won), fixedNumber(100.0 * share.won / share.draws, 0) + " %"});
    }
    if (rows.empty()) return "<p class=\"none\">There are no draws of the models' constants.</p>\n";
    return tableHead({"Environment", "Draws of models' constants", "Won by touch", "Share"}) + rows +
           kTableEnd;
}

/// Settings of one constant at a time, with the ratio of touch; the widest first would hide the constants'
/// order.
std::string oneAtATime(const Cells& cells) {
    std::set<std::string> settings;
    for (const auto& [key, cell] : cells)
        if (key.setting.find('=') != std::string::npos) settings.insert(key.setting);
    if (settings.empty()) return "<p class=\"none\">No constant of the models was varied by itself.</p>\n";
    std::string rows;
    for (const std::string& setting : settings) {
        std::vector<std::string> row{setting};
        bool turned = false;
        for (const StudyEnvironment& environment : studyEnvironments()) {
            const CellKey key{std::string(environment.name), "touch", setting, studyCrowds().front()};
            CellKey mouse = key;
            mouse.scheme = bestMouse(cells, key);
            const PairedTimes pairs = pairedTimes(cellOf(cells, key), cellOf(cells, mouse));
            const double ratio = statistics::median(pairs.first) / statistics::median(pairs.second);
            turned = turned || ratio >= 1.0;
            row.push_back(fixedNumber(ratio, 2));
        }
        row.emplace_back(turned ? "turns the order" : "");
        rows += tableRow(row);
    }
    std::vector<std::string> names{"Models' constant"};
    for (const StudyEnvironment& environment : studyEnvironments()) names.emplace_back(environment.title);
    names.emplace_back("");
    return tableHead(names) + rows + kTableEnd;
}

}  // namespace

std::string schemeTitle(const std::string& name) {
    for (const NamedScheme& scheme : namedSchemes())
        if (scheme.name == name) return std::string(scheme.title);
    return name;
}

std::string environmentTitle(const std::string& name) {
    for (const StudyEnvironment& environment : studyEnvironments())
        if (environment.name == name) return std::string(environment.title);
    return name;
}

std::string groupWord(const StudyGroup& group) {
    return group.kind == RunKind::Models ? "models" : "people";
}

std::string environmentSection() {
    const StudyRules& rules = studyRules();
    std::string html = "<section class=\"chapter\"><h2>Environments</h2><p class=\"words\">" +
                       escaped("Version " + std::to_string(kEnvironmentVersion) + ": ground of " +
                               plainNumber(rules.box.width()) + " by " + plainNumber(rules.box.height()) +
                               " m, " + std::to_string(rules.items) +
                               " items, each collected by a character within " +
                               plainNumber(rules.itemRadius) + " m; top speed " + plainNumber(rules.speed) +
                               " m/s; places at the start " + plainNumber(rules.spacing) +
                               " m apart; a trial is censored after " + plainNumber(rules.limit) +
                               " s; seen from above, all of it, on " + plainNumber(rules.width) + " by " +
                               plainNumber(rules.height) + " px of " + plainNumber(rules.mmPerPixel) +
                               " mm.") +
                       "</p>\n<div class=\"plots charts\">\n";
    for (const StudyEnvironment& environment : studyEnvironments())
        html += "<figure class=\"plot\"><figcaption>" + escaped(environment.title) + "</figcaption>" +
                planDrawing(environment) + "<p class=\"help\">" + escaped(environment.description) +
                " Items (orange) of seed 1, obstacles (grey), start of 36 characters (blue).</p></figure>\n";
    return html + "</div></section>\n";
}

std::string modelSections(const StudyGroup& group, const StudyData& data) {
    const auto found = data.cells.find(group);
    const Cells cells = found == data.cells.end() ? Cells() : found->second;
    std::string html = "<section class=\"chapter\"><h2>" +
                       escaped("Operator models, version " + std::to_string(group.operators) +
                               ", in environments of version " + std::to_string(group.environments)) +
                       "</h2><p class=\"words\">Operator models are scripts, no people: they say which "
                       "control permits "
                       "faster work, not what people will do.</p>\n<h3>Completion times of models</h3>\n" +
                       boxPlots(cells);
    for (const std::int32_t crowd : studyCrowds())
        html += "<h3>" + std::to_string(crowd) +
                " characters: medians of models, and ratios with bootstrap intervals</h3>\n" +
                medianTable(cells, crowd, "default");
    html += "<h3>Equal motor constants of models</h3>\n" +
            medianTable(cells, studyCrowds().front(), "equal-motor");
    html += "<h3>Sensitivity: draws of the models' constants</h3>\n" + drawTable(cells);
    html += "<h3>Sensitivity: one constant of the models at a time</h3>\n" + oneAtATime(cells);
    return html + "</section>\n";
}

}  // namespace muster
