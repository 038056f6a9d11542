#include "muster/scenario.h"

#include "base/text_file.h"
#include "files/scenario/clip_field.h"
#include "files/scenario/describe.h"
#include "files/scenario/gestures_field.h"
#include "muster/parameter_table.h"

namespace muster {
namespace {

constexpr const char* kScenarioFormat = "muster-scenario";
constexpr double kLargestSeed = 9007199254740991.0;  // 2^53 - 1: exact in every JSON reader.

std::vector<std::string> clipNames(const std::vector<ClipFacts>& clips) {
    std::vector<std::string> names;
    for (const ClipFacts& clip : clips) names.push_back(clip.name);
    return names;
}

/// `format` and `version`: the kind of the file.
template <class Visitor>
void describeHead(Visitor& v) {
    std::string format = kScenarioFormat;
    std::int32_t version = 1;
    v.choice("format", format, {kScenarioFormat}, "What this file is.", Need::Required);
    v.whole("version", version, {1.0, 1.0}, "Of the format.", Need::Required);
    if constexpr (Visitor::kReading || Visitor::kSchema) {
        std::string schema;
        v.text("$schema", schema, "Where editors find this schema.");
    }
}

/// The corner points [x, y] of the world box.
template <class Visitor>
void describeBox(Visitor& v, Box& box) {
    std::vector<Vec2> corners{box.min, box.max};
    v.points("box", corners, 2, 2,
             "Lower left and upper right corner of the world; left out: the map's, or 32 x 32 m about the "
             "origin.");
    if constexpr (Visitor::kReading) {
        if (!v.failed()) box = {corners[0], corners[1]};
    }
}

template <class Visitor>
void describePreset(Visitor& v, Parameters& parameters) {
    if constexpr (Visitor::kReading || Visitor::kSchema) {
        std::string preset = "units";
        v.choice("preset", preset, {"units", "people", "paper", "muster"},
                 "Where parameters start from; muster is the former name of units.");
        if (const auto found = parameterPreset(preset); found.ok()) parameters = *found;
    }
}

/// All fields of a scenario. `folder` contains its map files.
template <class Visitor>
void describeWorld(Visitor& v, WorldDef& def, const std::string& folder) {
    describeHead(v);
    v.text("name", def.name, "Shown in the studio.", Need::Optional, WorldDef{}.name);
    v.text("description", def.description, "One or two sentences.");
    v.text("credit", def.credit, "Whose data it uses.");
    describeGestures(v, def.gestures);
    if (describeMap(v, def.map, folder) && def.map) def.box = mapBox(*def.map);
    describeBox(v, def.box);
    v.number("cell", def.cell, {0.01, 100.0, "m"}, "Edge of a ground cell.");
    v.whole("seed", def.seed, {0.0, kLargestSeed}, "Of all random numbers.");
    v.list("clips", def.clips, 1000,
           "Facts of motion clips; left out: run, walk, duck, crawl, swim, jump, climb, idle.",
           [&](auto& item, ClipFacts& clip) {
               // The first clip is running: all speeds are relative to it.
               const bool running = def.clips.empty() || &clip == &def.clips.front();
               describeClip(item, clip, folder, running ? 0.0 : runSpeed(def.clips));
           });
    const auto motions = clipNames(def.clips);
    v.list("obstacles", def.obstacles, kMaxObstacles, "What nobody can walk through.",
           [](auto& item, ObstacleDef& obstacle) { describeObstacle(item, obstacle); });
    v.list("patches", def.patches, kMaxObstacles, "Ground that asks for another motion.",
           [&](auto& item, PatchDef& patch) { describePatch(item, patch, motions); });
    v.list("groups", def.groups, kMaxGroups, "Crowds, each with one mesh.",
           [](auto& item, GroupDef& group) { describeGroup(item, group); });
    const std::size_t groups = def.groups.size();
    v.list("checkpoints", def.checkpoints, kMaxObstacles, "Spots that change the formation of a group.",
           [&](auto& item, FormationCheckpointDef& c) { describeCheckpoint(item, c, groups); });
    v.list("items", def.items, kMaxObstacles, "Things to collect.",
           [](auto& item, ItemDef& i) { describeItem(item, i); });
    v.list("areas", def.areas, kMaxAreas, "Where people leave, come and wait.",
           [&](auto& item, AreaDef& area) { describeArea(item, area, groups); });
    if (takesPart<Visitor>(def.ring))
        v.flag("ring", def.ring, "The left and the right side of the box are joined.");
    describePreset(v, def.parameters);
    v.object("parameters", "Every number that may be changed.",
             [&](auto& inner) { describeParameters(inner, def.parameters); });
}

Status clipNamesDiffer(const WorldDef& def) {
    const auto names = clipNames(def.clips);
    for (std::size_t i = 0; i < names.size(); ++i) {
        for (std::size_t j = 0; j < i; ++j) {
            if (names[i] == names[j]) {
                return invalidArgument("clips[" + std::to_string(i) + "].name: found the name \"" + names[i] +
                                       "\" a second time, expected different names");
            }
        }
    }
    return {};
}

}  // namespace

Result<WorldDef> loadScenario(const std::string& path) {
    const auto text = readTextFile(path);
    if (!text.ok()) return text.status();
    return parseScenario(*text, path, folderOf(path));
}

Result<WorldDef> parseScenario(std::string_view text, const std::string& sourceName,
                               const std::string& baseFolder) {
    if (text.size() > kMaxScenarioBytes) {
        return Status(StatusCode::LimitExceeded, sourceName + ": found more than 64 MB");
    }
    const auto json = parseJson(text, sourceName);
    if (!json.ok()) return json.status();
    WorldDef def;
    std::string failure;
    FieldReader reader(*json, "$", failure);
    if (failure.empty()) describeWorld(reader, def, baseFolder);
    reader.finish();
    if (!failure.empty()) return Status(StatusCode::ParseError, sourceName + ": " + failure);
    Status valid = clipNamesDiffer(def);
    if (valid.ok()) valid = validateWorld(def);
    if (!valid.ok()) return Status(valid.code(), sourceName + ": $." + valid.message());
    return def;
}

std::string writeScenario(const WorldDef& def) {
    WorldDef copy = def;
    Json json;
    FieldWriter writer(json);
    describeWorld(writer, copy, {});
    return printJson(json);
}

Status saveScenario(const WorldDef& def, const std::string& path) {
    return writeTextFile(path, writeScenario(def));
}

std::string scenarioSchema() {
    Json body;
    FieldSchema schema(body);
    WorldDef def;
    describeWorld(schema, def, {});
    return titledSchema("Muster scenario", body);
}

}  // namespace muster
