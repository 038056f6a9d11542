// Where the tests find the project.
#pragma once

#include <string>

namespace muster {

/// The folder of the project's sources.
std::string sourceFolder();
/// The path of the program `muster`, in tests that run it.
std::string programPath();

}  // namespace muster
