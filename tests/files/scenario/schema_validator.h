// A small JSON Schema validator: it supports the parts of draft 2020-12 that Muster's schema uses and rejects
// any other.
#pragma once

#include <nlohmann/json.hpp>
#include <regex>
#include <string>

namespace muster::testing {

using Json = nlohmann::ordered_json;

/// The first error of `value` against `schema`, or an empty text.
inline std::string breaks(const Json& schema, const Json& value, const std::string& path = "$");

inline bool hasType(const std::string& type, const Json& value) {
    if (type == "object") return value.is_object();
    if (type == "array") return value.is_array();
    if (type == "string") return value.is_string();
    if (type == "boolean") return value.is_boolean();
    if (type == "number") return value.is_number();
    if (type == "integer")
        return value.is_number_integer() ||
               (value.is_number() && value.get<double>() == static_cast<double>(value.get<std::int64_t>()));
    return false;
}

inline std::string breaksObject(const Json& schema, const Json& value, const std::string& path) {
    if (schema.contains("required")) {
        for (const Json& key : schema["required"]) {
            if (!value.contains(key.get<std::string>())) return path + " lacks " + key.dump();
        }
    }
    for (const auto& [key, item] : value.items()) {
        if (schema.contains("properties") && schema["properties"].contains(key)) {
            if (auto found = breaks(schema["properties"][key], item, path + "." + key); !found.empty())
                return found;
        } else if (schema.value("additionalProperties", true) == false) {
            return path + " has the unknown key " + key;
        }
    }
    return {};
}

inline std::string breaks(const Json& schema, const Json& value, const std::string& path) {
    for (const auto& [key, rule] : schema.items()) {
        if (key == "type") {
            if (!hasType(rule.get<std::string>(), value)) return path + " is not of type " + rule.dump();
        } else if (key == "minimum") {
            if (value.is_number() && value.get<double>() < rule.get<double>())
                return path + " is below " + rule.dump();
        } else if (key == "maximum") {
            if (value.is_number() && value.get<double>() > rule.get<double>())
                return path + " is above " + rule.dump();
        } else if (key == "minItems") {
            if (value.is_array() && value.size() < rule.get<std::size_t>())
                return path + " has too few items";
        } else if (key == "maxItems") {
            if (value.is_array() && value.size() > rule.get<std::size_t>())
                return path + " has too many items";
        } else if (key == "pattern") {
            if (value.is_string() &&
                !std::regex_search(value.get<std::string>(), std::regex(rule.get<std::string>())))
                return path + " does not match " + rule.get<std::string>();
        } else if (key == "enum") {
            if (std::find(rule.begin(), rule.end(), value) == rule.end())
                return path + " is none of " + rule.dump();
        } else if (key == "items") {
            for (std::size_t i = 0; value.is_array() && i < value.size(); ++i) {
                if (auto found = breaks(rule, value[i], path + "[" + std::to_string(i) + "]"); !found.empty())
                    return found;
            }
        } else if (key == "anyOf") {
            std::string all;
            for (const Json& option : rule) {
                const auto found = breaks(option, value, path);
                if (found.empty()) {
                    all.clear();
                    break;
                }
                all += (all.empty() ? "" : "; ") + found;
            }
            if (!all.empty()) return all;
        } else if (key != "properties" && key != "required" && key != "additionalProperties" &&
                   key != "description" && key != "title" && key != "$schema" && key != "default") {
            return "the schema uses " + key + ", which this validator does not know";
        }
    }
    return value.is_object() ? breaksObject(schema, value, path) : std::string();
}

}  // namespace muster::testing
