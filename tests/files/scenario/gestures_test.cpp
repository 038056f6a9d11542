#include "base/text_file.h"
#include "muster/scenario.h"
#include "test_folders.h"

#include <doctest.h>

#include <filesystem>
#include <string>

#include "base/archive.h"
#include "engine/state/command_archive.h"
#include "files/scenario/schema_validator.h"
#include "generated/random_commands.h"

using namespace muster;

namespace {

constexpr double kStep = 1.0 / 60.0;

std::string file(const std::string& events) {
    return R"({"format":"muster-gestures","version":1,"events":[)" + events + "]}";
}

std::string gesturesFailure(const std::string& events) {
    const auto commands = parseGestures(file(events), "G.json", kStep);
    return commands.ok() ? "" : commands.status().message();
}

std::vector<std::uint8_t> bytesOf(const std::vector<Command>& commands) {
    Writer writer;
    for (const Command& command : commands) encodeCommand(writer, command);
    return writer.take();
}

}  // namespace

TEST_CASE("touches become commands of the step that contains their time") {
    const auto commands = parseGestures(file(R"({"t":1.25,"kind":"move","touch":1,"x":3,"y":4},
        {"t":0,"kind":"down","touch":1,"x":1,"y":2,"group":2},
        {"t":0.05,"kind":"up","touch":9,"client":3},
        {"t":2,"kind":"cancel","touch":1})"),
                                        "G", kStep);
    REQUIRE_MESSAGE(commands.ok(), commands.status().message());
    REQUIRE(commands->size() == 4);
    const auto& down = std::get<Touch>((*commands)[0].body);
    CHECK(down.position == Vec2{1, 2});
    CHECK(down.group == GroupId{2});
    CHECK((*commands)[0].step == 0);
    CHECK((*commands)[0].client == 1);
    CHECK((*commands)[1].step == 3);  // 0.05 s is exactly three steps, despite rounding.
    CHECK((*commands)[1].client == 3);
    CHECK((*commands)[2].step == 75);
    CHECK(std::get<Touch>((*commands)[2].body).time == 1.25);
    CHECK((*commands)[2].sequence == 1);
    CHECK((*commands)[3].sequence == 2);
}

TEST_CASE("events of one step keep their order") {
    const auto commands = parseGestures(file(R"({"t":0.016,"kind":"down","touch":1,"x":0,"y":0},
        {"t":0.001,"kind":"formation","group":1,"formation":"wedge"})"),
                                        "G", kStep);
    REQUIRE(commands.ok());
    CHECK((touchOf((*commands)[0].body, TouchPhase::Down) != nullptr));
    CHECK(std::get<ChangeGroup>((*commands)[1].body).formation->kind == FormationKind::Wedge);
}

TEST_CASE("every kind of command survives the file") {
    std::vector<CommandBody> bodies;
    CommandDraw draw(2);
    for (std::size_t kind = 0; kind < std::variant_size_v<CommandKinds>; ++kind)
        for (int k = 0; k < 16; ++k) bodies.push_back(randomCommand(kind, draw));
    std::vector<Command> commands;
    std::uint32_t next[3] = {0, 0, 0};
    for (std::uint32_t i = 0; i < bodies.size(); ++i)
        commands.push_back({100 + i / 2, i % 2, next[i % 2]++, bodies[i]});
    const std::string text = writeGestures(commands, kStep);
    const auto back = parseGestures(text, "G", kStep);
    REQUIRE_MESSAGE(back.ok(), back.status().message());
    CHECK(bytesOf(*back) == bytesOf(commands));
    const auto conforms = testing::breaks(testing::Json::parse(gesturesSchema()), testing::Json::parse(text));
    CHECK(conforms == "");
}

TEST_CASE("errors are reported by field") {
    CHECK(gesturesFailure(R"({"kind":"up","touch":1})").find("G.json: $.events[0]: found no \"t\"") == 0);
    CHECK(gesturesFailure(R"({"t":-1,"kind":"up","touch":1})").find("$.events[0].t:") != std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"poke","touch":1})").find("$.events[0].kind:") !=
          std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"down","touch":1,"x":0})").find("no \"y\"") != std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"up","touch":1,"x":0})").find("unknown key \"x\"") !=
          std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"up","touch":1.5})").find("$.events[0].touch:") !=
          std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"formation","group":1,"formation":"blob"})")
              .find("$.events[0].formation.kind:") != std::string::npos);
    CHECK(gesturesFailure(R"({"t":1,"kind":"parameter","name":"plan.exponent","value":0})")
              .find("$.events[0]") != std::string::npos);
    CHECK(!parseGestures("{}", "G", kStep).ok());
    CHECK(!parseGestures(R"({"format":"muster-scenario","version":1,"events":[]})", "G", kStep).ok());
}

TEST_CASE("a scenario's gestures lie in its folder or below, and are read for its step time") {
    const auto folder = std::filesystem::temp_directory_path() / "muster_scenario_gestures_test";
    std::filesystem::create_directories(folder / "touches");
    const std::string scenario = (folder / "s.json").string();
    REQUIRE(
        writeTextFile((folder / "touches/a.json").string(),
                      R"({"format":"muster-gestures","version":1,"events":[{"t":1,"kind":"up","touch":3}]})")
            .ok());
    WorldDef def{.parameters = {.stepTime = 0.25}};
    CHECK(loadScenarioGestures(scenario, def)->empty());
    def.gestures = "touches/a.json";
    const auto commands = loadScenarioGestures(scenario, def);
    REQUIRE_MESSAGE(commands.ok(), commands.status().message());
    REQUIRE(commands->size() == 1);
    CHECK(commands->front().step == 4);
    def.gestures = "touches/..named.json";
    auto failed = loadScenarioGestures(scenario, def);
    CHECK(failed.status().code() == StatusCode::IoError);
    CHECK(failed.status().message().rfind(scenario + ": $.gestures: ", 0) == 0);
    def.gestures = "touches/../touches/a.json";
    failed = loadScenarioGestures(scenario, def);
    CHECK(failed.status().code() == StatusCode::InvalidArgument);
    CHECK(failed.status().message().find("$.gestures: found the text") != std::string::npos);
    std::filesystem::remove_all(folder);
}

TEST_CASE("shipped gestures are valid, one file per scenario") {
    int count = 0;
    const std::string folder = sourceFolder() + "/scenarios/gestures";
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        CAPTURE(entry.path().string());
        const auto commands = loadGestures(entry.path().string(), kStep);
        REQUIRE_MESSAGE(commands.ok(), commands.status().message());
        CHECK(commands->size() > 10);
        CHECK(std::filesystem::exists(entry.path().parent_path().parent_path() / entry.path().filename()));
        ++count;
    }
    CHECK(count >= 6);
}
