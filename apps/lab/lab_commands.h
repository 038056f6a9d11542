// The commands of muster-lab. Each function adds its subcommand.
#pragma once

#include "command_line.h"

namespace muster {

void addPictureCommand(CommandLine& line);
void addPeersCommand(CommandLine& line);
void addMotionCommand(CommandLine& line);
void addReproduceCommand(CommandLine& line);
void addSweepCommand(CommandLine& line);
void addVerifyCommand(CommandLine& line);
void addMeasureCommand(CommandLine& line);
/// Those of `muster study` that need no person: models, report, export.
void addStudyCommands(CommandLine& line);

// Commands of `muster study`.
void addStudyModelsCommand(Subcommand& study);
void addStudyReportCommand(Subcommand& study);
void addStudyExportCommand(Subcommand& study);

}  // namespace muster
