// Where the program finds what it comes with.
#pragma once

#include <string>
#include <vector>

namespace muster {

/// The first of these folders that exists, looked for from here and from the program's place; else the first.
std::string findFolder(const std::vector<std::string>& names);

/// The folder of scenarios that comes with the program.
inline std::string scenariosFolder() {
    return findFolder({"scenarios", "../share/muster/scenarios"});
}

}  // namespace muster
