#include "lab_commands.h"

#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <iterator>
#include <string_view>

namespace muster {
namespace {

struct LabCommand {
    const char* name;
    const char* about;
};

constexpr LabCommand kCommands[] = {
    {"picture", "Draws a moment of a scenario or take."},
    {"peers", "Runs scenes with explicit starts and slots, as other crowd engines do."},
    {"motion", "Lengths, speeds and contacts of motion clips."},
    {"reproduce", "Runs the paper's experiments and writes a report."},
    {"sweep", "Runs the paper's experiments with several values of a parameter."},
};
constexpr LabCommand kStudyCommands[] = {
    {"models", "Runs trials of operator models and keeps them."},
    {"report", "Writes report.html and results.json."},
    {"export", "Writes all tables as CSV, with a codebook."},
};

template <class Commands>
bool names(const Commands& commands, std::string_view name) {
    return std::any_of(std::begin(commands), std::end(commands),
                       [name](const LabCommand& command) { return command.name == name; });
}

}  // namespace

bool isLabCommand(int argc, char** argv) {
    if (argc < 2) return false;
    if (argc > 2 && std::string_view(argv[1]) == "study") return names(kStudyCommands, argv[2]);
    return names(kCommands, argv[1]);
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
    for (const LabCommand& command : kCommands) line.add(command.name, command.about);
}

void addLabCommands(Subcommand& study) {
    for (const LabCommand& command : kStudyCommands) study.add(command.name, command.about);
}

}  // namespace muster
