// Each option of the program and its effect.
#include <doctest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <vector>

#include "cli/run_program.h"
#include "muster/parameter_table.h"

using namespace muster::testing;
using Json = nlohmann::json;

namespace {

std::string scenario() {
    return "'" +
           put("options.json", R"({"format":"muster-scenario","version":1,"box":[[-6,-5],[6,5]],"cell":0.5,
        "groups":[{"count":6,"position":[-3,0]},{"count":3,"position":[3,2]}]})") +
           "'";
}

std::string gestures() {
    return "'" + put("options_drag.json", R"({"format":"muster-gestures","version":1,"events":[
        {"t":0.1,"kind":"down","touch":1,"x":-3,"y":0},{"t":1.1,"kind":"move","touch":1,"x":0,"y":-2},
        {"t":1.3,"kind":"up","touch":1}]})") +
           "'";
}

std::string hashOf(const std::string& options) {
    const Outcome outcome = runProgram("play " + scenario() + " --gestures " + gestures() +
                                       " --seconds 2 --json " + options);
    REQUIRE_MESSAGE(outcome.code == 0, outcome.error);
    return json(outcome)["hash"].get<std::string>();
}

std::vector<std::vector<std::string>> table(const std::string& csv) {
    std::vector<std::vector<std::string>> rows;
    std::stringstream lines(csv);
    for (std::string line; std::getline(lines, line);) {
        rows.emplace_back();
        std::stringstream cells(line + ",");
        for (std::string cell; std::getline(cells, cell, ',');) rows.back().push_back(cell);
    }
    return rows;
}

}  // namespace

TEST_CASE("every parameter can be set to its default by name, which changes nothing") {
    std::string all;
    const muster::Parameters defaults;
    for (const muster::ParameterInfo& info : muster::parameterTable()) {
        std::stringstream value;
        value.precision(17);
        value << info.get(defaults);
        all += " --set " + std::string(info.name) + "=" + value.str();
    }
    CHECK(hashOf(all) == hashOf(""));
    CHECK(hashOf("--preset muster") == hashOf(""));
    CHECK(hashOf("--plan exact") == hashOf("--set plan.solver=0"));
    CHECK(hashOf("--plan fast") == hashOf("--set plan.solver=1"));
    CHECK(hashOf("--plan fast") != hashOf("--plan exact"));
    CHECK(hashOf("--plan exact --set plan.solver=1") == hashOf("--plan fast"));
    CHECK(hashOf("--threads 3") == hashOf(""));
    CHECK(hashOf("--threads 0") == hashOf(""));
}

TEST_CASE("the last of two settings applies, and settings come after the preset") {
    CHECK(hashOf("--set character.maxSpeed=0.5 --set character.maxSpeed=1") ==
          hashOf("--set character.maxSpeed=1"));
    CHECK(hashOf("--preset paper --set plan.period=4") != hashOf("--preset paper"));
    CHECK(hashOf("--set plan.exponent=1 --set plan.threshold=0 --set plan.thresholdShare=0 --plan exact "
                 "--set plan.period=1") == hashOf("--preset paper"));
}

TEST_CASE("a trajectory has a row per character and step, in order, at plausible speeds") {
    const std::string file = path("options.csv");
    REQUIRE(runProgram("play " + scenario() + " --gestures " + gestures() + " --seconds 1.5 --trajectory '" +
                       file + "'")
                .code == 0);
    const auto rows = table(slurp(file));
    CHECK(rows[0] == std::vector<std::string>{"t", "id", "x", "y", "place_x", "place_y", "group", "heading",
                                              "motion", "goal"});
    REQUIRE(rows.size() == 1 + 9 * 91);
    std::map<int, std::pair<double, double>> last;
    for (std::size_t i = 1; i < rows.size(); ++i) {
        REQUIRE(rows[i].size() == 10);
        const int id = std::stoi(rows[i][1]);
        const double x = std::stod(rows[i][2]), y = std::stod(rows[i][3]);
        CHECK(std::stod(rows[i][0]) ==
              doctest::Approx(static_cast<double>((i - 1) / 9) / 60.0).epsilon(1e-8));
        CHECK(id == static_cast<int>((i - 1) % 9 + 1));
        if (last.count(id) != 0)
            CHECK(std::hypot(x - last[id].first, y - last[id].second) <= 2.0 / 60 + 1e-6);
        last[id] = {x, y};
        CHECK(rows[i][4].empty() == (i <= 9));  // Places are assigned in the first step.
        if (i <= 9) continue;
        CHECK(std::fabs(std::stod(rows[i][4])) <= 6.0);
        CHECK(std::fabs(std::stod(rows[i][5])) <= 5.0);
    }
    CHECK(last[1].first > -4.0);
}

TEST_CASE("zero seconds are zero steps, part of a step counts as the nearest") {
    const auto steps = [](const std::string& seconds) {
        return json(runProgram("play " + scenario() + " --json --seconds " + seconds))["steps"].get<int>();
    };
    CHECK(steps("0") == 0);
    CHECK(steps("1") == 60);
    CHECK(std::abs(steps("0.51") - 31) <= 1);
}

TEST_CASE("pictures: each format and size, each layer, and only the requested part") {
    const auto size = [](const std::string& file) {  // Reads the header: big-endian numbers at 16 and 20.
        const std::string bytes = slurp(file);
        REQUIRE(bytes.size() > 24);
        REQUIRE(bytes.compare(1, 3, "PNG") == 0);
        const auto at = [&](std::size_t i) {
            return static_cast<unsigned char>(bytes[i]) * 256 + static_cast<unsigned char>(bytes[i + 1]);
        };
        return std::pair{at(18), at(22)};
    };
    const std::string png = path("o.png"), svg = path("o.svg");
    REQUIRE(runProgram("picture " + scenario() + " --width 240 -o '" + png + "'").code == 0);
    CHECK(size(png) == std::pair{240, 200});
    REQUIRE(runProgram("picture " + scenario() + " --width 100 --view 0 0 2 4 -o '" + png + "'").code == 0);
    CHECK(size(png) == std::pair{100, 200});
    std::vector<std::string> seen;
    for (const std::string layer :
         {"patches", "cost", "density", "mesh", "places", "characters", "mesh,places"}) {
        CAPTURE(layer);
        REQUIRE(
            runProgram("picture " + scenario() + " --layers " + layer + " --at 0.1 -o '" + svg + "'").code ==
            0);
        const std::string text = slurp(svg);
        CHECK(text.rfind("<svg", 0) == 0);
        CHECK(std::find(seen.begin(), seen.end(), text) == seen.end());
        seen.push_back(text);
    }
    REQUIRE(
        runProgram("picture " + scenario() + " --layers cost --group 1 --place 2 -o '" + svg + "'").code ==
        0);
    CHECK(slurp(svg).find("Cost to place 2") != std::string::npos);
    REQUIRE(runProgram("picture " + scenario() + " -o '" + svg + "'").code == 0);
    const std::string light = slurp(svg);
    REQUIRE(runProgram("picture " + scenario() + " --dark -o '" + svg + "'").code == 0);
    CHECK(slurp(svg) != light);
}

TEST_CASE("check reports the kind of each file, and warns of likely problems") {
    const std::string take = path("o.take");
    REQUIRE(
        runProgram("play " + scenario() + " --gestures " + gestures() + " --seconds 1 --take '" + take + "'")
            .code == 0);
    const std::string bytes = slurp(take);
    const std::string torn = put("o_torn.take", bytes.substr(0, bytes.size() - 3));
    const std::string narrow = put("narrow.json",
                                   R"({"format":"muster-scenario","version":1,"box":[[-6,-5],[6,5]],
        "obstacles":[{"polygon":[[0,-1],[0.5,-1],[0.5,1],[0,1]]},{"polygon":[[0.8,-1],[1.5,-1],[1.5,1],[0.8,1]]}],
        "groups":[{"count":4,"position":[-3,0]}]})");
    const Outcome outcome = runProgram("check " + scenario() + " " + gestures() + " '" + take + "' '" + torn +
                                       "' '" + narrow + "' /nowhere.json --json");
    CHECK(outcome.code == 1);
    const Json list = json(outcome);
    REQUIRE(list.size() == 6);
    const char* kinds[] = {"scenario", "gestures", "take", "take", "scenario", "unknown"};
    for (std::size_t i = 0; i < 6; ++i) {
        CHECK(list[i]["kind"] == kinds[i]);
        CHECK(list[i]["good"] == (i < 5));
    }
    CHECK(list[0]["summary"].get<std::string>().find("9 characters") != std::string::npos);
    CHECK(list[0]["warnings"].empty());
    CHECK(list[2]["warnings"].empty());
    REQUIRE(list[3]["warnings"].size() == 1);
    CHECK(list[3]["warnings"][0].get<std::string>().find("torn") != std::string::npos);
    CHECK(list[4]["warnings"].size() == 1);
    const std::string carrier = put("carrier.json",
                                    R"({"format":"muster-scenario","version":1,"gestures":"carried.json"})");
    const Outcome missing = runProgram("check '" + carrier + "'");
    CHECK(missing.code == 1);
    CHECK(missing.errorLines() == 1);
    CHECK(missing.error.find("carrier.json: $.gestures: ") != std::string::npos);
    put("carried.json",
        R"({"format":"muster-gestures","version":1,"events":[{"t":1,"kind":"up","touch":3}]})");
    CHECK(runProgram("check '" + carrier + "'").out.find("gestures of 1 events") != std::string::npos);
    const Outcome text = runProgram("check " + scenario());
    CHECK(text.code == 0);
    CHECK(text.out.find("a good scenario") != std::string::npos);
}

TEST_CASE("--demo gives the touches that the scenario carries, and no others") {
    const std::string carried = put("demo_touches.json", slurp(gestures().substr(1, gestures().size() - 2)));
    const std::string text = slurp(scenario().substr(1, scenario().size() - 2));
    const std::string demo = put("demo.json",
                                 text.substr(0, text.size() - 1) + R"(,"gestures":"demo_touches.json"})");
    const Outcome shown = runProgram("play '" + demo + "' --demo --seconds 2 --json");
    REQUIRE_MESSAGE(shown.code == 0, shown.error);
    CHECK(json(shown)["hash"] == hashOf(""));
    CHECK(json(runProgram("play '" + demo + "' --seconds 2 --json"))["hash"] != hashOf(""));
    const std::string take = path("demo.take"), svg = path("demo.svg");
    REQUIRE(runProgram("play '" + demo + "' --demo --seconds 1 --take '" + take + "'").code == 0);
    REQUIRE(runProgram("picture '" + demo + "' --at 1 -o '" + svg + "'").code == 0);
    const std::string still = slurp(svg);
    REQUIRE(runProgram("picture '" + demo + "' --demo --at 1 -o '" + svg + "'").code == 0);
    CHECK(slurp(svg) != still);

    const auto refused = [](const std::string& line, const std::string& words) {
        const Outcome outcome = runProgram(line);
        CAPTURE(line);
        CHECK(outcome.code == 1);
        CHECK(outcome.errorLines() == 1);
        CHECK_MESSAGE(outcome.error.find(words) != std::string::npos, outcome.error);
    };
    refused("play " + scenario() + " --demo", "carries no gestures");
    refused("picture " + scenario() + " --demo -o '" + svg + "'", "carries no gestures");
    refused("picture '" + take + "' --demo -o '" + svg + "'", "is a take");
    refused("play '" + demo + "' --demo --take '" + carried + "'", "is read as well");
    refused("picture '" + demo + "' --demo -o '" + carried + "'", "is read as well");
    std::filesystem::remove(carried);
    refused("play '" + demo + "' --demo", "demo.json: $.gestures: ");
}

TEST_CASE("invalid maps are refused by line, valid ones keep size, scale and credit") {
    const auto import = [](const std::string& text, const std::string& options) {
        return runProgram("import '" + put("o.map", text) + "' -o '" + path("o_map.json") + "' --json " +
                          options);
    };
    for (const std::string text :
         {"", "type octile\n", "type octile\nheight 2\nwidth 2\nmap\n..\n",
          "type octile\nheight 2\nwidth 3\nmap\n..\n..\n", "type octile\nheight -2\nwidth 2\nmap\n..\n..\n",
          "type octile\nheight 2\nwidth 99999999\nmap\n..\n..\n",
          "type octile\nheight 2\nwidth 2\nmap\n.?\n..\n"}) {
        CAPTURE(text);
        const Outcome outcome = import(text, "");
        CHECK(outcome.code == 1);
        CHECK(outcome.errorLines() == 1);
        CHECK(outcome.error.find("o.map") != std::string::npos);
    }
    const Outcome good = import("type octile\nheight 3\nwidth 4\nmap\n....\n..@.\n....\n",
                                "--cell 3 --count 2 --credit 'A \"B\"'");
    REQUIRE_MESSAGE(good.code == 0, good.error);
    CHECK(json(good)["width_m"] == 12.0);
    CHECK(json(good)["height_m"] == 9.0);
    CHECK(json(good)["obstacles"] == 1);
    CHECK(json(good)["characters"] == 2);
    const Json written = Json::parse(slurp(path("o_map.json")), nullptr, false);
    CHECK(written["credit"] == "A \"B\"");
    CHECK(written["groups"][0]["count"] == 2);
}
