// muster study models, report and export
#include "lab_commands.h"

namespace muster {

void addStudyCommands(CommandLine& line) {
    Subcommand study = line.add("study", "The study of touch and mouse: models, report, export.");
    addStudyModelsCommand(study);
    addStudyReportCommand(study);
    addStudyExportCommand(study);
}

}  // namespace muster
