// muster: direct a crowd with your fingers.
#include "commands.h"
#include "lab_program.h"
#include "program.h"

namespace {

void addCommands(muster::CommandLine& line) {
    muster::addStudioCommand(line);
    muster::addPlayCommand(line);
    muster::addReplayCommand(line);
    muster::addCheckCommand(line);
    muster::addImportCommand(line);
    muster::addExportCommand(line);
    muster::addStudyCommand(line);
    muster::addSiteCommand(line);
    muster::addMcpCommand(line);
    muster::addLabCommands(line);
}

}  // namespace

int main(int argc, char** argv) {
    if (muster::isLabCommand(argc, argv)) return muster::startLab(argv);
    return muster::runProgram("muster", "Muster directs crowds by formations that bend like cloth.",
                              addCommands, argc, argv);
}
