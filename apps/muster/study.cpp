// muster study
#include "commands.h"
#include "lab_program.h"

namespace muster {

void addStudyCommand(CommandLine& line) {
    Subcommand study = line.add("study", "The study of touch and mouse (the paper's section 7.5).");
    addStudyRunCommand(study);
    addStudyReplayCommand(study);
    addLabCommands(study);
    study.footer(
        "All commands share one database file. Operator models are no people: reports never mix them.\n"
        "Examples:\n"
        "  muster study run --db study.db\n"
        "  muster study models --seeds 50 --db study.db\n"
        "  muster study report --db study.db -o report");
}

}  // namespace muster
