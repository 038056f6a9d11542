// muster studio
#include "studio.h"

#include <memory>

#include "commands.h"
#include "folders.h"

namespace muster {
void addStudioCommand(CommandLine& line) {
    Subcommand command = line.add("studio", "Serves the studio: steer a crowd in your browser.");
    auto options = std::make_shared<StudioOptions>();
    command.option("SCENARIO", options->scenario, "Loaded first: a name of the folder or a file.");
    command.option("--port", options->port, "Port; the next free one where it is in use.").range(1, 65535);
    command.option("--scenarios", options->scenarioFolder, "Folder of the picker's scenarios.")
        .existingFolder();
    command.option("--page", options->pageFolder, "Folder of the built page.").existingFolder();
    command
        .option("--engine", options->engineFolder,
                "Folder of the engine for browsers, with which pages go on where the server is lost.")
        .existingFolder();
    command.option("--takes", options->takesFolder, "Folder in which recordings are kept.");
    command.option("--places", options->placesFolder, "Folder in which places are kept by their names.");
    command.option("--site", options->site,
                   "Address of your site (muster site): links to places and takes then open there, too.");
    command.option("--threads", options->threads, "Threads of the simulation; 0 takes what the machine has.")
        .range(0, 256);
    command.flag(
        "--lan", options->lan,
        "Other machines of your network can connect, by a link with a secret token; it is printed, as "
        "a QR code, too.");
    command.flag("--open", options->openBrowser, "Opens the page in the desktop's browser.");
    command.flag("--json", options->json, "One JSON value on standard output: address and port.");
    command.footer(
        "Only this machine can connect, unless you say --lan. Ctrl+C ends it; twice, at once. Recordings are "
        "kept in ./takes\n"
        "and places in ./places, unless --takes and --places name other folders. Without SCENARIO it shows\n"
        "what was shown last, once a place is kept.\n"
        "Examples:\n"
        "  muster studio\n"
        "  muster studio woodland --port 9000 --open\n"
        "  muster studio --lan");
    command.run([options] {
        if (options->scenarioFolder.empty()) options->scenarioFolder = scenariosFolder();
        if (options->pageFolder.empty()) options->pageFolder = pageFolder();
        if (options->engineFolder.empty()) options->engineFolder = engineFolder();
        return runStudio(*options);
    });
}

}  // namespace muster
