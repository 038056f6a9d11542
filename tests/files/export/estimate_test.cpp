// What is told of the size of an export before it is made, against the real files.
#include <doctest.h>

#include <cmath>

#include "files/export/export_fixture.h"
#include "muster/parameter_table.h"
#include "muster/scenario.h"
#include "test_folders.h"

using namespace muster;
using namespace muster::testing;

namespace {

/// A take of a shipped scenario with the touches that belong to it.
Take recorded(const std::string& scenario, int seconds) {
    const std::string folder = sourceFolder() + "/scenarios/", file = (exportFolder() / "told.take").string();
    const WorldDef def = loadScenario(folder + scenario + ".json").value();
    auto world = World::create(def);
    auto writer = TakeWriter::create(file, def);
    REQUIRE_MESSAGE(writer.ok(), writer.status().message());
    const std::vector<Command> touches = loadScenarioGestures(folder + scenario + ".json", def).value();
    for (const Command& touch : touches) {
        REQUIRE(writer->command(touch).ok());
        REQUIRE(world->submit(touch).ok());
    }
    for (int step = 0; step < seconds * 60; ++step) {
        world->step();
        REQUIRE(writer->observe(*world).ok());
    }
    REQUIRE(writer->finish(*world).ok());
    return *readTake(file);
}

/// A take of a group that nobody is in before a source sends seven people.
Take takeOfLateComers() {
    WorldDef def{.box = {{0, 0}, {40, 20}}, .parameters = *parameterPreset("people")};
    def.groups = {{.count = 0, .position = {20, 10}}};
    def.areas = {{.kind = AreaKind::Source, .polygon = {{1, 8}, {4, 8}, {4, 12}, {1, 12}}}};
    def.areas[0].timetable = {{0.5, 7}};
    const std::string file = (exportFolder() / "late.take").string();
    auto world = World::create(def);
    REQUIRE_MESSAGE(world.ok(), world.status().message());
    auto writer = TakeWriter::create(file, def);
    REQUIRE_MESSAGE(writer.ok(), writer.status().message());
    for (int step = 0; step < 600; ++step) {
        world->step();
        REQUIRE(writer->observe(*world).ok());
    }
    REQUIRE(world->characters().size() == 7);
    REQUIRE(writer->finish(*world).ok());
    return *readTake(file);
}

double bytesAt(const std::filesystem::path& path) {
    if (!std::filesystem::is_directory(path)) return static_cast<double>(std::filesystem::file_size(path));
    double sum = 0.0;
    for (const auto& entry : std::filesystem::directory_iterator(path))
        sum += static_cast<double>(entry.file_size());
    return sum;
}

void compare(const Take& take, const ExportDef& def) {
    const std::string part = (exportFolder() / "part").string(), whole = (exportFolder() / "whole").string();
    for (const ExportFormat& format : exportFormats()) {
        const std::string name = format.name;
        CAPTURE(name);
        const auto write = [&](const ExportDef& of, const std::string& path) {
            return exportTake(take, ownClips(), format.name, path, of);
        };
        const auto told = estimateExport(take, format.name, def, part, write);
        if (!told.ok() && told.status().code() == StatusCode::Unsupported) continue;  // Without SQLite.
        REQUIRE_MESSAGE(told.ok(), told.status().message());
        CHECK_FALSE(std::filesystem::exists(part));
        REQUIRE(write(def, whole).ok());
        const double real = bytesAt(whole);
        std::filesystem::remove_all(whole);
        MESSAGE("measured: " << name << ": told " << told->bytes << ", has " << real << " bytes");
        CHECK(std::fabs(told->bytes / real - 1.0) < 0.2);
    }
}

}  // namespace

TEST_CASE("the size of an export is told within a fifth, for every format") {
    compare(recorded("block", 12), {});
    ExportDef part{2.0, 12.0, 24.0, 1};
    part.firstPerson = 11, part.lastPerson = 70;
    compare(recorded("course", 12), part);
}

TEST_CASE("people of chosen groups are counted where nobody is there at the start") {
    const Take take = takeOfLateComers();
    ExportDef def;
    def.groups = {World::create(take.def)->group(0).id.value};
    const auto write = [&](const ExportDef& of, const std::string& path) {
        return exportTake(take, ownClips(), "csv", path, of);
    };
    const auto told = estimateExport(take, "csv", def, (exportFolder() / "late").string(), write);
    REQUIRE_MESSAGE(told.ok(), told.status().message());
    CHECK(told->people == 7);
    CHECK(told->bytes > 0.0);
}

TEST_CASE("of an impossible export is told why") {
    const Take take = shortTake();
    const auto none = [](const ExportDef&, const std::string&) { return Status(); };
    CHECK(estimateExport(take, "glb", {3.0, 4.0}, "x", none).status().message().find("from: found 3") == 0);
}
