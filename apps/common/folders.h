// The folders that are installed with the program.
#pragma once

#include <string>
#include <vector>

namespace muster {

/// The first of these folders that exists, relative to the current folder and to the program's folder;
/// otherwise the first.
std::string findFolder(const std::vector<std::string>& names);

/// The folder of the scenarios that are installed with the program.
inline std::string scenariosFolder() {
    return findFolder({"scenarios", "../share/muster/scenarios"});
}

/// The folder of the built page.
inline std::string pageFolder() {
    return findFolder({"web/dist", "../share/muster/web"});
}

/// The folder of the engine for browsers, where it is built.
inline std::string engineFolder() {
    return findFolder({"build/wasm/apps/engine", "../share/muster/engine"});
}

}  // namespace muster
