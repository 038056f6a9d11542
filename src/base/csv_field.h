// Fields of CSV files.
#pragma once

#include <string>
#include <string_view>

namespace muster {

/// A text as a field of a CSV file: in quotes where it holds commas, quotes or line breaks.
inline std::string csvField(std::string_view text) {
    if (text.find_first_of(",\"\r\n") == std::string_view::npos) return std::string(text);
    std::string quoted = "\"";
    for (const char c : text) quoted += c == '"' ? std::string("\"\"") : std::string(1, c);
    return quoted + '"';
}

}  // namespace muster
