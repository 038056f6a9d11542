// `muster sweep`, run as a user runs it.
#include <doctest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/run_program.h"

using namespace muster::testing;
namespace fs = std::filesystem;

namespace {

std::vector<std::string> linesOf(const std::string& text) {
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);) lines.push_back(line);
    return lines;
}

}  // namespace

TEST_CASE("sweep refuses wrong arguments before the first run, naming them") {
    const auto failsWith = [](const std::string& line, const std::string& words) {
        const Outcome outcome = runProgram("sweep " + line);
        CHECK(outcome.code != 0);
        CHECK_MESSAGE(outcome.error.find(words) != std::string::npos, outcome.error);
        CHECK(outcome.out.empty());
    };
    failsWith("control.soft --values 1,2 --experiments X2", "control.soft");
    failsWith("control.softWeight --values 2,-1 --experiments X2", "control.softWeight is -1");
    failsWith("control.softWeight --values 2 --experiments X99", "X99");
    failsWith("control.softWeight --values 2 --experiments X2 --scenarios /nowhere", "/nowhere");
    failsWith("control.softWeight --experiments X2", "--values");
}

TEST_CASE("sweep prints a column per value, and a firmer line keeps the right half of X2 better") {
    const Outcome outcome = runProgram("sweep control.softWeight --values 2,20 --experiments X2 --seeds 1");
    REQUIRE(outcome.code == 0);
    const std::vector<std::string> lines = linesOf(outcome.out);
    REQUIRE(lines.size() > 3);
    CHECK(lines[0] == "| control.softWeight | 2 | 20 |");
    CHECK(lines[1] == "|---|---|---|");
    const Outcome json = runProgram(
        "sweep control.softWeight --values 2,20 --experiments X2 --seeds 1 --json");
    const auto rows = nlohmann::json::parse(json.out);
    REQUIRE(rows.size() == 2);
    CHECK(rows[0]["control.softWeight"] == 2);
    CHECK(rows[1]["value"].get<double>() > 1.5 * rows[0]["value"].get<double>());
}

TEST_CASE("the parts of a sweep, run one by one as Slurm does, give the same table and the same results") {
    const fs::path script = workFolder() / "sweep here.sh";
    const std::string what = "sweep control.softWeight --values 2,20 --experiments X2,X1 --seeds 1";
    const Outcome written = runProgram(what + " --slurm '" + script.string() + "'");
    REQUIRE_MESSAGE(written.code == 0, written.error);
    CHECK(slurp(script).find("#SBATCH --array=0-3\n") != std::string::npos);
    // Slurm runs the tasks in any order.
    for (const char* task : {"3", "0", "2", "1"}) {
        const std::string line = std::string("SLURM_ARRAY_TASK_ID=") + task + " bash '" + script.string() +
                                 "'";
        REQUIRE(std::system(line.c_str()) == 0);
    }
    const std::string folder = script.string() + ".parts";
    for (const char* form : {"", " --json"}) {
        const Outcome collected = runProgram("sweep --collect '" + folder + "'" + form);
        REQUIRE_MESSAGE(collected.code == 0, collected.error);
        CHECK(collected.out == runProgram(what + form).out);
    }
    const auto refusal = [&] {
        const Outcome outcome = runProgram("sweep --collect '" + folder + "'");
        CHECK(outcome.code == 1);
        CHECK(outcome.out.empty());
        return outcome.error;
    };
    fs::rename(folder + "/2.json", folder + "/kept");
    CHECK(refusal().find("2.json") != std::string::npos);
    fs::copy_file(folder + "/1.json", folder + "/2.json");
    CHECK(refusal().find("2.json: is of another sweep than") != std::string::npos);
    std::ofstream(folder + "/2.json") << "{}";
    CHECK(refusal().find("2.json: is no part of a sweep") != std::string::npos);
}

TEST_CASE("parts that do not exist are refused") {
    const Outcome outcome = runProgram("sweep control.softWeight --values 2,20 --experiments X2 --part 2");
    CHECK(outcome.code == 1);
    CHECK(outcome.error.find("part is 2, expected 0 to 1") != std::string::npos);
}
