// Commands that the program muster-lab carries out: they are known here, and built only where somebody asks
// for them.
#pragma once

#include "command_line.h"

namespace muster {

/// True where the arguments name a command of muster-lab.
bool isLabCommand(int argc, char** argv);
/// Becomes muster-lab, which lies beside this program, with the same arguments. Returns only where that
/// fails: the exit code, after one sentence on standard error that says how to build it.
int startLab(char** argv);
/// Lists its commands in the help of the program.
void addLabCommands(CommandLine& line);
/// Lists those of `muster study`.
void addLabCommands(Subcommand& study);

}  // namespace muster
