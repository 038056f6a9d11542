// muster: direct a crowd with your fingers.
#include <cstdio>

#include "commands.h"

int main(int argc, char** argv) {
    using namespace muster;
    CLI::App app("Muster directs crowds by formations that bend like cloth.", "muster");
    app.set_version_flag("--version", MUSTER_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 failure (one sentence on standard error), 2 wrong command line,\n"
        "3 a replay was not reproduced.\n"
        "`muster COMMAND --help` shows the options of a command, with examples.");
    int exitCode = kExitOk;
    addStudioCommand(app, exitCode);
    addPlayCommand(app, exitCode);
    addReplayCommand(app, exitCode);
    addCheckCommand(app, exitCode);
    addImportCommand(app, exitCode);
    addPictureCommand(app, exitCode);
    addPeersCommand(app, exitCode);
    try {
        app.parse(argc, argv);
    } catch (const CLI::Success& help) {
        return app.exit(help);
    } catch (const CLI::ParseError& error) {
        std::fprintf(stderr, "muster: %s (see muster --help)\n", error.what());
        return kExitUsage;
    }
    return exitCode;
}
