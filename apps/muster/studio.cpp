// muster studio
#include "studio.h"

#include "commands.h"
#include "folders.h"

namespace muster {
void addStudioCommand(CLI::App& app, int& exitCode) {
    CLI::App* command = app.add_subcommand("studio", "Serves the studio: steer a crowd in your browser.");
    auto options = std::make_shared<StudioOptions>();
    command->add_option("SCENARIO", options->scenario, "Loaded first: a name of the folder or a file.");
    command->add_option("--port", options->port, "Port; the next free one where it is in use.")
        ->check(CLI::Range(1, 65535));
    command->add_option("--scenarios", options->scenarioFolder, "Folder of the picker's scenarios.")
        ->check(CLI::ExistingDirectory);
    command->add_option("--page", options->pageFolder, "Folder of the built page.")
        ->check(CLI::ExistingDirectory);
    command
        ->add_option("--threads", options->threads,
                     "Threads of the simulation; 0 takes what the machine has.")
        ->check(CLI::Range(0, 256));
    command->add_flag("--open", options->openBrowser, "Opens the page in the desktop's browser.");
    command->add_flag("--json", options->json, "One JSON value on standard output: address and port.");
    command->footer(
        "Only this machine can connect. Ctrl+C ends it; twice, at once. Recordings are kept in ./takes.\n"
        "Examples:\n"
        "  muster studio\n"
        "  muster studio woodland --port 9000 --open");
    command->callback([options, &exitCode] {
        if (options->scenarioFolder.empty()) options->scenarioFolder = scenariosFolder();
        if (options->pageFolder.empty())
            options->pageFolder = findFolder({"web/dist", "../share/muster/web"});
        exitCode = runStudio(*options);
    });
}

}  // namespace muster
