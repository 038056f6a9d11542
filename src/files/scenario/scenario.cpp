#include "muster/scenario.h"

#include "base/text_file.h"
#include "files/scenario/describe_world.h"

namespace muster {
namespace {

constexpr const char* kScenarioFormat = "muster-scenario";

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
    if (failure.empty()) {
        describeHead(reader);
        describe(reader, def, baseFolder);
    }
    reader.finish();
    if (!failure.empty()) return Status(StatusCode::ParseError, sourceName + ": " + failure);
    Status valid = clipNamesDiffer(def);
    if (valid.ok()) valid = validate(def);
    if (!valid.ok()) return Status(valid.code(), sourceName + ": $." + valid.message());
    return def;
}

std::string writeScenario(const WorldDef& def) {
    WorldDef copy = def;
    Json json;
    FieldWriter writer(json);
    describeHead(writer);
    describe(writer, copy, {});
    return printJson(json);
}

Status saveScenario(const WorldDef& def, const std::string& path) {
    return writeTextFile(path, writeScenario(def));
}

std::string scenarioSchema() {
    Json body;
    FieldSchema schema(body);
    WorldDef def;
    describeHead(schema);
    describe(schema, def, {});
    return titledSchema("Muster scenario", body);
}

}  // namespace muster
