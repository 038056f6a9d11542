#include <doctest.h>

#include <filesystem>
#include <string>

#include "base/text_file.h"
#include "files/scenario/schema_validator.h"
#include "muster/parameter_table.h"
#include "muster/scenario.h"
#include "test_folders.h"

using namespace muster;

namespace {

using testing::Json;

Json schema() {
    return Json::parse(scenarioSchema());
}

Json example() {
    WorldDef def;
    def.groups.resize(1);
    def.obstacles = {{.radius = 1.0}};
    def.checkpoints.resize(1);
    def.items.resize(1);
    def.patches = {{.polygon = {{0, 0}, {1, 0}, {1, 1}}}};
    return Json::parse(writeScenario(def));
}

}  // namespace

TEST_CASE("the published schema is the loader's own") {
    const auto text = readTextFile(sourceFolder() + "/scenarios/schema/scenario.schema.json");
    REQUIRE(text.ok());
    CHECK_MESSAGE(*text == scenarioSchema(),
                  "renew it: muster check --schema > scenarios/schema/scenario.schema.json");
}

TEST_CASE("the schema has every parameter with its default, range and unit") {
    const Json parameters = schema()["properties"]["parameters"]["properties"];
    CHECK(parameters.size() == parameterTable().size());
    const Parameters defaults;
    for (const ParameterInfo& info : parameterTable()) {
        CAPTURE(info.name);
        const auto entry = parameters.find(std::string(info.name));
        REQUIRE(entry != parameters.end());
        CHECK((*entry)["default"].get<double>() == info.get(defaults));
        CHECK((*entry)["minimum"].get<double>() == info.minimum);
        CHECK((*entry)["maximum"].get<double>() == info.maximum);
        const auto about = (*entry)["description"].get<std::string>();
        CHECK(about.find(info.description) == 0);
        if (info.unit != "1") CHECK(about.find("[" + std::string(info.unit) + "]") != std::string::npos);
    }
}

TEST_CASE("shipped and written scenarios conform to the schema") {
    const Json rules = schema();
    const std::string folder = sourceFolder() + "/scenarios";
    for (const auto& entry : std::filesystem::recursive_directory_iterator(folder)) {
        const std::string holder = entry.path().parent_path().filename().string();
        if (entry.path().extension() != ".json" || holder == "gestures" || holder == "schema") continue;
        const Json json = Json::parse(*readTextFile(entry.path().string()));
        CHECK(testing::breaks(rules, json) == "");
        const auto def = loadScenario(entry.path().string());
        REQUIRE(def.ok());
        CHECK(testing::breaks(rules, Json::parse(writeScenario(*def))) == "");
    }
}

TEST_CASE("schema and loader refuse the same errors") {
    const Json rules = schema();
    const Json good = example();
    REQUIRE(testing::breaks(rules, good) == "");
    REQUIRE(parseScenario(good.dump(), "good", "").ok());
    struct Mistake {
        const char* pointer;
        Json value;
    };
    const Mistake mistakes[] = {{"/format", "other"},
                                {"/version", 2},
                                {"/cell", 0},
                                {"/cell", "wide"},
                                {"/seed", -1},
                                {"/box", Json::array({0, 0, 1, 1})},
                                {"/unknown", 1},
                                {"/groups/0/count", -1},
                                {"/groups/0/count", 1.5},
                                {"/groups/0/formation/kind", "blob"},
                                {"/groups/0/formation", "blob"},
                                {"/groups/0/position", Json::array({1})},
                                {"/obstacles/0/radius", -1},
                                {"/obstacles/0/height", 0},
                                {"/obstacles/0/shape", "round"},
                                {"/patches/0/polygon", Json::array({Json::array({0, 0})})},
                                {"/items/0/radius", 0},
                                {"/checkpoints/0/once", "yes"},
                                {"/parameters/plan.exponent", 99},
                                {"/parameters/density.enabled", 0.5}};
    for (const Mistake& mistake : mistakes) {
        CAPTURE(mistake.pointer);
        Json bad = good;
        bad[Json::json_pointer(mistake.pointer)] = mistake.value;
        CHECK(testing::breaks(rules, bad) != "");
        CHECK(!parseScenario(bad.dump(), "bad", "").ok());
    }
    // Valid values at the same pointers are accepted.
    const Mistake changes[] = {
        {"/cell", 0.5}, {"/groups/0/count", 9}, {"/groups/0/formation", "wedge"}, {"/preset", "paper"}};
    for (const Mistake& change : changes) {
        CAPTURE(change.pointer);
        Json other = good;
        other[Json::json_pointer(change.pointer)] = change.value;
        CHECK(testing::breaks(rules, other) == "");
        CHECK(parseScenario(other.dump(), "other", "").ok());
    }
}
