// The program's commands. Each function adds its subcommand.
#pragma once

#include "command_line.h"

namespace muster {

void addStudioCommand(CommandLine& line);
void addPlayCommand(CommandLine& line);
void addReplayCommand(CommandLine& line);
void addCheckCommand(CommandLine& line);
void addImportCommand(CommandLine& line);
void addExportCommand(CommandLine& line);
void addStudyCommand(CommandLine& line);
void addSiteCommand(CommandLine& line);
void addMcpCommand(CommandLine& line);

// Commands of `muster study`.
void addStudyRunCommand(Subcommand& study);
void addStudyReplayCommand(Subcommand& study);

}  // namespace muster
