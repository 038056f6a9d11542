// muster sweep
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "folders.h"
#include "lab/reproduce/experiments/experiment.h"
#include "lab/reproduce/reproduce.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "muster/parameter_table.h"
#include "report.h"
#include "sweep_parts.h"

namespace muster {
namespace {

struct SweepOptions {
    SweepPlan plan;
    ReproduceDef def;
    int part = -1;
    std::string slurm;
    std::string collect;
    bool json = false;
};

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

void printTable(const SweepPlan& plan, const std::vector<SweepRow>& rows) {
    std::printf("| %s |", plan.parameter.c_str());
    for (const double value : plan.values) std::printf(" %.4g |", value);
    std::printf("\n|---|");
    for (std::size_t i = 0; i < plan.values.size(); ++i) std::printf("---|");
    std::printf("\n");
    for (const SweepRow& row : rows) {
        if (isEmpty(row)) continue;
        std::printf("| %s |", escaped(row.title).c_str());
        for (const std::string& cell : row.cells) std::printf(" %s |", cell.c_str());
        std::printf("\n");
    }
}

int print(const SweepOptions& options, const SweepResults& results) {
    if (options.json)
        printJsonValue(results.entries);
    else
        printTable(options.plan, results.rows);
    return kExitOk;
}

/// The experiments in the order in which they are run; all of them for none.
std::vector<std::string> orderOf(const std::vector<std::string>& named) {
    std::vector<std::string> order;
    for (const auto& experiment : paperExperiments()) {
        const std::string id = experiment->text().id;
        if (named.empty() || std::find(named.begin(), named.end(), id) != named.end()) order.push_back(id);
    }
    return order;
}

/// Checks the options before the first of many runs.
Status check(const SweepOptions& options) {
    if (options.plan.parameter.empty()) return invalidArgument("PARAMETER is required");
    if (options.plan.values.empty()) return invalidArgument("--values is required");
    Parameters probe;
    for (const double value : options.plan.values)
        if (Status s = setParameter(probe, options.plan.parameter, value); !s.ok()) return s;
    if (Status s = checkReproduce(options.def); !s.ok()) return s;
    if (options.part >= 0 && static_cast<std::size_t>(options.part) >= options.plan.parts())
        return invalidArgument("part is " + std::to_string(options.part) + ", expected 0 to " +
                               std::to_string(options.plan.parts() - 1));
    return {};
}

/// Runs one part and prints its file.
int runPart(SweepOptions& options) {
    const auto part = static_cast<std::size_t>(options.part);
    const double value = options.plan.valueOf(part);
    options.def.experiments = {options.plan.experimentOf(part)};
    options.def.settings = {{options.plan.parameter, value}};
    const auto reproduction = reproduce(options.def, [](const ReproduceProgress&) {});
    if (!reproduction.ok()) return reportFailure(reproduction.status());
    SweepResults results;
    results.add(options.plan, value, *reproduction);
    std::fputs(sweepPartText(options.plan, part, results).c_str(), stdout);
    return kExitOk;
}

int writeSlurm(const SweepOptions& options) {
    namespace fs = std::filesystem;
    std::error_code error;
    const std::string program = fs::read_symlink("/proc/self/exe", error).string();
    const std::string folder = fs::absolute(options.slurm + ".parts", error).string();
    const std::string script = slurmScript(options.plan, program,
                                           fs::absolute(options.def.folder, error).string(), folder);
    if (Status s = writeTextFile(options.slurm, script); !s.ok()) return reportFailure(s);
    std::printf("Wrote %s with %zu parts. sbatch %s runs them; then: muster sweep --collect %s\n",
                options.slurm.c_str(), options.plan.parts(), options.slurm.c_str(),
                (options.slurm + ".parts").c_str());
    return kExitOk;
}

int collect(SweepOptions& options) {
    const auto results = collectSweep(options.collect, options.plan);
    return results.ok() ? print(options, *results) : reportFailure(results.status());
}

int sweep(SweepOptions options) {
    if (!options.collect.empty()) return collect(options);
    if (options.def.folder.empty()) options.def.folder = scenariosFolder() + "/paper";
    options.plan.experiments = orderOf(options.def.experiments);
    options.plan.seeds = options.def.seeds;
    if (Status s = check(options); !s.ok()) return reportFailure(s);
    if (!options.slurm.empty()) return writeSlurm(options);
    if (options.part >= 0) return runPart(options);
    SweepResults results;
    Progress bar("sweeping");
    const auto count = static_cast<double>(options.plan.values.size());
    for (std::size_t k = 0; k < options.plan.values.size(); ++k) {
        const double value = options.plan.values[k];
        options.def.settings = {{options.plan.parameter, value}};
        const auto reproduction = reproduce(options.def, [&](const ReproduceProgress& p) {
            bar.show((static_cast<double>(k) + static_cast<double>(p.done) / p.of) / count,
                     p.experiment + " " + p.arm);
        });
        if (!reproduction.ok()) return reportFailure(reproduction.status());
        results.add(options.plan, value, *reproduction);
    }
    return print(options, results);
}

}  // namespace

void addSweepCommand(CommandLine& line) {
    Subcommand command = line.add(kSweepCommand.name, kSweepCommand.about);
    auto options = std::make_shared<SweepOptions>();
    command.option("PARAMETER", options->plan.parameter, "Its name, as muster check --schema lists it.");
    command.option("--values", options->plan.values, "Its values, separated by commas.").separatedBy(',');
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
    const Option slurm = command.option(
        "--slurm", options->slurm,
        "Runs nothing: writes this file, a Slurm job array with a task for each value and experiment.");
    command.option("--part", options->part, "Runs this part only, 0 or more, and prints its file.")
        .range(0, 1000000)
        .excludes(slurm);
    command
        .option("--collect", options->collect, "Runs nothing: shows the results of the parts in this folder.")
        .existingFolder()
        .excludes(slurm);
    command.flag("--json", options->json, "One JSON array on standard output: results.json of every value.");
    command.footer(
        "A table in Markdown: criteria (value against threshold) and figures (median over the seeds) of the "
        "preset muster.\n"
        "What an arm of an experiment sets itself stays as it is.\n"
        "Examples:\n"
        "  muster sweep field.range --values 0.5,1,1.5,2 --experiments X4,X9\n"
        "  muster sweep density.min --values 0.9,1.3,1.8 --experiments X8 --seeds 5\n"
        "  muster sweep field.range --values 0.5,1,1.5,2 --slurm sweep.sh && sbatch --wait sweep.sh\n"
        "  muster sweep --collect sweep.sh.parts");
    command.run([options] { return sweep(*options); });
}

}  // namespace muster
