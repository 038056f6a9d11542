// `muster motion` and `muster export`, run as a user runs them.
#include <doctest.h>

#include <filesystem>

#include "cli/run_program.h"
#include "test_folders.h"

using namespace muster::testing;
using muster::sourceFolder;
using Json = nlohmann::json;

namespace {

const char* kFourPeople = R"({"format":"muster-scenario","version":1,"box":[[-6,-5],[6,5]],"cell":0.5,
    "groups":[{"count":4,"position":[-3.5,0]}]})";

std::string smallTake() {
    const std::string take = path("motion.take");
    REQUIRE(
        runProgram("play " + put("motion-small.json", kFourPeople) + " --seconds 1 --take " + take).code ==
        0);
    return take;
}

std::size_t filesIn(const std::string& folder) {
    return static_cast<std::size_t>(std::distance(std::filesystem::directory_iterator(folder), {}));
}

}  // namespace

TEST_CASE("motion shows Muster's own clips, as a table and as JSON") {
    const Outcome table = runProgram("motion");
    CHECK(table.code == 0);
    for (const char* word : {"clip", "duration s", "speed m/s", "ratio", "\nrun ", "\nwalk ", "\nidle "})
        CHECK_MESSAGE(table.out.find(word) != std::string::npos, word);
    const Outcome outcome = runProgram("motion --json");
    CHECK(outcome.code == 0);
    const Json list = Json::parse(outcome.out, nullptr, false);
    REQUIRE(list.is_array());
    bool run = false;
    for (const Json& clip : list) {
        for (const char* key : {"clip", "speed_mps", "ratio", "length_m", "duration_s", "cyclic", "contacts"})
            CHECK(clip.contains(key));
        CHECK(clip["ratio"].get<double>() >= 0.02);
        CHECK(std::abs(clip["speed_mps"].get<double>() * clip["duration_s"].get<double>() -
                       clip["length_m"].get<double>()) < 1e-6);
        if (clip["clip"] != "run") continue;
        run = true;
        CHECK(clip["ratio"] == 1.0);
        CHECK(clip["cyclic"] == true);
        CHECK(clip["contacts"].size() >= 2);
    }
    CHECK(run);
}

TEST_CASE("clips written to a folder are read again, one by one and all together") {
    const std::string folder = path("motions");
    const Json own = Json::parse(runProgram("motion --json --write " + folder).out, nullptr, false);
    REQUIRE(own.is_array());
    CHECK(filesIn(folder) == own.size() + 1);
    const Json again = Json::parse(runProgram("motion --json " + folder).out, nullptr, false);
    REQUIRE(again.size() == own.size());
    for (std::size_t i = 0; i < own.size(); ++i) {
        CHECK(again[i]["clip"] == own[i]["clip"]);
        CHECK(again[i]["cyclic"] == own[i]["cyclic"]);
        CHECK(again[i]["contacts"] == own[i]["contacts"]);
        CHECK(std::abs(again[i]["speed_mps"].get<double>() - own[i]["speed_mps"].get<double>()) < 1e-4);
    }
    const Json files = Json::parse(runProgram("motion --json --run " + folder + "/walk.bvh " + folder +
                                              "/walk.bvh " + folder + "/run.bvh --unit cm")
                                       .out,
                                   nullptr, false);
    REQUIRE(files.size() == 2);
    CHECK(std::abs(files[0]["ratio"].get<double>() - 1.0) < 1e-6);
    CHECK(files[1]["clip"] == "run");
    CHECK(std::abs(files[1]["speed_mps"].get<double>() - 2.6) < 1e-3);
    // In another unit the same file moves a hundred times as far.
    const Json metres = Json::parse(runProgram("motion --json --unit m " + folder + "/run.bvh").out, nullptr,
                                    false);
    CHECK(std::abs(metres[0]["speed_mps"].get<double>() - 260.0) < 0.1);
}

TEST_CASE("motion refuses what it cannot read with one sentence") {
    for (const std::string& line :
         {std::string("motion /nowhere.bvh"), "motion " + put("no.bvh", "not a BVH file"),
          std::string("motion --unit ell"), std::string("motion --run idle"),
          std::string("motion --write /proc/nowhere"), "motion " + workFolder().base.string()}) {
        const Outcome outcome = runProgram(line);
        CHECK_MESSAGE(outcome.code == 1, line);
        CHECK_MESSAGE(outcome.errorLines() == 1, outcome.error);
        CHECK(outcome.out.empty());
    }
    CHECK(runProgram("motion sprnt").error.find("sprnt: is none of Muster's clips") != std::string::npos);
    CHECK(runProgram("motion " + put("no.bvh", "not a BVH file")).error.find("no.bvh:1: found \"not\"") !=
          std::string::npos);
}

TEST_CASE("export writes each simple format") {
    const std::string take = smallTake();
    const Outcome text = runProgram("export " + take + " --format pedpy --out " + path("e.txt") +
                                    " --fps 25");
    CHECK_MESSAGE(text.code == 0, text.error);
    CHECK(slurp(path("e.txt")).rfind("# framerate: 25\n", 0) == 0);
    const Outcome bodies = runProgram("export " + take + " --format bvh --out " + path("e-bodies") +
                                      " --from 0.2 --to 0.7 --fps 24");
    CHECK_MESSAGE(bodies.code == 0, bodies.error);
    CHECK(filesIn(path("e-bodies")) == 4);
    CHECK(slurp(path("e-bodies") + "/character-0001.bvh").find("Frames: 13 ") != std::string::npos);
    const Outcome base = runProgram("export " + take + " --format jupedsim --out " + path("e.sqlite"));
    if (base.error.find("this build has none") == std::string::npos) {
        CHECK_MESSAGE(base.code == 0, base.error);
        CHECK(slurp(path("e.sqlite")).rfind("SQLite format 3", 0) == 0);
    }
}

TEST_CASE("export writes a player's file at 15 frames a second, and pages where the page is built") {
    const std::string take = smallTake();
    const Outcome file = runProgram("export " + take + " --format player --out " + path("e.muster-player"));
    CHECK_MESSAGE(file.code == 0, file.error);
    const std::string bytes = slurp(path("e.muster-player"));
    CHECK(bytes.rfind("MUSTERPL", 0) == 0);
    CHECK(bytes.find("\"fps\":15.0,\"frames\":16") != std::string::npos);
    REQUIRE(
        runProgram("export " + take + " --format player --fps 30 --out " + path("e.muster-player")).code ==
        0);
    CHECK(slurp(path("e.muster-player")).find("\"fps\":30.0,\"frames\":31") != std::string::npos);
    // From a folder with a page of its own, which is not built yet.
    const std::string there = "cd " + workFolder().base.string();
    std::filesystem::create_directories(workFolder() / "web/dist/player");
    const Outcome page = runProgram("export " + take + " --format player-page --out " + path("e.html"),
                                    there);
    CHECK(page.code == 1);
    CHECK(page.errorLines() == 1);
    CHECK_MESSAGE(page.error.find("muster-player.js: is not there") != std::string::npos, page.error);
    CHECK_FALSE(std::filesystem::exists(path("e.html")));
    put("web/dist/player/muster-player.js", "script();");
    put("web/dist/player/page.html", "<h1>{{title}}</h1>{{script}}{{source}}");
    for (const std::string format :
         {"player-page --out " + path("e.html"), "player-folder --out " + path("e-player")}) {
        const Outcome made = runProgram("export " + take + " --format " + format, there);
        CHECK_MESSAGE(made.code == 0, made.error);
    }
    CHECK(slurp(path("e.html")).find("script();") != std::string::npos);
    CHECK(slurp(path("e.html")).find("base64,TVVTVEVSUEw") != std::string::npos);
    CHECK(filesIn(path("e-player")) == 3);
    CHECK_FALSE(std::filesystem::exists(path("e.html.muster-player")));
    const Outcome again = runProgram("export " + take + " --format player-folder --out " + path("e-player"),
                                     there);
    CHECK(again.code == 1);
    CHECK(again.error.find("exists already") != std::string::npos);
}

TEST_CASE("export fails with one sentence and leaves no incomplete file") {
    const std::string take = smallTake(), out = path("half");
    const std::string torn = put("torn.take", slurp(take).substr(0, slurp(take).size() - 5));
    for (const std::string& line :
         {take + " --format doc --out " + out, take + " --format pedpy --from 0.8 --to 0.3 --out " + out,
          take + " --format pedpy --fps 0 --out " + out, take + " --format bvh --fps -24 --out " + out,
          take + " --format pedpy --to 99 --out " + out, take + " --format pedpy --out /proc/nowhere/x",
          take + " --format bvh --out /proc/nowhere/x", take + " --format pedpy --out " + take,
          torn + " --format pedpy --out " + out, "/nowhere.take --format bvh --out " + out,
          take + " --format bvh --clips " + workFolder().base.string() + " --out " + out,
          take + " --format bvh --clips /nowhere/x --out " + out + "/" + std::string(300, 'x')}) {
        const Outcome outcome = runProgram("export " + line);
        CHECK_MESSAGE(outcome.code == 1, line);
        CHECK_MESSAGE(outcome.errorLines() == 1, outcome.error);
        CHECK_MESSAGE(!std::filesystem::exists(out), line);
        CHECK_MESSAGE(!std::filesystem::exists(out + ".part"), line);
        std::filesystem::remove_all(out);
    }
    CHECK(runProgram("export " + take + " --format bvh --out x --fps many").code == 2);
}

TEST_CASE("an export without an output path writes to the current folder, named after the take") {
    const std::string take = std::filesystem::absolute(smallTake()).string(), here = path("here");
    std::filesystem::remove_all(here);
    std::filesystem::create_directories(here);
    const std::string stem = here + "/" + std::filesystem::path(take).stem().string();
    for (const auto& [format, file] :
         {std::pair{"glb", ".glb"}, {"usda", ".usda"}, {"bvh", "-bvh"}, {"pedpy", ".txt"}}) {
        const Outcome outcome = runProgram("export " + take + " --format " + format + " --to 0.2",
                                           "cd " + here);
        CHECK_MESSAGE(outcome.code == 0, outcome.error);
        CHECK_MESSAGE(std::filesystem::exists(stem + file), format);
        CHECK(outcome.out.find(file) != std::string::npos);
    }
}

TEST_CASE("motion draws strips, writes bodies and measures") {
    const std::string strips = path("strips"), bodies = path("bodies");
    const Outcome outcome = runProgram("motion run climb --json --strip " + strips + " --bodies " + bodies);
    CHECK_MESSAGE(outcome.code == 0, outcome.error);
    CHECK(slurp(strips + "/run.svg").find("</svg>") != std::string::npos);
    CHECK(filesIn(strips) == 2);
    CHECK(filesIn(bodies) == 4);
    CHECK(slurp(bodies + "/body-2-far.glb").rfind("glTF", 0) == 0);
    CHECK(runProgram("motion --measure").code == 1);
    CHECK(runProgram("motion --count 3").code == 2);
    CHECK(runProgram("motion --measure /nowhere.json").error.find("/nowhere.json") != std::string::npos);
    CHECK(runProgram("motion run --strip /proc/nowhere").code == 1);
    const Outcome measured = runProgram("motion --measure " + sourceFolder() +
                                        "/scenarios/paper/x04-woodland.json --seconds 5 --json");
    CHECK_MESSAGE(measured.code == 0, measured.error);
    const auto json = nlohmann::json::parse(measured.out);
    CHECK(json[0]["characters"] == 36);
    CHECK(json[0]["contacts"] > 4);
    CHECK(json[0]["slide_median_cm"] < 0.5);
}
