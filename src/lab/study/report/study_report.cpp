#include "lab/study/report/study_report.h"

#include <cmath>
#include <filesystem>
#include <set>

#include "base/text_file.h"
#include "files/report/markup.h"
#include "json/json.h"
#include "lab/study/report/study_parts.h"

namespace muster {
namespace {

Json orNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

Json resultRow(const StudyGroup& group, const std::map<CellKey, Cell>& cells, const CellKey& key,
               const Cell& cell) {
    CellKey mouse = key;
    mouse.scheme = bestMouse(cells, key);
    const PairedTimes pairs = pairedTimes(cell, cellOf(cells, mouse));
    const statistics::Estimate ratio = statistics::ratioOfMedians(pairs.first, pairs.second);
    Json row{{"environment", key.environment},
             {"control", key.scheme},
             {"kind", groupWord(group)},
             {"n", static_cast<std::int64_t>(cell.size())},
             {"median_s", orNull(statistics::median(timesOf(cell)))},
             {"ratio_to_best_mouse", orNull(ratio.value)},
             {"low", orNull(ratio.low)},
             {"high", orNull(ratio.high)}};
    const DrawShare share = drawShare(cells, key.environment, key.crowd);
    const bool drawn = key.scheme == "touch" && key.setting == "default" && share.draws > 0;
    row["share_of_draws"] = drawn ? Json(static_cast<double>(share.won) / share.draws) : Json(nullptr);
    row["crowd"] = key.crowd;
    row["setting"] = key.setting;
    row["environments_version"] = group.environments;
    row["operators_version"] = group.operators;
    return row;
}

Json results(const StudyData& data) {
    Json rows = Json::array();
    for (const auto& [group, cells] : data.cells)
        for (const auto& [key, cell] : cells)
            if (key.setting.empty() || key.setting == "default" || key.setting == "equal-motor")
                rows.push(resultRow(group, cells, key, cell));
    return rows;
}

std::string runSection(const StudyData& data) {
    std::string html =
        "<section class=\"chapter\"><h2>Runs</h2><div "
        "class=\"scroll\"><table><thead><tr><th>Run</th><th>Kind</th><th>State"
        "</th><th>Began</th><th>Note</th></tr></thead><tbody>\n";
    for (const StudyRun& run : data.runs) {
        const char* kind = run.kind == RunKind::Models   ? "models"
                           : run.kind == RunKind::People ? "a person"
                                                         : "test, never counted";
        const char* state = run.state == RunState::Running    ? "running or cut off"
                            : run.state == RunState::Complete ? "complete"
                                                              : "broken off";
        html += "<tr><td>" + std::to_string(run.id) + "</td><td>" + kind + "</td><td>" + state + "</td><td>" +
                escaped(run.started) + "</td><td>" + escaped(run.note) + "</td></tr>\n";
    }
    html += "</tbody></table></div>\n";
    for (const auto& [group, count] : data.brokenOff)
        html += "<p>" +
                escaped(std::to_string(count) + " trials of " + groupWord(group) + " were not completed.") +
                "</p>\n";
    return html + "</section>\n";
}

std::string page(const StudyData& data, const std::string& version) {
    std::string html =
        "<!doctype html>\n<html lang=\"en\" xmlns=\"http://www.w3.org/1999/xhtml\">\n<head>\n<meta "
        "charset=\"utf-8\"/>\n"
        "<meta name=\"viewport\" content=\"width=device-width, initial-scale=1\"/>\n"
        "<meta name=\"color-scheme\" content=\"light dark\"/>\n<meta http-equiv=\"Content-Security-Policy\" "
        "content=\"default-src 'none'; style-src 'unsafe-inline'\"/>\n<title>Muster: touch and "
        "mouse</title>\n<style>\n" +
        pageStyle() +
        "</style>\n</head>\n<body>\n<main>\n<header><h1>Touch and mouse</h1><p class=\"lede\">The study "
        "after section 7.5 of "
        "Henry, Shum and Komura (2014), with Muster " +
        escaped(version) +
        ". Operator models and people are reported apart; every caption says which. Several versions stand "
        "beside each "
        "other and are never pooled.</p></header>\n" +
        environmentSection();
    std::set<StudyGroup> groups;
    for (const StudyRun& run : data.runs)
        if (run.kind != RunKind::Test)
            groups.insert({run.kind, run.environments, run.kind == RunKind::People ? 0 : run.operators});
    bool models = false, people = false;
    for (const StudyGroup& group : groups) {
        const bool isModels = group.kind == RunKind::Models;
        (isModels ? models : people) = true;
        html += isModels ? modelSections(group, data) : peopleSections(group, data);
    }
    if (!models) html += "<p class=\"none\">There are no runs of models.</p>\n";
    if (!people) html += "<p class=\"none\">There are no runs of people.</p>\n";
    return html + runSection(data) + "</main>\n</body>\n</html>\n";
}

}  // namespace

Status writeStudyReport(StudyStore& store, const std::string& folder, const std::string& version) {
    const auto data = readStudy(store);
    if (!data.ok()) return data.status();
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder, error))
        return {StatusCode::IoError, "the folder '" + folder + "' cannot be made"};
    if (Status s = writeTextFile(folder + "/report.html", page(*data, version)); !s.ok()) return s;
    return writeTextFile(folder + "/results.json", printJson(results(*data)) + "\n");
}

}  // namespace muster
