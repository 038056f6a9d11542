// The `gestures` of a scenario: the name of its gestures file.
#pragma once

#include <string>
#include <string_view>

#include "files/scenario/fields.h"

namespace muster {

/// The folder part of a path, with its slash; "./" for none.
std::string folderOf(const std::string& path);

/// True for a relative path that never leaves its folder upwards.
bool staysInside(std::string_view path);

inline constexpr const char* kInsideExpected = "a file in the scenario's folder or below it";

template <class Visitor>
void describeGestures(Visitor& v, std::string& gestures) {
    v.text("gestures", gestures,
           "File of the touches that belong to it, in the scenario's folder or below it.");
    if constexpr (Visitor::kReading) {
        if (!v.failed() && !staysInside(gestures))
            v.fail("gestures", describeJson(gestures), kInsideExpected);
    }
}

}  // namespace muster
