// Numbers in messages.
#pragma once

#include <cstdio>
#include <string>

namespace muster {

/// A number as people write it.
inline std::string numberText(double value) {
    char buffer[32];
    std::snprintf(buffer, sizeof(buffer), "%.6g", value);
    return buffer;
}

}  // namespace muster
