// What the readers of what is said about a take have in common.
#pragma once

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

}  // namespace muster
