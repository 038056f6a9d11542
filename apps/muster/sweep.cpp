// muster sweep
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <string>
#include <vector>

#include "commands.h"
#include "folders.h"
#include "muster/parameter_table.h"
#include "report.h"
#include "reproduce/reproduce.h"

namespace muster {
namespace {

struct SweepOptions {
    std::string parameter;
    std::vector<double> values;
    ReproduceDef def;
    bool json = false;
};

/// A row of the table: its title, then its value for each setting.
struct SweepRow {
    std::string title;
    std::vector<std::string> cells;
};

std::string shortText(double value) {
    if (std::isnan(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    return text;
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

/// Replaces the bar, which would end the table cell.
std::string escaped(const std::string& title) {
    std::string text;
    for (const char c : title) text += c == '|' ? std::string("\\|") : std::string(1, c);
    return text;
}

/// True where an arm has no such result, whatever the value.
bool isEmpty(const SweepRow& row) {
    return std::all_of(row.cells.begin(), row.cells.end(),
                       [](const std::string& cell) { return cell == "-"; });
}

void printTable(const SweepOptions& options, const std::vector<SweepRow>& rows) {
    std::printf("| %s |", options.parameter.c_str());
    for (const double value : options.values) std::printf(" %s |", shortText(value).c_str());
    std::printf("\n|---|");
    for (std::size_t i = 0; i < options.values.size(); ++i) std::printf("---|");
    std::printf("\n");
    for (const SweepRow& row : rows) {
        if (isEmpty(row)) continue;
        std::printf("| %s |", escaped(row.title).c_str());
        for (const std::string& cell : row.cells) std::printf(" %s |", cell.c_str());
        std::printf("\n");
    }
}

/// Checks the options before the first of many runs.
Status check(const SweepOptions& options) {
    Parameters probe;
    for (const double value : options.values)
        if (Status s = setParameter(probe, options.parameter, value); !s.ok()) return s;
    return checkReproduce(options.def);
}

int sweep(SweepOptions options) {
    if (options.def.folder.empty()) options.def.folder = scenariosFolder() + "/paper";
    if (Status s = check(options); !s.ok()) return reportFailure(s);
    std::vector<SweepRow> rows;
    Progress bar("sweeping");
    Json results = Json::array();
    const auto count = static_cast<double>(options.values.size());
    for (std::size_t k = 0; k < options.values.size(); ++k) {
        options.def.settings = {{options.parameter, options.values[k]}};
        const auto reproduction = reproduce(options.def, [&](const ReproduceProgress& p) {
            bar.show((static_cast<double>(k) + static_cast<double>(p.done) / p.of) / count,
                     p.experiment + " " + p.arm);
        });
        if (!reproduction.ok()) return reportFailure(reproduction.status());
        const std::vector<SweepRow> column = rowsOf(*reproduction);
        if (k == 0)
            rows = column;
        else
            for (std::size_t i = 0; i < rows.size(); ++i) rows[i].cells.push_back(column[i].cells.front());
        const auto values = parseJson(resultsJson(*reproduction), "results.json");
        for (Json entry : values->elements()) {
            entry[options.parameter] = options.values[k];
            results.push(std::move(entry));
        }
    }
    if (options.json)
        printJsonValue(results);
    else
        printTable(options, rows);
    return kExitOk;
}

}  // namespace

void addSweepCommand(CommandLine& line) {
    Subcommand command = line.add("sweep",
                                  "Runs the paper's experiments with several values of a parameter.");
    auto options = std::make_shared<SweepOptions>();
    command.option("PARAMETER", options->parameter, "Its name, as muster check --schema lists it.")
        .required();
    command.option("--values", options->values, "Its values, separated by commas.")
        .required()
        .separatedBy(',');
    command
        .option("--experiments", options->def.experiments,
                "Some of X1 to X11 and X13, separated by commas; without it all.")
        .separatedBy(',');
    options->def.seeds = 3;
    command.option("--seeds", options->def.seeds, "Runs of each kind, by seed.").range(1, 1000);
    command
        .option("--threads", options->def.threads,
                "Runs side by side; 0 takes what the machine has. Results are the same.")
        .range(0, 256);
    command.option("--scenarios", options->def.folder, "Folder of the experiments' scenarios.");
    command.flag("--json", options->json, "One JSON array on standard output: results.json of every value.");
    command.footer(
        "A table in Markdown: criteria (value against threshold) and figures (median over the seeds) of the "
        "preset muster.\n"
        "What an arm of an experiment sets itself stays as it is.\n"
        "Examples:\n"
        "  muster sweep field.range --values 0.5,1,1.5,2 --experiments X4,X9\n"
        "  muster sweep density.min --values 0.9,1.3,1.8 --experiments X8 --seeds 5");
    command.run([options] { return sweep(*options); });
}

}  // namespace muster
