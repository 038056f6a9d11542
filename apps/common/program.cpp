#include "program.h"

#include <cstdio>
#include <exception>
#include <iostream>
#include <new>

namespace muster {
namespace {

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

int runProgram(const std::string& name, const std::string& about, AddCommands add, int argc, char** argv) {
    try {
        CommandLine line(
            name, about, MUSTER_VERSION,
            "Exit codes: 0 done, 1 failure (one sentence on standard error), 2 wrong command line,\n"
            "3 not reproduced: a replay, or a criterion of the paper's experiments.\n"
            "`" +
                name + " COMMAND --help` shows the options of a command, with examples.");
        add(line);
        const int code = line.run(argc, argv);
        return allPrinted() || code != kExitOk ? code : failed("standard output cannot be written in full");
    } catch (const std::bad_alloc&) {
        return failed("the memory does not suffice");
    } catch (const std::exception& error) {
        return failed(error.what());
    }
}

}  // namespace muster
