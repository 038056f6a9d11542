#include "sweep_parts.h"

#include <charconv>
#include <cmath>
#include <cstdio>
#include <utility>

#include "base/text_file.h"

namespace muster {
namespace {

constexpr const char* kFormat = "muster-sweep-part";

std::string shortText(double value) {
    if (std::isnan(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    return text;
}

/// The shortest text that reads back as the same number.
std::string exactText(double value) {
    char text[64];
    const auto end = std::to_chars(text, text + sizeof(text), value).ptr;
    return {text, end};
}

/// The rows of one setting; all settings have the same titles in the same order.
std::vector<SweepRow> rowsOf(const Reproduction& reproduction) {
    std::vector<SweepRow> rows;
    for (const ExperimentResult& e : reproduction.experiments) {
        for (const Verdict& v : e.verdicts) {
            if (!v.binding) continue;
            const std::string sign = v.comparison == Comparison::AtLeast ? " (at least " : " (at most ";
            rows.push_back({e.text.id + ": " + v.criterion + sign + shortText(v.threshold) + ")",
                            {shortText(v.value) + (v.pass ? "" : " fails")}});
        }
        for (const Arm& arm : e.arms) {
            if (arm.preset != "muster") continue;
            for (const FigureInfo& figure : e.figures) {
                const std::string unit = figure.unit.empty() ? "" : " [" + figure.unit + "]";
                rows.push_back({e.text.id + ", " + arm.title + ": " + figure.title + unit,
                                {shortText(median(e.samples.values(arm.id, arm.preset, figure.name)))}});
            }
        }
    }
    return rows;
}

template <class Values, class Write>
std::string joined(const Values& values, const char* between, Write write) {
    std::string text;
    for (const auto& value : values) text += (text.empty() ? "" : between) + write(value);
    return text;
}

/// A path or name for a shell, whatever it holds.
std::string quoted(const std::string& text) {
    std::string safe = "'";
    for (const char c : text) safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
    return safe + "'";
}

Json toJson(const SweepPlan& plan) {
    Json values = Json::array(), experiments = Json::array();
    for (const double value : plan.values) values.push(value);
    for (const std::string& id : plan.experiments) experiments.push(id);
    return {{"parameter", plan.parameter},
            {"values", values},
            {"experiments", experiments},
            {"seeds", plan.seeds}};
}

/// The plan that a part's file holds; nothing where it holds none.
bool readPlan(const Json& part, SweepPlan& plan) {
    const Json* of = part.find("sweep");
    if (of == nullptr || !of->isObject()) return false;
    const Json *parameter = of->find("parameter"), *values = of->find("values"),
               *experiments = of->find("experiments"), *seeds = of->find("seeds");
    if (parameter == nullptr || !parameter->isText() || values == nullptr || !values->isArray() ||
        experiments == nullptr || !experiments->isArray() || seeds == nullptr || !seeds->isWhole())
        return false;
    plan = {};
    plan.parameter = parameter->text();
    plan.seeds = seeds->whole<std::int32_t>();
    for (const Json& value : values->elements()) {
        if (!value.isNumber()) return false;
        plan.values.push_back(value.number());
    }
    for (const Json& id : experiments->elements()) {
        if (!id.isText()) return false;
        plan.experiments.push_back(id.text());
    }
    return plan.parts() > 0;
}

/// Adds a part to the column of its value.
bool addPart(const Json& part, std::size_t column, std::size_t& row, SweepResults& results) {
    const Json *rows = part.find("rows"), *entries = part.find("results");
    if (rows == nullptr || !rows->isArray() || entries == nullptr || !entries->isArray()) return false;
    for (const Json& cell : rows->elements()) {
        if (!cell.isArray() || cell.size() != 2 || !cell[0].isText() || !cell[1].isText()) return false;
        if (column == 0)
            results.rows.push_back({cell[0].text(), {cell[1].text()}});
        else if (row < results.rows.size() && results.rows[row].title == cell[0].text())
            results.rows[row].cells.push_back(cell[1].text());
        else
            return false;
        ++row;
    }
    for (const Json& entry : entries->elements()) results.entries.push(entry);
    return true;
}

}  // namespace

void SweepResults::add(const SweepPlan& plan, double value, const Reproduction& reproduction) {
    const std::vector<SweepRow> column = rowsOf(reproduction);
    if (rows.empty())
        rows = column;
    else
        for (std::size_t i = 0; i < rows.size(); ++i) rows[i].cells.push_back(column[i].cells.front());
    const auto values = parseJson(resultsJson(reproduction), "results.json");
    for (Json entry : values->elements()) {
        entry[plan.parameter] = value;
        entries.push(std::move(entry));
    }
}

std::string sweepPartText(const SweepPlan& plan, std::size_t part, const SweepResults& results) {
    Json rows = Json::array();
    for (const SweepRow& row : results.rows) rows.push(Json::array({row.title, row.cells.front()}));
    Json value = {{"format", kFormat}, {"version", 1}, {"sweep", toJson(plan)}};
    value["part"] = static_cast<std::int64_t>(part);
    value["rows"] = std::move(rows);
    value["results"] = results.entries;
    return indentedJson(value, 1) + "\n";
}

Result<SweepResults> collectSweep(const std::string& folder, SweepPlan& plan) {
    SweepResults results;
    std::size_t parts = 1, row = 0;
    for (std::size_t k = 0; k < parts; ++k) {
        const std::string path = folder + "/" + std::to_string(k) + ".json";
        const auto text = readTextFile(path);
        if (!text.ok()) return text.status();
        const auto part = parseJson(*text, path);
        if (!part.ok()) return part.status();
        SweepPlan own;
        const Json* format = part->find("format");
        if (format == nullptr || !format->isText() || format->text() != kFormat || !readPlan(*part, own))
            return Status(StatusCode::ParseError, path + ": is no part of a sweep");
        if (k == 0) plan = own;
        parts = plan.parts();
        const Json* number = part->find("part");
        const bool same = own == plan && number != nullptr && number->isWhole() &&
                          number->whole<std::int64_t>() == static_cast<std::int64_t>(k);
        if (k % plan.experiments.size() == 0) row = 0;
        if (!same || !addPart(*part, k / plan.experiments.size(), row, results))
            return Status(StatusCode::ParseError, path + ": is of another sweep than 0.json");
    }
    return results;
}

std::string slurmScript(const SweepPlan& plan, const std::string& program, const std::string& scenarios,
                        const std::string& folder) {
    const std::string values = joined(plan.values, ",", exactText);
    const std::string experiments = joined(plan.experiments, ",", [](const std::string& id) { return id; });
    std::string about = "# ";
    about += std::to_string(plan.parts()) + " parts of a sweep of " + plan.parameter;
    about +=
        ": each value with each experiment.\n"
        "#   sbatch THIS_FILE\n"
        "#   muster sweep --collect FOLDER      once all have ended: the same table as without Slurm\n";
    std::string text = slurmHead(about, "muster-sweep", plan.parts());
    text +=
        "#SBATCH --output=/dev/null\n"
        "set -eu\n";
    text += "folder=" + quoted(folder) + "\n";
    text +=
        "mkdir -p \"$folder\"\n"
        "part=$folder/$SLURM_ARRAY_TASK_ID\n"
        "exec 2>\"$part.log\"\n";
    text += quoted(program) + " sweep " + quoted(plan.parameter) + " --values " + values;
    text += " --experiments " + experiments + " --seeds " + std::to_string(plan.seeds);
    text += " --scenarios " + quoted(scenarios) + " \\\n";
    text +=
        "    --threads \"${SLURM_CPUS_PER_TASK:-1}\" --part \"$SLURM_ARRAY_TASK_ID\" >\"$part.json.part\"\n"
        "mv \"$part.json.part\" \"$part.json\"\n";
    return text;
}

}  // namespace muster
