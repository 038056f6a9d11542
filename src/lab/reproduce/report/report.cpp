// The report's files.
#include <cmath>
#include <filesystem>

#include "base/text_file.h"
#include "files/report/markup.h"
#include "json/json.h"
#include "lab/reproduce/report/drawings.h"
#include "lab/reproduce/reproduce.h"
#include "muster/scenario.h"

namespace muster {
namespace {

Json orNull(double value) {
    return std::isfinite(value) ? Json(value) : Json(nullptr);
}

/// One film strip per arm that was filmed: x4-film.svg, where there are several x4-film-transport-paper.svg.
Status writeFilms(const ExperimentResult& experiment, const std::string& folder) {
    for (const Arm& arm : experiment.arms) {
        const auto& runs = experiment.samples.runs(arm.id, arm.preset);
        if (runs.empty() || runs.front().film.empty()) continue;
        std::string name = lowerCase(experiment.text.id) + "-film";
        if (experiment.arms.size() > 1)
            name += "-" + arm.id + (arm.preset == "muster" ? "" : "-" + arm.preset);
        name += ".svg";
        const std::string path = (std::filesystem::path(folder) / name).string();
        if (Status s = writeTextFile(path, filmStrip(runs.front().film)); !s.ok()) return s;
    }
    return {};
}

}  // namespace

std::string resultsJson(const Reproduction& reproduction) {
    Json all = Json::array();
    for (const ExperimentResult& experiment : reproduction.experiments) {
        for (const Verdict& v : experiment.verdicts) {
            all.push({{"experiment", experiment.text.id},
                      {"criterion", v.criterion},
                      {"preset", v.preset},
                      {"value", orNull(v.value)},
                      {"threshold", orNull(v.threshold)},
                      {"pass", v.pass},
                      {"binding", v.binding},
                      {"seeds", v.seeds},
                      {"low", orNull(v.low)},
                      {"high", orNull(v.high)}});
        }
    }
    return indentedJson(all, 2) + "\n";
}

Status writeReport(const Reproduction& reproduction, const std::string& folder) {
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (!std::filesystem::is_directory(folder, error))
        return {StatusCode::IoError, folder + ": cannot be made a folder"};
    if (Status s = writeTextFile(folder + "/results.json", resultsJson(reproduction)); !s.ok()) return s;
    if (Status s = writeTextFile(folder + "/index.html", reportHtml(reproduction)); !s.ok()) return s;
    if (Status s = writeTextFile(folder + "/summary.md", summaryMarkdown(reproduction)); !s.ok()) return s;
    for (const ExperimentResult& experiment : reproduction.experiments)
        if (Status s = writeFilms(experiment, folder); !s.ok()) return s;
    return {};
}

}  // namespace muster
