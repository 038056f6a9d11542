// Runs the built program like a user.
#pragma once

#include <sys/wait.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>

#include "temporary_folder.h"
#include "test_folders.h"

namespace muster::testing {

/// The result of a run of the program.
struct Outcome {
    int code = -1;  ///< Exit code; -1 where the program did not end by itself.
    std::string out;
    std::string error;

    /// Lines on standard error.
    long errorLines() const { return std::count(error.begin(), error.end(), '\n'); }
};

/// A temporary folder for the files of one test run; it is removed afterwards.
inline const TemporaryFolder& workFolder() {
    static const TemporaryFolder folder("cli");
    return folder;
}

inline std::string path(const std::string& name) {
    return workFolder() / name;
}

inline std::string slurp(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    std::stringstream text;
    text << file.rdbuf();
    return text.str();
}

/// A file in the work folder.
inline std::string put(const std::string& name, const std::string& text) {
    return workFolder().put(name, text);
}

/// Runs `muster ARGUMENTS` (a shell fragment) in the source folder; the shell executes `before` first.
inline Outcome runProgram(const std::string& arguments, const std::string& before = "true") {
    const auto out = workFolder() / "stdout", error = workFolder() / "stderr";
    const std::string command = "cd '" + sourceFolder() + "' && { " + before + "; '" + programPath() + "' " +
                                arguments + "; } >'" + out + "' 2>'" + error + "' </dev/null";
    const int status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, slurp(out), slurp(error)};
}

/// What a command has printed with --json.
inline nlohmann::json json(const Outcome& outcome) {
    return nlohmann::json::parse(outcome.out, nullptr, false);
}

}  // namespace muster::testing
