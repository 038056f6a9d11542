// muster: direct a crowd with your fingers.
#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

#include "commands.h"

namespace muster {
namespace {

int run(int argc, char** argv) {
    CommandLine line("muster", "Muster directs crowds by formations that bend like cloth.", MUSTER_VERSION,
                     "Exit codes: 0 done, 1 failure (one sentence on standard error), 2 wrong command line,\n"
                     "3 not reproduced: a replay, or a criterion of the paper's experiments.\n"
                     "`muster COMMAND --help` shows the options of a command, with examples.");
    addStudioCommand(line);
    addPlayCommand(line);
    addReplayCommand(line);
    addCheckCommand(line);
    addImportCommand(line);
    addPictureCommand(line);
    addPeersCommand(line);
    addMotionCommand(line);
    addExportCommand(line);
    addReproduceCommand(line);
    addSweepCommand(line);
    addStudyCommand(line);
    addSiteCommand(line);
    return line.run(argc, argv);
}

/// Fails where standard output could not be written, for example on a full disk.
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
