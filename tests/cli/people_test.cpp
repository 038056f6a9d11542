// What the program says of people who leave and come.
#include <doctest.h>

#include <algorithm>

#include "cli/run_program.h"

using namespace muster::testing;
using Json = nlohmann::json;

namespace {

/// A hall of people who leave by one door, and what else is in the scenario.
std::string hall(const std::string& name, const std::string& exit, const std::string& more = "") {
    return "'" +
           put(name, R"({"format":"muster-scenario","version":1,"preset":"people","box":[[0,0],[20,10]],
        "groups":[{"count":20,"position":[6,5],"people":"adults","orders":[{"kind":"leave"}]}],
        "areas":[{"kind":"exit","name":"Main door",)" +
                         exit + R"("polygon":[[18,3],[19,3],[19,7],[18,7]]})" + more + "]}") +
           "'";
}

const char* kTrain = R"(,{"kind":"source","name":"Train","polygon":[[1,1],[2,1],[2,2],[1,2]],"group":0,
    "timetable":[{"t":2,"count":5}]})";

}  // namespace

TEST_CASE("play tells who left by which exit and who came, and ends when nobody is left") {
    const std::string scenario = hall("hall.json", "", kTrain);
    const Outcome outcome = runProgram("play " + scenario + " --json");
    REQUIRE_MESSAGE(outcome.code == 0, outcome.error);
    CHECK(outcome.error.empty());
    const Json f = json(outcome);
    CHECK(f["steps"] < 60 * 60);
    CHECK(f["cut_off"] == false);
    CHECK(f["left"] == 25);
    CHECK(f["inside"] == 0);
    CHECK(f["left_first_s"] < f["left50_s"]);
    CHECK(f["left50_s"] < f["left95_s"]);
    CHECK(f["left95_s"] <= f["left_last_s"]);
    CHECK(f["arrived100_s"] == f["left_last_s"]);
    REQUIRE(f["exits"].size() == 1);
    CHECK(f["exits"][0]["id"] == 1);
    CHECK(f["exits"][0]["name"] == "Main door");
    CHECK(f["exits"][0]["left"] == 25);
    CHECK(f["exits"][0]["flow_per_s"].get<double>() > 0.3);
    REQUIRE(f["sources"].size() == 1);
    CHECK(f["sources"][0]["entered"] == 5);
    CHECK(f["sources"][0]["waiting"] == 0);
    const std::string text = runProgram("play " + scenario).out;
    CHECK(text.find("left                       25 persons, 0 still inside\n") != std::string::npos);
    CHECK(text.find("exit 1 \"Main door\"         25 left  first_s ") != std::string::npos);
    CHECK(text.find("source 2 \"Train\"           5 entered  0 wait\n") != std::string::npos);
}

TEST_CASE("a run that ends with people inside says so in one sentence, with seconds it does not") {
    const std::string scenario = hall("slow_hall.json", R"("rate":0.1,)");
    const Outcome outcome = runProgram("play " + scenario + " --json");
    CHECK(outcome.code == 0);
    CHECK(outcome.errorLines() == 1);
    const Json f = json(outcome);
    CHECK(f["steps"] == 7200);
    CHECK(f["cut_off"] == true);
    CHECK(f["left95_s"].is_null());
    const std::string inside = "ended after 120 s, with " + f["inside"].dump() + " persons inside;";
    CHECK_MESSAGE(outcome.error.find(inside) != std::string::npos, outcome.error);
    CHECK(runProgram("play " + scenario + " --seconds 20").error.empty());
}

TEST_CASE("an event about a group tells how many persons it concerned") {
    const std::string scenario = hall("shut_hall.json", R"("open":false,)");
    const Json f = json(runProgram("play " + scenario + " --seconds 2 --json"));
    CHECK(f["events"]["noPath"] == 1);
    CHECK(f["event_persons"]["noPath"] == 20);
    const std::string text = runProgram("play " + scenario + " --seconds 2").out;
    CHECK(text.find("events noPath              1  persons 20\n") != std::string::npos);
}

TEST_CASE("the times of stages are printed where they are asked for") {
    const std::string play = "play " + hall("timed_hall.json", "") + " --seconds 1";
    CHECK(runProgram(play).out.find("steering") == std::string::npos);
    CHECK(runProgram(play + " --timings").out.find("  steering                 mean ") != std::string::npos);
}

TEST_CASE("the seed of the command line replaces that of the file") {
    const std::string play = "play " + hall("seeded_hall.json", "") + " --seconds 2 --json";
    const Json own = json(runProgram(play)), first = json(runProgram(play + " --seed 1"));
    const Json other = json(runProgram(play + " --seed 9007199254740991"));
    CHECK(own["hash"] == first["hash"]);
    CHECK(own["hash"] != other["hash"]);
    for (const char* seed : {"-1", "1.5", "1e3", "9007199254740992", "many"}) {
        CAPTURE(seed);
        const Outcome wrong = runProgram(play + " --seed " + seed);
        CHECK(wrong.code == 2);
        CHECK(wrong.errorLines() == 1);
        CHECK(wrong.error.find("--seed") != std::string::npos);
    }
}

TEST_CASE("a trajectory may have some of the steps only, from the first one on") {
    const std::string play = "play " + hall("rare_hall.json", "") + " --seconds 1";
    REQUIRE(runProgram(play + " --trajectory '" + path("rare.csv") + "' --every 6").code == 0);
    const std::string csv = slurp(path("rare.csv"));
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 20 * 11);
    CHECK(csv.find("\n0.1,1,") != std::string::npos);
    CHECK(json(runProgram("measure '" + path("rare.csv") + "' --line 10,0,10,10 --json"))["frame_rate"] ==
          10.0);
    CHECK(runProgram(play + " --every 6").code == 2);
    CHECK(runProgram(play + " --trajectory x.csv --every 0").code == 2);
}

TEST_CASE("check warns of an exit that nobody can come into") {
    const std::string scenario = "'" + put("walled.json", R"({"format":"muster-scenario","version":1,
        "preset":"people","box":[[0,0],[20,10]],"obstacles":[{"polygon":[[10,0],[11,0],[11,4],[10,4]]}],
        "groups":[{"count":9,"position":[5,5],"orders":[{"kind":"leave"}]}],
        "areas":[{"kind":"exit","polygon":[[10.1,1],[10.9,1],[10.9,3],[10.1,3]]}]})") +
                                 "'";
    const Json list = json(runProgram("check " + scenario + " --json"));
    CHECK(list[0]["good"] == true);
    REQUIRE(list[0]["warnings"].size() == 1);
    CHECK(list[0]["warnings"][0].get<std::string>().rfind("exit 1 lies in obstacles", 0) == 0);
}
