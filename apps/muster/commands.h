// The program's commands. Each adds its subcommand; running it sets the exit code.
#pragma once

#include <CLI/CLI.hpp>

namespace muster {

/// Exit codes, as `muster --help` lists them.
enum ExitCode : int {
    kExitOk = 0,
    kExitFailure = 1,        ///< A file is bad or something went wrong; one sentence on standard error.
    kExitUsage = 2,          ///< The command line is wrong.
    kExitNotReproduced = 3,  ///< A replay gave another hash, or a criterion failed.
};

void addStudioCommand(CLI::App& app, int& exitCode);
void addPlayCommand(CLI::App& app, int& exitCode);
void addReplayCommand(CLI::App& app, int& exitCode);
void addCheckCommand(CLI::App& app, int& exitCode);
void addImportCommand(CLI::App& app, int& exitCode);
void addPictureCommand(CLI::App& app, int& exitCode);
void addPeersCommand(CLI::App& app, int& exitCode);
void addMotionCommand(CLI::App& app, int& exitCode);
void addExportCommand(CLI::App& app, int& exitCode);
void addReproduceCommand(CLI::App& app, int& exitCode);
void addSweepCommand(CLI::App& app, int& exitCode);

}  // namespace muster
