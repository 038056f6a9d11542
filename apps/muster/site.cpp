// muster site
#include <cstdio>
#include <memory>

#include "commands.h"
#include "folders.h"
#include "json/json.h"
#include "report.h"
#include "site_writer.h"

namespace muster {
namespace {

struct SiteOptions {
    SiteDef def;
    bool json = false;
};

int run(SiteOptions& options) {
    SiteDef& def = options.def;
    if (def.scenarioFolder.empty()) def.scenarioFolder = scenariosFolder();
    if (def.pageFolder.empty()) def.pageFolder = pageFolder();
    if (def.engineFolder.empty()) def.engineFolder = engineFolder();
    const auto report = writeSite(def);
    if (!report.ok()) {
        std::fprintf(stderr, "muster site: %s\n", report.status().message().c_str());
        return 1;
    }
    if (options.json) {
        const Json value = {{"folder", def.output},
                            {"files", report->files},
                            {"bytes", report->bytes},
                            {"scenarios", report->scenarios}};
        std::printf("%s\n", indentedJson(value, 2).c_str());
    } else {
        std::printf(
            "Wrote %zu files, %.1f MB, with %zu scenarios to %s. Any web host can serve that folder.\n",
            report->files, static_cast<double>(report->bytes) / 1e6, report->scenarios, def.output.c_str());
    }
    return 0;
}

}  // namespace

void addSiteCommand(CommandLine& line) {
    Subcommand command = line.add("site", "Writes a folder with the studio that any web host serves.");
    auto options = std::make_shared<SiteOptions>();
    options->def.output = "site";
    options->def.scenario = "fountain";
    command.option("-o,--output", options->def.output, "Folder to write; an older site there is replaced.");
    command.option("--first", options->def.scenario, "Scenario that is shown first.");
    command.option("--scenarios", options->def.scenarioFolder, "Folder of the picker's scenarios.")
        .existingFolder();
    command.option("--page", options->def.pageFolder, "Folder of the built page.").existingFolder();
    command.option("--engine", options->def.engineFolder, "Folder of the engine for browsers.")
        .existingFolder();
    command.flag("--json", options->json, "One JSON value on standard output.");
    command.footer(
        "The page runs the engine itself: no server is needed, and after the first visit no network. Takes "
        "are\n"
        "kept in the browser. From the sources, ./run -- site builds what is missing, then writes the site.\n"
        "Examples:\n"
        "  muster site -o public\n"
        "  muster site --scenarios ours --first harbour");
    command.run([options] { return run(*options); });
}

}  // namespace muster
