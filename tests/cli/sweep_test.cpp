// `muster sweep`, run as a user runs it.
#include <doctest.h>

#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <vector>

#include "cli/program.h"

using namespace muster::testing;

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
