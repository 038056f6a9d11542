// Scenarios, gestures, takes and export by the C API, against the C++ API.
#include <doctest.h>

#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>

#include "bindings/c/both_worlds.h"
#include "muster/export.h"
#include "muster/own_clips.h"
#include "muster/scenario.h"
#include "muster/take.h"
#include "temporary_folder.h"
#include "test_folders.h"

using namespace muster;

namespace {

std::string bytesOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string takeText(MusterBuffer& buffer) {
    std::string text(reinterpret_cast<const char*>(buffer.data), buffer.size);
    muster_free_buffer(&buffer);
    return text;
}

/// Records 130 steps with the sample script in C, and gives the last hash.
std::uint64_t recordInC(const std::string& path) {
    const WorldDef def = makeDef();
    c_api::Arena arena;
    const MusterWorldDef same = asC<MusterWorldDef>(def, arena);
    MusterTakeWriterId writer{};
    MusterWorldId world{};
    REQUIRE(muster_world_create(&same, 1, &world) == MUSTER_OK);
    REQUIRE(muster_take_writer_create(path.c_str(), &same, true, &writer) == MUSTER_OK);
    const auto script = sampleScript(*World::create(def));
    std::uint32_t sequence = 0;
    for (std::uint32_t step = 0; step < 130; ++step) {
        for (const auto& [when, body] : script) {
            if (when != step) continue;
            const Command command{step, 1, sequence++, body};
            const MusterCommand given = asC<MusterCommand>(command, arena);
            REQUIRE(muster_world_submit(world, &given) == MUSTER_OK);
            REQUIRE(muster_take_writer_command(writer, &given) == MUSTER_OK);
        }
        REQUIRE(muster_world_step(world) == MUSTER_OK);
        REQUIRE(muster_take_writer_observe(writer, world) == MUSTER_OK);
    }
    REQUIRE(muster_take_writer_finish(writer, world) == MUSTER_OK);
    CHECK(muster_take_writer_finish(writer, world) == MUSTER_NOT_FOUND);
    std::uint64_t hash = 0;
    CHECK(muster_world_hash(world, &hash) == MUSTER_OK);
    CHECK(muster_world_destroy(world) == MUSTER_OK);
    return hash;
}

}  // namespace

TEST_SUITE("files in C") {
    TEST_CASE("a scenario file gives the same world, text and warnings") {
        const std::string path = sourceFolder() + "/scenarios/open.json";
        MusterScenarioId scenario{};
        REQUIRE(muster_scenario_load(path.c_str(), &scenario) == MUSTER_OK);
        const WorldDef def = *loadScenario(path);
        MusterBuffer text{};
        REQUIRE(muster_scenario_text(scenario, &text) == MUSTER_OK);
        const std::string written = takeText(text);
        CHECK(written == writeScenario(def));
        MusterWorldId world{}, other{};
        REQUIRE(muster_scenario_create_world(scenario, 1, &world) == MUSTER_OK);
        MusterWorldDef read = muster_default_world_def();
        REQUIRE(muster_scenario_def(scenario, &read) == MUSTER_OK);
        CHECK(def.name == read.name);
        REQUIRE(muster_world_create(&read, 1, &other) == MUSTER_OK);
        std::uint64_t first = 0, second = 0;
        CHECK(muster_world_hash(world, &first) == MUSTER_OK);
        CHECK(muster_world_hash(other, &second) == MUSTER_OK);
        CHECK(first == World::create(def)->hash());
        CHECK(first == second);
        CHECK(muster_world_destroy(world) == MUSTER_OK);
        CHECK(muster_world_destroy(other) == MUSTER_OK);

        MusterScenarioId again{};
        REQUIRE(muster_scenario_parse(written.data(), written.size(), "text", nullptr, &again) == MUSTER_OK);
        MusterScenarioId third{};
        REQUIRE(muster_scenario_from_def(&read, &third) == MUSTER_OK);
        CHECK(muster_scenario_text(third, &text) == MUSTER_OK);
        CHECK(takeText(text) == written);
        for (const MusterScenarioId id : {scenario, again, third})
            CHECK(muster_scenario_destroy(id) == MUSTER_OK);
        CHECK(muster_scenario_destroy(scenario) == MUSTER_NOT_FOUND);
    }

    TEST_CASE("warnings, schemas and faults have the engine's sentences") {
        WorldDef def = makeDef();
        def.obstacles[1].polygon = {{4, 3.1}, {5, 3.1}, {5, 4.1}, {4, 4.1}};
        def.obstacles[1].path = {};
        c_api::Arena arena;
        const MusterWorldDef same = asC<MusterWorldDef>(def, arena);
        MusterScenarioId scenario{};
        REQUIRE(muster_scenario_from_def(&same, &scenario) == MUSTER_OK);
        const char* const* sentences = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_scenario_warnings(scenario, 20, &sentences, &count) == MUSTER_OK);
        const std::vector<std::string> expected = scenarioWarnings(def);
        REQUIRE(!expected.empty());
        REQUIRE(count == static_cast<int>(expected.size()));
        for (std::size_t i = 0; i < expected.size(); ++i) CHECK(expected[i] == sentences[i]);
        CHECK(muster_scenario_destroy(scenario) == MUSTER_OK);
        MusterBuffer text{};
        CHECK(muster_scenario_schema(&text) == MUSTER_OK);
        CHECK(takeText(text) == scenarioSchema());
        CHECK(muster_gestures_schema(&text) == MUSTER_OK);
        CHECK(takeText(text) == gesturesSchema());
        const std::string broken = R"({"groups": 7})";
        CHECK(muster_scenario_parse(broken.data(), broken.size(), "broken", nullptr, &scenario) != MUSTER_OK);
        CHECK(std::string(muster_last_error()) == parseScenario(broken, "broken", "").status().message());
        CHECK(muster_scenario_load("/no/such/file", &scenario) == MUSTER_IO_ERROR);
        CHECK(muster_scenario_load(nullptr, &scenario) == MUSTER_INVALID_ARGUMENT);
    }

    TEST_CASE("gestures come through C and back") {
        const std::vector<Command> commands{{6, 1, 0, Touch{TouchPhase::Down, 1, {1, 2}, 0.1, {}}},
                                            {12, 1, 1, Touch{TouchPhase::Move, 1, {2, 2}, 0.2, {}}},
                                            {18, 1, 2, Touch{TouchPhase::Up, 1, {}, 0.3, {}}}};
        const double stepTime = 1.0 / 60.0;
        const std::string text = writeGestures(commands, stepTime);
        MusterCommandListId list{};
        REQUIRE(muster_gestures_parse(text.data(), text.size(), "text", stepTime, &list) == MUSTER_OK);
        const MusterCommand* read = nullptr;
        std::int32_t count = 0;
        REQUIRE(muster_command_list_get(list, &read, &count) == MUSTER_OK);
        REQUIRE(count == 3);
        CHECK(read[1].kind == MUSTER_COMMAND_TOUCH);
        CHECK(read[1].body.touch.position.x == 2.0);
        MusterBuffer again{};
        REQUIRE(muster_gestures_text(read, count, stepTime, &again) == MUSTER_OK);
        CHECK(takeText(again) == text);
        CHECK(muster_gestures_text(read, count, 0.0, &again) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_command_list_destroy(list) == MUSTER_OK);
        CHECK(muster_gestures_parse_commands("[{}]", 4, "NAME", stepTime, &list) != MUSTER_OK);
        CHECK(std::string(muster_last_error()) == parseCommands("[{}]", "NAME", stepTime).status().message());
    }

    TEST_CASE("a take recorded in C is the file that the C++ API writes, and replays to the same hash") {
        const testing::TemporaryFolder folder("capi");
        const std::string path = folder / "c.take", other = folder / "cpp.take";
        const std::uint64_t hash = recordInC(path);

        World world = *World::create(makeDef());
        TakeWriter writer = *TakeWriter::create(other, makeDef());
        std::uint32_t sequence = 0;
        const auto script = sampleScript(world);
        for (std::uint32_t step = 0; step < 130; ++step) {
            for (const auto& [when, body] : script) {
                if (when != step) continue;
                const Command command{step, 1, sequence++, body};
                REQUIRE(world.submit(command).ok());
                REQUIRE(writer.command(command).ok());
            }
            world.step();
            REQUIRE(writer.observe(world).ok());
        }
        REQUIRE(writer.finish(world).ok());
        CHECK(bytesOf(path) == bytesOf(other));
        CHECK(hash == world.hash());

        MusterTakeId take{};
        REQUIRE(muster_take_read(path.c_str(), &take) == MUSTER_OK);
        MusterTake read = muster_default_take();
        REQUIRE(muster_take_get(take, &read) == MUSTER_OK);
        const Take expected = *readTake(path);
        CHECK(read.finished);
        CHECK(read.steps == 130);
        CHECK(read.commandCount == static_cast<int>(expected.commands.size()));
        CHECK(read.commands[3].kind == MUSTER_COMMAND_GIVE_ORDER);
        REQUIRE(read.markCount == static_cast<int>(expected.marks.size()));
        CHECK(read.marks[0].hash == expected.marks[0].hash);
        CHECK(read.eventCount == static_cast<int>(expected.events.size()));
        REQUIRE(read.frameCount == static_cast<int>(expected.frames.size()));
        CHECK(read.frames[0].positions[2].x == expected.frames[0].positions[2].x);
        CHECK(expected.scenario == read.scenario);
        double speed = 0.0;
        CHECK(muster_take_speed_at(take, 1.0, &speed) == MUSTER_OK);
        CHECK(speed == 1.0);
        bool alike = false;
        CHECK(muster_take_simulates_alike(take, 1, &alike) == MUSTER_OK);
        CHECK(alike);

        struct Seen {
            int calls = 0;
            MusterWorldId last{};
        } seen;
        MusterReplayReport report{};
        const auto observe = [](void* context, MusterWorldId shown) -> bool {
            auto& counts = *static_cast<Seen*>(context);
            counts.last = shown;
            std::uint32_t steps = 0;
            CHECK(muster_world_step_count(shown, &steps) == MUSTER_OK);
            CHECK(static_cast<int>(steps) == ++counts.calls);
            CHECK(muster_world_step(shown) == MUSTER_UNSUPPORTED);
            CHECK(muster_world_destroy(shown) == MUSTER_UNSUPPORTED);
            return true;
        };
        REQUIRE(muster_take_replay(take, 1, MUSTER_REPLAY_SIMULATION, observe, &seen, &report) == MUSTER_OK);
        CHECK(seen.calls == 130);
        CHECK(!muster_world_is_valid(seen.last));
        CHECK(report.hash == hash);
        CHECK(report.compared == 3);
        CHECK(muster_take_replay(take, 1, 2, nullptr, nullptr, &report) == MUSTER_INVALID_ARGUMENT);
        CHECK(muster_take_destroy(take) == MUSTER_OK);

        std::string broken = bytesOf(path);
        broken[broken.size() / 2] = static_cast<char>(broken[broken.size() / 2] ^ 1);
        const auto* const bytes = reinterpret_cast<const std::uint8_t*>(broken.data());
        CHECK(muster_take_parse(bytes, broken.size(), "broken", &take) == MUSTER_CORRUPT);
        CHECK(std::string(muster_last_error()) ==
              parseTake({bytes, broken.size()}, "broken").status().message());
        CHECK(muster_take_read("/no/such/file", &take) == MUSTER_IO_ERROR);
    }

    TEST_CASE("an export in C writes the bytes of the C++ API, tells its progress and can be ended") {
        const testing::TemporaryFolder folder("capi");
        const std::string path = folder / "c.take";
        recordInC(path);
        MusterTakeId take{};
        MusterClipLibraryId library{};
        REQUIRE(muster_take_read(path.c_str(), &take) == MUSTER_OK);
        REQUIRE(muster_clips_own(&library) == MUSTER_OK);
        MusterExportDef def = muster_default_export_def();
        def.to = 0.5;
        std::vector<double> shares;
        const auto progress = [](void* context, double share) -> bool {
            static_cast<std::vector<double>*>(context)->push_back(share);
            return true;
        };
        std::int32_t formats = 0;
        const MusterExportFormat* const all = muster_export_formats(&formats);
        REQUIRE(formats == static_cast<int>(exportFormats().size()));
        for (std::int32_t i = 0; i < formats; ++i) {
            const std::string name = all[i].name;
            CAPTURE(name);
            MusterExportFormat format{};
            CHECK(muster_export_format(all[i].name, &format) == MUSTER_OK);
            CHECK(std::string(format.ending) == all[i].ending);
            if (name != "glb" && name != "bvh") continue;
            const std::string mine = folder / ("c" + std::string(format.ending));
            const std::string other = folder / ("cpp" + std::string(format.ending));
            REQUIRE(muster_export_take(take, library, name.c_str(), mine.c_str(), &def, progress, &shares) ==
                    MUSTER_OK);
            ExportDef same{.to = 0.5};
            REQUIRE(exportTake(*readTake(path), ownClips(), name, other, same).ok());
            if (name == "glb") CHECK(bytesOf(mine) == bytesOf(other));
            CHECK(std::filesystem::exists(mine));
        }
        CHECK(shares.size() > 2);
        CHECK(shares.back() == doctest::Approx(1.0));
        const std::string none = folder / "none.glb";
        const auto stop = [](void*, double) -> bool { return false; };
        CHECK(muster_export_take(take, library, "glb", none.c_str(), nullptr, stop, nullptr) ==
              MUSTER_UNSUPPORTED);
        CHECK(!std::filesystem::exists(none));
        CHECK(muster_export_take(take, library, "avi", none.c_str(), nullptr, nullptr, nullptr) ==
              MUSTER_NOT_FOUND);
        CHECK(std::string(muster_last_error()) == exportFormat("avi").status().message());
        def.structVersion = 0;
        CHECK(muster_export_take(take, library, "glb", none.c_str(), &def, nullptr, nullptr) ==
              MUSTER_INVALID_ARGUMENT);
        CHECK(muster_export_take({0, 0}, library, "glb", none.c_str(), nullptr, nullptr, nullptr) ==
              MUSTER_NOT_FOUND);
        CHECK(muster_take_destroy(take) == MUSTER_OK);
        CHECK(muster_clips_destroy(library) == MUSTER_OK);
    }
}
