#include "scenario_folder.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

struct OfferedFolder : testing::TemporaryFolder {
    OfferedFolder() : TemporaryFolder("scenario_folder") {}

    std::string put(const std::string& path, const std::string& name, int count = 4) const {
        const std::string text = R"({"format":"muster-scenario","version":1,"name":")" + name +
                                 R"(","box":[[-8,-8],[8,8]],"groups":[{"count":)" + std::to_string(count) +
                                 "},{\"count\":2,\"position\":[4,4]}]}";
        return TemporaryFolder::put(path, text);
    }
    std::string names() const {
        std::string all;
        const ScenarioFolder scenarios = ScenarioFolder::scan(base.string());
        for (const ScenarioEntry& entry : scenarios.entries()) all += (all.empty() ? "" : " ") + entry.name;
        return all;
    }
};

}  // namespace

TEST_CASE("scenarios are sorted by name, and those of folders in it come last") {
    const OfferedFolder folder;
    for (const char* path : {"b.json", "a.json", "z/one.json", "m/two.json", "m/deeper/three.json"})
        folder.put(path, path);
    CHECK(folder.names() == "a b m/two z/one");
}

TEST_CASE("gestures, schemas, hidden folders and other files are no scenarios") {
    const OfferedFolder folder;
    for (const char* path : {"a.json", "gestures/a.json", "schema/a.json", ".old/a.json", "notes.txt"})
        folder.put(path, path);
    fs::create_directories(folder.base / "folder.json");
    CHECK(folder.names() == "a");
}

TEST_CASE("a scenario that cannot be read is left out, and the others are offered") {
    const OfferedFolder folder;
    folder.put("a.json", "A");
    REQUIRE(writeTextFile((folder.base / "bad.json").string(), "{").ok());
    CHECK(folder.names() == "a");
}

TEST_CASE("an entry tells the title and how many people there are") {
    const OfferedFolder folder;
    folder.put("square.json", "The square", 30);
    const ScenarioFolder scenarios = ScenarioFolder::scan(folder.base.string());
    REQUIRE(scenarios.entries().size() == 1);
    CHECK(scenarios.entries()[0].title == "The square");
    CHECK(scenarios.entries()[0].characters == 32);
}

TEST_CASE("the square with the fountain comes first, then the open place, then any") {
    const OfferedFolder folder;
    CHECK(ScenarioFolder::scan(folder.base.string()).first().empty());
    folder.put("alley.json", "Alley");
    CHECK(ScenarioFolder::scan(folder.base.string()).first() == "alley");
    folder.put("open.json", "Open");
    CHECK(ScenarioFolder::scan(folder.base.string()).first() == "open");
    folder.put("fountain.json", "Fountain");
    CHECK(ScenarioFolder::scan(folder.base.string()).first() == "fountain");
}

TEST_CASE("a file from elsewhere is added once, and one with the name of another replaces it") {
    const OfferedFolder folder;
    folder.put("offered/a.json", "A");
    const std::string own = folder.put("own/harbour.json", "Harbour");
    const std::string same = folder.put("own/a.json", "Another A", 7);
    ScenarioFolder scenarios = ScenarioFolder::scan((folder.base / "offered").string());
    const auto name = scenarios.add(own);
    REQUIRE(name.ok());
    CHECK(*name == "harbour");
    CHECK(*scenarios.add((folder.base / "own" / ".." / "own" / "harbour.json").string()) == "harbour");
    CHECK(scenarios.entries().size() == 2);
    CHECK(*scenarios.add(same) == "a");
    CHECK(scenarios.entries().size() == 2);
    CHECK(scenarios.entries()[0].title == "Another A");
    const auto loaded = scenarios.load("a");
    REQUIRE(loaded.ok());
    CHECK(loaded->groups[0].count == 7);
}

TEST_CASE("what is not there is named") {
    const OfferedFolder folder;
    folder.put("a.json", "A");
    ScenarioFolder scenarios = ScenarioFolder::scan(folder.base.string());
    CHECK(scenarios.has("a"));
    CHECK_FALSE(scenarios.has("A"));
    CHECK(scenarios.load("b").status().code() == StatusCode::NotFound);
    CHECK(scenarios.load("b").status().message() == "no scenario is called 'b'");
    CHECK(scenarios.gestures("b", {}).status().message() == "no scenario is called 'b'");
    CHECK_FALSE(scenarios.add((folder.base / "none.json").string()).ok());
    // A folder that is not there offers nothing.
    CHECK(ScenarioFolder::scan((folder.base / "nowhere").string()).entries().empty());
}

TEST_CASE(
    "a take finds the clips of its scenario by the title, and has Muster's own where it names no files") {
    const OfferedFolder folder;
    folder.put("a.json", "A");
    const ScenarioFolder scenarios = ScenarioFolder::scan(folder.base.string());
    WorldDef def{.name = "A"};
    CHECK(scenarios.clips("a", def).ok());
    CHECK(scenarios.clips("of a take", def).ok());
    def.name = "Unknown";
    CHECK(scenarios.clips("of a take", def).ok());
}
