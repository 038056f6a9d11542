// What the readers of what is said about a take have in common.
#pragma once

#include <initializer_list>
#include <string>

#include "json/json.h"
#include "muster/status.h"

namespace muster {

/// A number as in JSON.
inline std::string numberText(double value) {
    return compactJson(Json(value));
}

/// A value of another kind than expected.
inline Status wrongKind(const std::string& key, const Json& found, const char* expected) {
    return {StatusCode::ParseError, key + ": found " + describeJson(found) + ", expected " + expected};
}

/// A number of an object and where it goes.
struct NumberField {
    const char* key;
    double* value;
};

/// Reads the numbers that an object has; the others stay.
inline Status readNumbers(const Json& object, std::initializer_list<NumberField> fields) {
    for (const auto& [key, value] : fields) {
        const Json* found = object.find(key);
        if (found == nullptr) continue;
        if (!found->isNumber()) return wrongKind(key, *found, "a number");
        *value = found->number();
    }
    return {};
}

}  // namespace muster
