// muster verify and muster measure, as people run them.
#include <doctest.h>

#include <cmath>
#include <string>

#include "cli/run_program.h"

using namespace muster::testing;

namespace {

nlohmann::json verified(const Outcome& outcome) {
    CHECK_MESSAGE(outcome.error.empty(), outcome.error);
    return nlohmann::json::parse(outcome.out);
}

}  // namespace

TEST_CASE("verify runs one test, prints its row and writes its page") {
    const std::string page = path("verification.html");
    const Outcome table = runProgram("verify --only \"RiMEA 1\" --page " + page);
    CHECK_MESSAGE(table.code == 0, table.error);
    CHECK(table.out.find("RiMEA 1         pass    1") != std::string::npos);
    CHECK(table.out.find("1 pass, 0 fail, 0 missing") != std::string::npos);
    CHECK(slurp(page).find("<h1>Standard tests of pedestrian dynamics</h1>") != std::string::npos);
    const auto found = verified(runProgram("verify --only rimea1,nist2.1 --json --no-page --threads 1"));
    CHECK(found["pass"] == 2);
    CHECK(found["rows"][0]["id"] == "RiMEA 1");
    CHECK(found["rows"][0]["checks"][0]["pass"] == true);
}

TEST_CASE("verify tells what is missing and what is not known") {
    const Outcome missing = runProgram("verify --only \"RiMEA 8\" --no-page");
    CHECK(missing.code == 0);
    CHECK(missing.out.find("needs floors") != std::string::npos);
    CHECK(missing.out.find("0 pass, 0 fail, 1 missing") != std::string::npos);
    const Outcome unknown = runProgram("verify --only \"RiMEA 99\" --no-page");
    CHECK(unknown.code == 2);
    CHECK(unknown.error.find("found the test \"RiMEA 99\"") != std::string::npos);
    CHECK(unknown.errorLines() == 1);
    CHECK(runProgram("verify --seeds -1").code == 2);
    CHECK(runProgram("verify --only rimea1 --page /no/such/folder/page.html").code == 1);
}

TEST_CASE("measure reads what play writes") {
    const char* march = R"({"format":"muster-scenario","version":1,"box":[[-12,-6],[12,6]],"cell":0.5,
        "groups":[{"count":9,"position":[-8,0],"orders":[{"kind":"move","x":8,"y":0}]}]})";
    const std::string csv = path("march.csv");
    REQUIRE(runProgram("play '" + put("march.json", march) + "' --seconds 12 --trajectory " + csv).code == 0);
    const auto found = verified(runProgram(
        "measure " + csv + " --line 0,-6,0,6 --area -2,-3,2,3 --ground -12,-6,12,6 --reaches 0.1 --json"));
    CHECK(found["persons"] == 9);
    CHECK(found["frames"] == 721);
    CHECK(std::abs(found["frame_rate"].get<double>() - 60.0) < 1e-3);
    CHECK(found["lines"][0]["to_the_right"]["crossed"] == 9);
    CHECK(found["lines"][0]["to_the_left"]["crossed"] == 0);
    CHECK(found["lines"][0]["to_the_right"]["flow_per_s"].get<double>() > 1.0);
    CHECK(found["areas"][0]["area_m2"] == 24.0);
    CHECK(found["areas"][0]["density_classic"]["most"].get<double>() > 0.2);
    CHECK(found["areas"][0]["reaches_s"].get<double>() > 1.0);
    const Outcome series = runProgram("measure " + csv + " --line 0,-6,0,6 --csv");
    CHECK(series.out.rfind("t,line1_right,line1_left,persons\n0,0,0,9\n", 0) == 0);
    CHECK(std::count(series.out.begin(), series.out.end(), '\n') == 722);
    CHECK(runProgram("measure " + csv + " --line 0,-6,0,6").out.find("crossed") != std::string::npos);
}

TEST_CASE("measure tells what is wrong") {
    const std::string text = put("two.txt", "1 0 0 0 0\n1 1 1 0 0\n");
    CHECK(runProgram("measure " + text).error.find("framerate") != std::string::npos);
    CHECK(runProgram("measure " + text + " --fps 10").code == 0);
    CHECK(runProgram("measure " + text + " --fps 10 --line 0,0,1").error.find("--line: found \"0,0,1\"") !=
          std::string::npos);
    CHECK(runProgram("measure " + text + " --fps 10 --area nonsense").error.find("--area: ") !=
          std::string::npos);
    CHECK(runProgram("measure /no/such/file").code == 1);
    CHECK(runProgram("measure").code == 2);
}
