// What the programs muster and muster-lab have in common around their commands.
#pragma once

#include "command_line.h"

namespace muster {

/// Adds its commands to a command line.
using AddCommands = void (*)(CommandLine&);

/// The body of main(): runs the command that the arguments name and returns the exit code. Failures, and
/// output that could not be written in full, are told in one sentence on standard error.
int runProgram(const std::string& name, const std::string& about, AddCommands add, int argc, char** argv);

}  // namespace muster
