// muster reproduce
#include <cmath>
#include <cstdio>
#include <string>
#include <vector>

#include "commands.h"
#include "folders.h"
#include "muster/experiments/reproduce.h"
#include "options.h"
#include "report.h"

namespace muster {
namespace {

struct ReproduceOptions {
    ReproduceDef def;
    std::string out = "reproduction";
    bool json = false;
};

std::string numberText(double value) {
    if (std::isnan(value)) return "-";
    char text[32];
    std::snprintf(text, sizeof(text), "%.4g", value);
    return text;
}

void printVerdicts(const Reproduction& reproduction) {
    for (const ExperimentResult& experiment : reproduction.experiments) {
        std::printf("%s  %s\n", experiment.text.id.c_str(), experiment.text.title.c_str());
        for (const Verdict& v : experiment.verdicts) {
            const char* word = v.pass ? "pass" : v.binding ? "FAIL" : "no";
            std::printf("  %-4s  %-6s  %s: %s%s%s (%s to %s over %d), %s %s\n", word, v.preset.c_str(), v.criterion.c_str(),
                        numberText(v.value).c_str(), v.unit.empty() ? "" : " ", v.unit.c_str(), numberText(v.low).c_str(),
                        numberText(v.high).c_str(), v.seeds, v.comparison == Comparison::AtLeast ? "at least" : "at most",
                        numberText(v.threshold).c_str());
        }
    }
}

int countFailed(const Reproduction& reproduction, int& judged) {
    int failed = 0;
    for (const ExperimentResult& experiment : reproduction.experiments) {
        for (const Verdict& v : experiment.verdicts) {
            if (!v.binding) continue;
            ++judged;
            failed += v.pass ? 0 : 1;
        }
    }
    return failed;
}

int runReproduce(ReproduceOptions options) {
    if (options.def.folder.empty()) options.def.folder = scenariosFolder() + "/paper";
    Progress bar("reproducing");
    const auto progress = [&](std::int32_t done, std::int32_t of, const std::string& what) {
        bar.show(static_cast<double>(done) / of, what);
    };
    const auto reproduction = reproduce(options.def, progress);
    if (!reproduction.ok()) return reportFailure(reproduction.status());
    if (Status s = writeReport(*reproduction, options.out); !s.ok()) return reportFailure(s);
    int judged = 0;
    const int failed = countFailed(*reproduction, judged);
    if (options.json) {
        std::printf("%s", resultsJson(*reproduction).c_str());
    } else {
        printVerdicts(*reproduction);
        std::printf("%d of %d criteria hold; %.0f s; %s/index.html\n", judged - failed, judged, reproduction->seconds,
                    options.out.c_str());
    }
    return reproduction->passed() ? kExitOk : kExitNotReproduced;
}

}  // namespace

void addReproduceCommand(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("reproduce", "Runs the paper's experiments and writes a report.");
    auto options = std::make_shared<ReproduceOptions>();
    command->add_option("EXPERIMENTS", options->def.experiments, "Some of X1 to X11 and X13; without it all.");
    command->add_option("--seeds", options->def.seeds, "Runs of each kind, by seed.")->check(CLI::Range(1, 1000));
    command->add_option("--out", options->out, "Folder for index.html, results.json, summary.md and the film strips.");
    command->add_option("--threads", options->def.threads, "Runs side by side; 0 takes what the machine has. Results are the same.")
        ->check(CLI::Range(0, 256));
    command->add_option("--scenarios", options->def.folder, "Folder of the experiments' scenarios.");
    command->add_flag("--json", options->json, "results.json on standard output as well.");
    command->footer(
        "The exit code is 3 where a criterion of the preset muster fails.\n"
        "Examples:\n"
        "  muster reproduce\n"
        "  muster reproduce X4 X11 --seeds 3 --out /tmp/report");
    command->callback([options, &exitCode] { exitCode = runReproduce(*options); });
}

}  // namespace muster
