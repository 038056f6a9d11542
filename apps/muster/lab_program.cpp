#include "lab_program.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>

#include "lab_commands_list.h"

namespace muster {
namespace {

template <class Commands>
bool names(const Commands& commands, std::string_view name) {
    return std::any_of(std::begin(commands), std::end(commands),
                       [name](const LabCommand& command) { return command.name == name; });
}

}  // namespace

bool isLabCommand(int argc, char** argv) {
    if (argc < 2) return false;
    if (argc > 2 && std::string_view(argv[1]) == "study") return names(kLabStudyCommands, argv[2]);
    return names(kLabCommands, argv[1]);
}

int startLab(char** argv) {
    std::error_code error;
    const auto folder = std::filesystem::read_symlink("/proc/self/exe", error).parent_path();
    const std::string lab = (folder / "muster-lab").string();
    execv(lab.c_str(), argv);
    std::fprintf(
        stderr,
        "muster: '%s' is a command of muster-lab, which is not beside this program: `./run -- %s` builds it "
        "(target muster_lab)\n",
        argv[1], argv[1]);
    return kExitFailure;
}

void addLabCommands(CommandLine& line) {
    for (const LabCommand& command : kLabCommands) line.add(command.name, command.about);
}

void addLabCommands(Subcommand& study) {
    for (const LabCommand& command : kLabStudyCommands) study.add(command.name, command.about);
}

}  // namespace muster
