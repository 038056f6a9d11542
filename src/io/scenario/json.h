// JSON text in and out, with errors that name line and column.
#pragma once

#include <nlohmann/json.hpp>
#include <string>
#include <string_view>

#include "muster/status.h"

namespace muster {

using Json = nlohmann::ordered_json;  ///< Keys keep their order.

/// Parses strictly: no comments, no repeated keys, at most 64 levels. Errors: `SOURCE:LINE:COLUMN: found X,
/// expected Y`.
Result<Json> parseJson(std::string_view text, const std::string& sourceName);

/// Readable text: short arrays and objects on one line, two spaces per level, at most about 110 columns.
/// Numbers are the shortest that read back to the same bits.
std::string printJson(const Json& value);

/// What a value is, for messages: `the text "abc"`, `the number 3`, `an array of 4`, `an object`...
std::string describeJson(const Json& value);

}  // namespace muster
