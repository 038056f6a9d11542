// muster: direct a crowd with your fingers.
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "commands.h"

namespace muster {
namespace {

int run(int argc, char** argv) {
    CLI::App app("Muster directs crowds by formations that bend like cloth.", "muster");
    app.set_version_flag("--version", MUSTER_VERSION);
    app.require_subcommand(1);
    app.footer(
        "Exit codes: 0 done, 1 failure (one sentence on standard error), 2 wrong command line,\n"
        "3 not reproduced: a replay, or a criterion of the paper's experiments.\n"
        "`muster COMMAND --help` shows the options of a command, with examples.");
    int exitCode = kExitOk;
    addStudioCommand(app, exitCode);
    addPlayCommand(app, exitCode);
    addReplayCommand(app, exitCode);
    addCheckCommand(app, exitCode);
    addImportCommand(app, exitCode);
    addPictureCommand(app, exitCode);
    addPeersCommand(app, exitCode);
    addMotionCommand(app, exitCode);
    addExportCommand(app, exitCode);
    addReproduceCommand(app, exitCode);
    addSweepCommand(app, exitCode);
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

/// What is said must have been heard: a full disk behind standard output is a failure.
bool allPrinted() {
    std::cout.flush();
    return std::fflush(stdout) == 0 && std::ferror(stdout) == 0 && std::cout.good();
}

int failed(const char* reason) {
    std::fprintf(stderr, "muster: %s\n", reason);
    return kExitFailure;
}

}  // namespace
}  // namespace muster

int main(int argc, char** argv) {
    using namespace muster;
    try {
        const int code = run(argc, argv);
        return allPrinted() || code != kExitOk ? code : failed("standard output cannot be written in full");
    } catch (const std::bad_alloc&) {
        return failed("the memory does not suffice");
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}
