#include "files/scenario/fields.h"

namespace muster {
namespace {

Json pointSchema() {
    return {{"type", "array"},
            {"items", {{"type", "number"}, {"minimum", -1e6}, {"maximum", 1e6}}},
            {"minItems", 2},
            {"maxItems", 2}};
}

}  // namespace

FieldSchema::FieldSchema(Json& schema) : schema_(&schema) {
    schema = Json::object();
    schema["type"] = "object";
    schema["additionalProperties"] = false;
    schema["properties"] = Json::object();
}

Json FieldSchema::itemSchema(const NumberRange& range, bool whole) {
    if (whole) {
        return {{"type", "integer"},
                {"minimum", static_cast<std::int64_t>(range.minimum)},
                {"maximum", static_cast<std::int64_t>(range.maximum)}};
    }
    return {{"type", "number"}, {"minimum", range.minimum}, {"maximum", range.maximum}};
}

void FieldSchema::set(std::string_view key, const Json& schema, std::string_view about, Need need) {
    Json entry = {{"description", std::string(about)}};
    for (const auto& [name, value] : schema.members()) entry[name] = value;
    (*schema_)["properties"][key] = std::move(entry);
    if (need == Need::Required) (*schema_)["required"].push(key);
}

void FieldSchema::text(std::string_view key, const std::string& value, const char* about, Need need,
                       std::string_view) {
    Json schema = {{"type", "string"}};
    if (need == Need::Optional) schema["default"] = value;
    set(key, std::move(schema), about, need);
}

void FieldSchema::number(std::string_view key, double value, const NumberRange& range, std::string_view about,
                         Need need) {
    Json schema = {{"type", range.whole ? "integer" : "number"}};
    if (range.whole) {
        schema["minimum"] = static_cast<std::int64_t>(range.minimum);
        schema["maximum"] = static_cast<std::int64_t>(range.maximum);
        if (need == Need::Optional) schema["default"] = static_cast<std::int64_t>(value);
    } else {
        schema["minimum"] = range.minimum;
        schema["maximum"] = range.maximum;
        if (need == Need::Optional) schema["default"] = value;
    }
    std::string text(about);
    if (range.unit != "1") text += " [" + std::string(range.unit) + "]";
    set(key, std::move(schema), text, need);
}

void FieldSchema::optionalNumber(std::string_view key, double, const NumberRange& range, const char* about) {
    number(key, 0.0, range, about);
    eraseDefault(key);
}

void FieldSchema::flag(std::string_view key, bool value, const char* about) {
    set(key, {{"type", "boolean"}, {"default", value}}, about, Need::Optional);
}

void FieldSchema::colour(std::string_view key, const std::optional<std::uint32_t>&, const char* about) {
    set(key, {{"type", "string"}, {"pattern", "^#[0-9a-fA-F]{6}$"}}, about, Need::Optional);
}

void FieldSchema::point(std::string_view key, Vec2 value, const char* about, Need need) {
    Json schema = pointSchema();
    if (need == Need::Optional) schema["default"] = Json::array({value.x, value.y});
    set(key, std::move(schema), about, need);
}

void FieldSchema::points(std::string_view key, const std::vector<Vec2>&, std::size_t least, std::size_t most,
                         const char* about, Need need) {
    set(key, {{"type", "array"}, {"items", pointSchema()}, {"minItems", least}, {"maxItems", most}}, about,
        need);
}

void FieldSchema::choice(std::string_view key, const std::string& value,
                         const std::vector<std::string>& names, const char* about, Need need) {
    Json schema = {{"enum", Json::arrayOf(names)}};
    if (need == Need::Optional && !value.empty()) schema["default"] = value;
    set(key, std::move(schema), about, need);
}

void FieldSchema::nameOrIndex(std::string_view key, std::int32_t, const std::vector<std::string>&,
                              const char* about, Need need) {
    Json number = {{"type", "integer"}, {"minimum", 0}, {"maximum", 999}};
    set(key, {{"anyOf", Json::array({Json{{"type", "string"}}, number})}}, about, need);
}

std::string titledSchema(const char* title, const Json& body) {
    Json json = {
        {"$schema", "https://json-schema.org/draft/2020-12/schema"},
        {"title", title},
        {"description", "Metres, seconds, radians; x right, y forward. See docs/scenario-format.md."}};
    for (const auto& [key, value] : body.members()) json[key] = value;
    return printJson(json);
}

}  // namespace muster
