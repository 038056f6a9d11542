// muster verify
#include <cstdio>
#include <memory>
#include <string>

#include "base/text_file.h"
#include "lab/verify/verify.h"
#include "lab_commands.h"
#include "lab_commands_list.h"
#include "options.h"
#include "others.h"
#include "report.h"

namespace muster {
namespace {

struct VerifyOptions {
    VerifyDef def;
    std::string page = "verification.html";
    bool json = false;
    bool markdown = false;
    bool noPage = false;
    bool others = false;
};

/// The error for the name of a test; empty where it is known.
std::string knownTest(const std::string& name) {
    VerifyDef one{.only = {name}};
    const auto rows = chosenRows(one, verifyRows());
    return rows.ok() ? "" : rows.status().message();
}

Status canWrite(const std::string& path) {
    std::FILE* file = std::fopen(path.c_str(), "ab");
    if (file == nullptr) return {StatusCode::IoError, path + ": cannot be written"};
    std::fclose(file);
    return {};
}

int runVerify(const VerifyOptions& options) {
    if (!options.noPage)
        if (Status s = canWrite(options.page); !s.ok()) return reportFailure(s);
    Progress bar("verifying");
    auto verification = verify(options.def,
                               [&](double share, const std::string& what) { bar.show(share, what); });
    if (!verification.ok()) return reportFailure(verification.status());
    verification->version = MUSTER_VERSION;
    verification->when = minuteNow();
    if (options.others) verification->others = besideOthers(*verification);
    if (!options.noPage)
        if (Status s = writeTextFile(options.page, verificationPage(*verification)); !s.ok())
            return reportFailure(s);
    if (options.json || options.markdown) {
        const std::string text = options.json ? verificationJson(*verification)
                                              : verificationMarkdown(*verification);
        std::printf("%s", text.c_str());
    } else {
        std::printf("%s", verificationText(*verification).c_str());
        if (!options.noPage) std::printf("%s\n", options.page.c_str());
    }
    return verification->exitCode();
}

}  // namespace

void addVerifyCommand(CommandLine& line) {
    Subcommand command = line.add(kVerifyCommand.name, kVerifyCommand.about);
    auto options = std::make_shared<VerifyOptions>();
    command
        .option("--only", options->def.only,
                "Some tests (\"RiMEA 4\", rimea4) or suites (RiMEA, IMO, NIST, ISO, Data).")
        .separatedBy(',')
        .check(knownTest);
    command.flag("--brief", options->def.brief,
                 "The tests that take little time, with one seed where it says enough.");
    command.option("--seeds", options->def.seeds, "Runs of each case; 0 takes as many as each test asks for.")
        .range(0, 1000);
    command
        .option("--threads", options->def.threads,
                "Runs side by side; 0 takes what the machine has. Results are the same.")
        .range(0, 256);
    command.option("--page", options->page, "File of the page with plots.")
        .check([](const std::string& name) -> std::string {
            return name.empty() ? "found no name, expected a file" : "";
        });
    command.flag("--no-page", options->noPage, "Writes no page.");
    command.flag("--others", options->others,
                 "Adds the same scenes by JuPedSim, where its package is found, and recorded figures.");
    const Option json = command.flag("--json", options->json,
                                     "JSON on standard output in place of the table.");
    command.flag("--markdown", options->markdown, "The table as Markdown, for documents.").excludes(json);
    command.footer(
        "The exit code is 1 where a test fails. Tests that cannot be run are listed as missing and count as "
        "not passed.\n"
        "Examples:\n"
        "  muster verify\n"
        "  muster verify --only \"RiMEA 4\",IMO --seeds 10\n"
        "  muster verify --brief --json --no-page");
    command.run([options] { return runVerify(*options); });
}

}  // namespace muster
