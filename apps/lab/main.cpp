// muster-lab: the paper's experiments, the study's models and reports, pictures and measures.
#include "lab_commands.h"
#include "program.h"

namespace {

void addCommands(muster::CommandLine& line) {
    muster::addPictureCommand(line);
    muster::addPeersCommand(line);
    muster::addMotionCommand(line);
    muster::addReproduceCommand(line);
    muster::addSweepCommand(line);
    muster::addVerifyCommand(line);
    muster::addMeasureCommand(line);
    muster::addStudyCommands(line);
}

}  // namespace

// People type `muster COMMAND`, so that messages call it so.
int main(int argc, char** argv) {
    return muster::runProgram("muster", "The laboratory of Muster: experiments, sweeps, studies, pictures.",
                              addCommands, argc, argv);
}
