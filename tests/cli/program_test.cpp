#include <doctest.h>

#include <string>
#include <vector>

#include "cli/run_program.h"
#include "files/take/take_encoder.h"
#include "muster/scenario.h"
#include "muster/take.h"
#include "muster/views.h"

using namespace muster::testing;
using Json = nlohmann::json;

namespace {

const std::vector<std::string> kCommands = {"studio",  "play",   "replay", "check",  "import",
                                            "picture", "peers",  "motion", "export", "reproduce",
                                            "sweep",   "verify", "measure"};

const char* kSmall = R"({"format":"muster-scenario","version":1,"box":[[-6,-5],[6,5]],"cell":0.5,
    "obstacles":[{"polygon":[[0,-1],[0.5,-1],[0.5,1],[0,1]]}],
    "groups":[{"count":9,"position":[-3.5,0]}]})";
const char* kDrag = R"({"format":"muster-gestures","version":1,"events":[
    {"t":0.1,"kind":"down","touch":1,"x":-3.5,"y":0},{"t":1.1,"kind":"move","touch":1,"x":-1,"y":2},
    {"t":2.1,"kind":"move","touch":1,"x":3,"y":2},{"t":2.3,"kind":"up","touch":1}]})";

}  // namespace

TEST_CASE("help for all, with examples") {
    const Outcome all = runProgram("--help");
    CHECK(all.code == 0);
    CHECK(all.out.find("Exit codes") != std::string::npos);
    for (const std::string& command : kCommands) {
        CAPTURE(command);
        CHECK(all.out.find(command) != std::string::npos);
        const Outcome help = runProgram(command + " --help");
        CHECK(help.code == 0);
        CHECK(help.error.empty());
        CHECK(help.out.find("Examples:") != std::string::npos);
        CHECK(help.out.find("muster " + command) != std::string::npos);
    }
    CHECK(runProgram("--version").code == 0);
}

TEST_CASE("a wrong command line gives one sentence and exit code 2") {
    for (const std::string& line : std::vector<std::string>{"",
                                                            "dance",
                                                            "play",
                                                            "play a b",
                                                            "play --seconds",
                                                            "play x --seconds -3",
                                                            "play x --seconds soon",
                                                            "play x --plan slow",
                                                            "play x --preset rubens",
                                                            "play x --threads -1",
                                                            "play x --demo --gestures y",
                                                            "picture x -o y --gestures z --demo",
                                                            "play x --nonsense",
                                                            "replay",
                                                            "check",
                                                            "import x",
                                                            "import x -o y --cell 0",
                                                            "import x -o y --count 0",
                                                            "picture x",
                                                            "picture x -o y --width 3",
                                                            "play x --seconds nan",
                                                            "import x -o y --ground nan",
                                                            "import x -o y --cell inf",
                                                            "picture x -o y --at nan",
                                                            "picture x -o y --at -1",
                                                            "picture x -o y --group -1",
                                                            "picture x -o y --place -1",
                                                            "peers",
                                                            "studio --port 99999",
                                                            "studio --page /nowhere"}) {
        CAPTURE(line);
        const Outcome outcome = runProgram(line);
        CHECK(outcome.code == 2);
        CHECK(outcome.out.empty());
        CHECK(outcome.errorLines() == 1);
        CHECK(outcome.error.rfind("muster", 0) == 0);
    }
}

TEST_CASE("bad input gives one sentence and exit code 1") {
    const std::string small = put("small.json", kSmall);
    const std::string bad = put("bad.json",
                                R"({"format":"muster-scenario","version":1,"groups":[{"count":0}]})");
    const std::string torn = put("torn.json", "{\"format\":");
    const std::string map = put("bad.map", "type octile\nheight 2\nwidth 2\nmap\n..\n.x\n");
    const std::string blocked = put("blocked.map", "type octile\nheight 2\nwidth 2\nmap\n@@\n@@\n");
    const std::string take = put("bad.take", "MUSTAKE\n\x01");
    const std::string scenes = put("bad.scenes.json",
                                   R"({"scenes":{"A":{"world":[0,0,1],"T":1,"start":[],"slots":[]}}})");
    const std::string fine = "'" + small + "' ";
    for (const std::string& line : std::vector<std::string>{
             "play /nowhere.json",
             "play '" + bad + "'",
             "play '" + torn + "'",
             "play " + fine + "--gestures '" + bad + "'",
             "play " + fine + "--set plan.exponent",
             "play " + fine + "--set plan.exponent=zero",
             "play " + fine + "--set plan.exponent=0",
             "play " + fine + "--set no.such=1",
             "play " + fine + "--seconds 0.1 --take /nowhere/x.take",
             "play " + fine + "--seconds 0.1 --trajectory /nowhere/x.csv",
             "replay /nowhere.take",
             "replay '" + take + "'",
             "replay " + fine,
             "check '" + bad + "'",
             "check '" + take + "'",
             "import /nowhere.map -o x.json",
             "import '" + map + "' -o '" + path("x.json") + "'",
             "import '" + blocked + "' -o '" + path("x.json") + "'",
             "picture " + fine + "-o x.jpeg",
             "picture " + fine + "--view 1 1 1 1 -o x.png",
             "picture " + fine + "-o /nowhere/x.png",
             "picture " + fine + "--group 1 -o '" + path("x.png") + "'",
             "picture " + fine + "--place 700 -o '" + path("x.png") + "'",
             "play " + fine + "--set density.max=0.5",
             "picture " + fine + "--set cost.alpha=0 --set cost.beta=0 -o '" + path("x.png") + "'",
             "peers '" + scenes + "' --set density.max=0.5",
             "picture " + fine + "--layers clouds -o '" + path("x.png") + "'",
             "peers '" + scenes + "'",
             "peers " + fine,
             "peers /nowhere/nothing.json"}) {
        CAPTURE(line);
        const Outcome outcome = runProgram(line);
        CHECK(outcome.code == 1);
        CHECK(outcome.out.empty());
        CAPTURE(outcome.error);
        CHECK(outcome.errorLines() == 1);
        CHECK(outcome.error.rfind("muster: ", 0) == 0);
        const Outcome quiet = runProgram(line + " --json");
        CHECK(quiet.code == 1);
    }
}

TEST_CASE("play reports every result by name, records a take that replays, and writes the trajectory") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    const std::string common = "play '" + small + "' --gestures '" + drag + "' --seconds 8";
    const Outcome outcome = runProgram(common + " --json --take '" + path("a.take") + "' --trajectory '" +
                                       path("a.csv") + "'");
    REQUIRE_MESSAGE(outcome.code == 0, outcome.error);
    CHECK(outcome.error.empty());
    const Json figures = json(outcome);
    for (const char* key : {"characters", "steps", "hash", "arrived95_s", "arrived100_s", "stuck",
                            "path_ratio", "overlap_pairs_max", "worst_penetration_pct", "top_speed_ratio",
                            "swaps_per_character_per_s", "planned", "walked", "step_ms"}) {
        CAPTURE(key);
        CHECK(figures.contains(key));
    }
    CHECK(figures["characters"] == 9);
    const Json& walked = figures["walked"];
    CHECK(walked["sum_m"].get<double>() > walked["longest_m"].get<double>());
    CHECK(walked["sum_m"].get<double>() <= 9 * walked["longest_m"].get<double>());
    CHECK(figures["planned"]["squares_m2"].get<double>() >= 0.0);
    CHECK(figures["steps"] == 480);
    CHECK(figures["path_ratio"].is_null());
    CHECK(figures["step_ms"]["stages"].size() == muster::kStageCount);
    CHECK(figures["events"]["arrived"] == 1);
    CHECK(figures["events"]["stuck"] == 0);
    CHECK(figures["events"]["noPath"] == 0);
    CHECK(figures["standings"][0]["inPlace"] == 9);
    CHECK(figures["standings"][0]["outside"] == 0);
    // The same run on two threads and as text gives the same hash.
    const Outcome text = runProgram(common + " --threads 2");
    CHECK(text.out.find(figures["hash"].get<std::string>()) != std::string::npos);
    CHECK(text.out.find("arrived95_s") != std::string::npos);
    CHECK(text.out.find("everybody is in place.") != std::string::npos);

    const Json replayed = json(runProgram("replay '" + path("a.take") + "' --json"));
    CHECK(replayed["events"] == 1);
    CHECK(replayed["figures"]["events"] == figures["events"]);
    CHECK(replayed["reproduced"] == true);
    CHECK(replayed["hash"] == figures["hash"]);
    CHECK(replayed["steps"] == 480);
    for (const char* key :
         {"characters", "steps", "hash", "arrived100_s", "stuck", "overlap_pairs_max", "unmatched"})
        CHECK(replayed["figures"][key] == figures[key]);
    CHECK(runProgram("replay '" + path("a.take") + "'").out.find("reproduced") == 0);

    const std::string csv = slurp(path("a.csv"));
    CHECK(csv.rfind("t,id,x,y,place_x,place_y,group,heading,motion,goal\n0,1,", 0) == 0);
    CHECK(std::count(csv.begin(), csv.end(), '\n') == 1 + 9 * 481);
}

TEST_CASE("without seconds a run ends when all characters stand") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    const Json figures = json(runProgram("play '" + small + "' --gestures '" + drag + "' --json"));
    CHECK(figures["steps"].get<int>() > 150);
    CHECK(figures["steps"].get<int>() < 20 * 60);
    CHECK(figures["arrived100_s"].is_number());
}

TEST_CASE("parameters from the command line change the run") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    const std::string common = "play '" + small + "' --gestures '" + drag + "' --seconds 3 --json ";
    const Json plain = json(runProgram(common)),
               slow = json(runProgram(common + "--set character.maxSpeed=0.5 --set density.enabled=0"));
    const Json paper = json(runProgram(common + "--preset paper"));
    CHECK(plain["hash"] != slow["hash"]);
    CHECK(plain["hash"] != paper["hash"]);
    CHECK(slow["lag_p95_m"].get<double>() > plain["lag_p95_m"].get<double>());
}

TEST_CASE("a take that does not reproduce gives exit code 3 and names the step") {
    const auto def = muster::parseScenario(kSmall, "small", "");
    REQUIRE(def.ok());
    auto bytes = muster::TakeEncoder::begin(*def);
    const auto end = muster::TakeEncoder::end({60, 0x0123456789abcdefull});
    bytes.insert(bytes.end(), end.begin(), end.end());
    const std::string take = "replay '" + put("b.take", std::string(bytes.begin(), bytes.end())) + "'";
    const Outcome other = runProgram(take);
    CHECK(other.code == 3);
    CHECK(other.errorLines() == 1);
    CHECK(other.error.find("step 60:") != std::string::npos);
    const Outcome asJson = runProgram(take + " --json");
    CHECK(asJson.code == 3);
    CHECK(json(asJson)["reproduced"] == false);
}

TEST_CASE("damaged takes are refused, incomplete ones are replayed up to their end") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    REQUIRE(runProgram("play '" + small + "' --gestures '" + drag + "' --seconds 2 --take '" +
                       path("c.take") + "'")
                .code == 0);
    const std::string bytes = slurp(path("c.take"));
    std::string damaged = bytes;
    damaged[damaged.size() - 8] ^= 1;  // In the last hash: the checksum detects it.
    const Outcome corrupt = runProgram("replay '" + put("d.take", damaged) + "'");
    CHECK(corrupt.code == 1);
    CHECK(corrupt.error.find("offset") != std::string::npos);
    const Outcome torn = runProgram("replay '" + put("e.take", bytes.substr(0, bytes.size() - 5)) + "'");
    CHECK(torn.code == 0);
    CHECK(torn.error.find("torn") != std::string::npos);
}

TEST_CASE("check distinguishes good files from bad ones") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag),
                      bad = put("bad2.json", "{}");
    const Outcome both = runProgram("check '" + small + "' '" + bad + "' '" + drag + "' --json");
    CHECK(both.code == 1);
    const Json list = json(both);
    REQUIRE(list.size() == 3);
    CHECK(list[0]["good"] == true);
    CHECK(list[0]["kind"] == "scenario");
    CHECK(list[1]["good"] == false);
    CHECK(list[1]["error"].get<std::string>().find("format") != std::string::npos);
    CHECK(list[2]["kind"] == "gestures");
    CHECK(runProgram("check scenarios/*.json scenarios/gestures/*.json").code == 0);
    CHECK(Json::parse(runProgram("check --schema").out, nullptr, false).contains("properties"));
}

TEST_CASE("import puts the group where there is most free ground") {
    // Two chambers: 3 x 3 and 7 x 6 cells; the crowd belongs in the middle of the larger.
    const std::string map = put("rooms.map",
                                "type octile\nheight 8\nwidth 13\nmap\n"
                                "@@@@@@@@@@@@@\n@...@.......@\n@...@.......@\n@...@.......@\n"
                                "@@@@@.......@\n@@@@@.......@\n@@@@@.......@\n@@@@@@@@@@@@@\n");
    const std::string out = path("rooms.json");
    const Outcome outcome = runProgram("import '" + map + "' -o '" + out + "' --cell 2 --count 16 --json");
    REQUIRE_MESSAGE(outcome.code == 0, outcome.error);
    const Json value = json(outcome);
    CHECK(value["width_m"] == 26.0);
    CHECK(std::abs(value["position"][0].get<double>() - 17.0) <= 1.5);
    CHECK(std::abs(value["position"][1].get<double>() - 8.0) <= 1.0);
    CHECK(runProgram("check '" + out + "'").code == 0);
    const Json figures = json(runProgram("play '" + out + "' --seconds 1 --json"));
    CHECK(figures["unmatched"] == 0);
}

TEST_CASE("pictures are made of scenarios and takes") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    REQUIRE(runProgram("picture '" + small + "' --gestures '" + drag + "' --at 2 -o '" + path("p.png") + "'")
                .code == 0);
    CHECK(slurp(path("p.png")).substr(1, 3) == "PNG");
    REQUIRE(runProgram("play '" + small + "' --gestures '" + drag + "' --seconds 3 --take '" +
                       path("p.take") + "'")
                .code == 0);
    const Outcome svg = runProgram("picture '" + path("p.take") +
                                   "' --at 2 --layers cost,mesh --dark --json -o '" + path("p.svg") + "'");
    REQUIRE_MESSAGE(svg.code == 0, svg.error);
    CHECK(json(svg)["t"].get<double>() == doctest::Approx(2.0));
    CHECK(slurp(path("p.svg")).find("</svg>") != std::string::npos);
}

TEST_CASE("peers runs scenes with explicit starts and slots") {
    const std::string scenes = put(
        "scenes.json",
        R"({"scenes":{"A":{"n":3,"T":20,"world":[-3,-5,12,5],"polygons_ccw":[[[3,-1],[4,-1],[4,1],[3,1]]],
        "circles":[[6,3,0.5]],"start":[[0,0.4],[0,1.4],[0,-0.6]],"slots":[[8,0],[8,1],[8,-1]]},
        "B":{"n":1,"T":5,"world":[-3,-5,12,5],"start":[[0,0]],"slots":[[2,0]]}}})");
    const Outcome outcome = runProgram("peers '" + scenes + "' --json --trajectory '" + path("peers.csv") +
                                       "'");
    REQUIRE_MESSAGE(outcome.code == 0, outcome.error);
    const Json list = json(outcome);
    REQUIRE(list.size() == 2);
    CHECK(list[0]["scene"] == "A");
    CHECK(list[0]["stuck"] == 0);
    CHECK(list[0]["arrived100_s"].get<double>() > 3.5);
    CHECK(list[0]["arrived100_s"].get<double>() < 8.0);
    CHECK(list[0]["path_ratio"].get<double>() < 1.1);
    CHECK(list[1]["arrived100_s"].get<double>() < 2.0);
    // One file per scene; for a single scene the file itself.
    CHECK(!std::filesystem::exists(path("peers.csv")));
    CHECK(slurp(path("peers-A.csv"))
              .rfind("t,id,x,y,place_x,place_y,group,heading,motion,goal\n0,1,0,0.4,", 0) == 0);
    CHECK(
        slurp(path("peers-B.csv")).rfind("t,id,x,y,place_x,place_y,group,heading,motion,goal\n0,1,0,0,", 0) ==
        0);
    REQUIRE(runProgram("peers '" + scenes + "' --scene B --trajectory '" + path("peers.csv") + "'").code ==
            0);
    CHECK(slurp(path("peers.csv")) == slurp(path("peers-B.csv")));
    const Outcome one = runProgram("peers '" + scenes + "' --scene B");
    CHECK(one.code == 0);
    CHECK(one.out.find("| B ") != std::string::npos);
    CHECK(runProgram("peers '" + scenes + "' --scene C").code == 1);
    // A character that has to speed up first arrives later: by the time constant of its velocity, 1 / 12 s,
    // and by the effect of the acceleration limit.
    const Outcome slow = runProgram("peers '" + scenes + "' --scene B --inertia --json");
    REQUIRE(slow.code == 0);
    const double later = json(slow)[0]["arrived100_s"].get<double>() - list[1]["arrived100_s"].get<double>();
    CHECK(later > 0.05);
    CHECK(later < 0.3);
}

TEST_CASE("peers: invalid scenes are refused, naming file and scene") {
    const auto run = [](const std::string& limit, const std::string& world, const std::string& more) {
        return runProgram("peers '" +
                          put("odd.scenes.json", R"({"scenes":{"Odd":{"T":)" + limit + R"(,"world":)" +
                                                     world + R"(,"start":[[0,0]],"slots":[[2,0]])" + more +
                                                     "}}}") +
                          "'");
    };
    CHECK(run("2", "[-3,-5,12,5]", "").code == 0);
    const std::vector<Outcome> bad = {
        run("-5", "[-3,-5,12,5]", ""),
        run("0", "[-3,-5,12,5]", ""),
        run("1e300", "[-3,-5,12,5]", ""),
        run("2", "[0,0,900000,900000]", ""),
        run("2", "[5,5,0,0]", ""),
        run("2", "[-3,-5,12,5]", R"(,"circles":[[3,0,-1]])"),
        run("2", "[-3,-5,12,5]", R"(,"polygons_ccw":[[[0,0],[1,1],[1,0],[0,1]]])")};
    for (const Outcome& outcome : bad) {
        CHECK(outcome.code == 1);
        CHECK(outcome.errorLines() == 1);
        CHECK(outcome.error.find("odd.scenes.json: $.scenes.Odd") != std::string::npos);
    }
}

TEST_CASE("a take's touches become a gestures file that gives the same run") {
    const std::string small = put("small.json", kSmall), drag = put("drag.json", kDrag);
    const std::string common = "play '" + small + "' --seconds 4 --json --gestures '";
    const Json first = json(runProgram(common + drag + "' --take '" + path("g.take") + "'"));
    REQUIRE(runProgram("replay '" + path("g.take") + "' --gestures '" + path("again.json") + "'").code == 0);
    const Json again = json(runProgram(common + path("again.json") + "'"));
    CHECK(again["hash"] == first["hash"]);
    CHECK(json(runProgram("play '" + small + "' --seconds 4 --json"))["hash"] != first["hash"]);
    CHECK(runProgram("check '" + path("again.json") + "'").code == 0);
}

TEST_CASE("no file is both read and written, and none is written twice") {
    const std::string small = put("self.json", kSmall), drag = put("self_drag.json", kDrag);
    const std::string play = "play '" + small + "' --seconds 0.1 ";
    std::filesystem::remove(path("link.json"));
    std::filesystem::create_symlink(small, path("link.json"));
    REQUIRE(runProgram(play + "--take '" + path("self.take") + "'").code == 0);
    for (const std::string& line : std::vector<std::string>{
             play + "--take '" + small + "'", play + "--trajectory '" + small + "'",
             play + "--take '" + path("link.json") + "'",
             play + "--gestures '" + drag + "' --take '" + drag + "'",
             play + "--take '" + path("new.x") + "' --trajectory '" + path("./new.x") + "'",
             "picture '" + small + "' -o '" + small + "'", "import '" + small + "' -o '" + small + "'",
             "replay '" + path("self.take") + "' --gestures '" + path("self.take") + "'",
             "peers '" + small + "' --trajectory '" + small + "'"}) {
        CAPTURE(line);
        const Outcome outcome = runProgram(line);
        CHECK(outcome.code == 1);
        CHECK(outcome.errorLines() == 1);
    }
    CHECK(slurp(small) == kSmall);
    CHECK(slurp(drag) == kDrag);
    CHECK(!std::filesystem::exists(path("new.x")));
    CHECK(runProgram("replay '" + path("self.take") + "'").code == 0);
}

TEST_CASE("output that cannot be written is a failure") {
    const std::string small = put("small.json", kSmall);
    for (const std::string& line : std::vector<std::string>{
             "play '" + small + "' --seconds 0.1", "play '" + small + "' --seconds 0.1 --json",
             "check '" + small + "'", "check --schema", "--help", "play --help"}) {
        CAPTURE(line);
        const Outcome outcome = runProgram(line + " >/dev/full");
        CHECK(outcome.code == 1);
        CHECK(outcome.error == "muster: standard output cannot be written in full\n");
    }
}

TEST_CASE("a world too large for the memory gives one sentence and exit code 1") {
#if defined(__SANITIZE_ADDRESS__)
    MESSAGE("skipped: the sanitizer needs the memory itself");
#else
    const std::string vast = put(
        "vast.json", R"({"format":"muster-scenario","version":1,"box":[[0,0],[1000,1000]],"cell":0.25,
        "groups":[{"count":1,"position":[500,500]}]})");
    const Outcome outcome = runProgram("play '" + vast + "' --seconds 0.1", "ulimit -v 100000");
    CHECK(outcome.code == 1);
    CHECK(outcome.error == "muster: the memory does not suffice\n");
#endif
}

TEST_CASE("warnings go to standard error and change nothing") {
    const std::string scenario = R"({"format":"muster-scenario","version":1,"box":[[-6,-5],[6,5]],
        "obstacles":[{"polygon":[[0,-1],[0.5,-1],[0.5,1],[0,1]]},{"polygon":[[0.8,-1],[1.5,-1],[1.5,1],[0.8,1]]}],
        "groups":[{"count":4,"position":[-3,0]}]})";
    const std::string narrow = put("narrow_gap.json", scenario);
    for (const std::string& line :
         std::vector<std::string>{"play '" + narrow + "' --seconds 0.1 --json",
                                  "picture '" + narrow + "' -o '" + path("narrow.png") + "'"}) {
        const Outcome outcome = runProgram(line);
        CHECK(outcome.code == 0);
        CHECK(outcome.errorLines() == 1);
        CHECK(outcome.error.find("narrow_gap.json: warning: the gap between") != std::string::npos);
        CHECK(outcome.error.find("0.30 m") != std::string::npos);
    }
}

TEST_CASE("names in other scripts are drawn as far as the font allows") {
    const std::string named = put(
        "named.json",
        "{\"format\":\"muster-scenario\",\"version\":1,\"box\":[[-6,-5],[6,5]],\"cell\":0.5,"
        "\"patches\":[{\"name\":\"Flu\xc3\x9f "
        "\xe6\xb3\xb3\",\"polygon\":[[-5,-4],[5,-4],[5,4],[-5,4]],\"motion\":\"swim\"}],"
        "\"groups\":[{\"count\":4,\"position\":[-3,0]}]}");
    const std::string plain = put(
        "plain.json",
        "{\"format\":\"muster-scenario\",\"version\":1,\"box\":[[-6,-5],[6,5]],\"cell\":0.5,"
        "\"patches\":[{\"name\":\"Flus ?\",\"polygon\":[[-5,-4],[5,-4],[5,4],[-5,4]],\"motion\":\"swim\"}],"
        "\"groups\":[{\"count\":4,\"position\":[-3,0]}]}");
    const auto picture = [](const std::string& file) {
        REQUIRE(runProgram("picture '" + file + "' -o '" + path("named.png") + "'").code == 0);
        return slurp(path("named.png"));
    };
    const bool same = picture(named) == picture(plain);
    CHECK(same);
}
