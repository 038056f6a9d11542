// The program's commands. Each function adds its subcommand.
#pragma once

#include "command_line.h"

namespace muster {

void addStudioCommand(CommandLine& line);
void addPlayCommand(CommandLine& line);
void addReplayCommand(CommandLine& line);
void addCheckCommand(CommandLine& line);
void addImportCommand(CommandLine& line);
void addPictureCommand(CommandLine& line);
void addPeersCommand(CommandLine& line);
void addMotionCommand(CommandLine& line);
void addExportCommand(CommandLine& line);
void addReproduceCommand(CommandLine& line);
void addSweepCommand(CommandLine& line);
void addStudyCommand(CommandLine& line);
void addSiteCommand(CommandLine& line);

// Commands of `muster study`.
void addStudyRunCommand(Subcommand& study);
void addStudyReplayCommand(Subcommand& study);
void addStudyModelsCommand(Subcommand& study);
void addStudyReportCommand(Subcommand& study);
void addStudyExportCommand(Subcommand& study);

}  // namespace muster
