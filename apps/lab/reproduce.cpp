// muster reproduce
#include <unistd.h>

#include <cstdio>
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "files/report/markup.h"
#include "folders.h"
#include "lab/reproduce/reproduce.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "options.h"
#include "report.h"

namespace muster {
namespace {

namespace fs = std::filesystem;

struct ReproduceOptions {
    ReproduceDef def;
    std::string out = "reproduction";
    bool json = false;
};

/// The names of all experiments, in their order.
std::vector<std::string> experimentIds() {
    std::vector<std::string> ids;
    for (const auto& experiment : paperExperiments()) ids.push_back(experiment->text().id);
    return ids;
}

/// The error for the name of an experiment; empty where it is known.
std::string knownExperiment(const std::string& wanted) {
    std::string known;
    for (const std::string& id : experimentIds()) {
        if (lowerCase(id) == lowerCase(wanted)) return {};
        known += (known.empty() ? "" : ", ") + id;
    }
    return "found \"" + wanted.substr(0, 40) + "\", expected some of " + known;
}

/// Creates the folder and checks that the report can be written, before the long work begins.
Status prepareFolder(const std::string& folder) {
    std::error_code error;
    if (fs::exists(folder, error) && !fs::is_directory(folder, error))
        return {StatusCode::IoError, folder + ": found a file, expected a folder or a name that is free"};
    fs::create_directories(folder, error);
    if (!fs::is_directory(folder, error)) return {StatusCode::IoError, folder + ": cannot be made a folder"};
    if (::access(folder.c_str(), W_OK | X_OK) != 0)
        return {StatusCode::IoError, folder + ": nothing can be written into this folder"};
    for (const char* name : {"index.html", "results.json", "summary.md"}) {
        const std::string path = folder + "/" + name;
        if (fs::exists(path, error) &&
            (!fs::is_regular_file(path, error) || ::access(path.c_str(), W_OK) != 0))
            return {StatusCode::IoError, path + ": cannot be written"};
    }
    return {};
}

/// Progress: a rewritten line on a terminal; in a log one line per completed experiment.
class ReproduceWatch {
public:
    void operator()(const ReproduceProgress& p) {
        bar_.show(static_cast<double>(p.done) / p.of, std::to_string(p.done) + " of " + std::to_string(p.of) +
                                                          " runs  " + p.experiment + " " + p.arm);
        if (terminal_ || p.experimentDone < p.experimentOf) return;
        std::fprintf(stderr, "%-3s  %s: complete, %d of %d runs in all\n", p.experiment.c_str(),
                     p.title.c_str(), p.done, p.of);
    }

private:
    Progress bar_{"reproducing"};
    bool terminal_ = isatty(STDERR_FILENO) != 0;
};

Result<Reproduction> runAll(const ReproduceDef& def) {
    ReproduceWatch watch;
    return reproduce(def, [&](const ReproduceProgress& progress) { watch(progress); });
}

int runReproduce(ReproduceOptions options) {
    if (options.def.folder.empty()) options.def.folder = scenariosFolder() + "/paper";
    if (Status s = checkReproduce(options.def); !s.ok()) return reportFailure(s);
    if (Status s = prepareFolder(options.out); !s.ok()) return reportFailure(s);
    const std::string when = minuteNow();
    auto reproduction = runAll(options.def);
    if (!reproduction.ok()) return reportFailure(reproduction.status());
    reproduction->version = MUSTER_VERSION;
    reproduction->when = when;
    if (Status s = writeReport(*reproduction, options.out); !s.ok()) return reportFailure(s);
    if (options.json) {
        std::printf("%s", resultsJson(*reproduction).c_str());
    } else {
        std::printf("%s%s\n", summaryText(*reproduction).c_str(),
                    (fs::path(options.out) / "index.html").string().c_str());
    }
    return reproduction->passed() ? kExitOk : kExitNotReproduced;
}

}  // namespace

void addReproduceCommand(CommandLine& line) {
    Subcommand command = line.add(kReproduceCommand.name, kReproduceCommand.about);
    auto options = std::make_shared<ReproduceOptions>();
    command.option("EXPERIMENTS", options->def.experiments, "Some of X1 to X11 and X13; without it all.")
        .check(knownExperiment);
    command.option("--seeds", options->def.seeds, "Runs of each kind, by seed.").range(1, 1000);
    command
        .option("--out", options->out, "Folder for index.html, results.json, summary.md and the film strips.")
        .check([](const std::string& name) -> std::string {
            return name.empty() ? "found no name, expected a folder" : "";
        });
    command
        .option("--threads", options->def.threads,
                "Runs side by side; 0 takes what the machine has. Results are the same.")
        .range(0, 256);
    command.option("--scenarios", options->def.folder, "Folder of the experiments' scenarios.");
    command.flag("--json", options->json, "results.json on standard output in place of the table.");
    command.footer(
        "The exit code is 3 where a criterion of the preset muster fails.\n"
        "Examples:\n"
        "  muster reproduce\n"
        "  muster reproduce X4 X11 --seeds 3 --out /tmp/report");
    command.run([options] { return runReproduce(*options); });
}

}  // namespace muster
