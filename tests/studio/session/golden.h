// Files that the page's tests read, so that both sides agree on each field.
#pragma once

#include <cstdint>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include "test_folders.h"

namespace muster {

/// The bytes of a file in tests/golden. With MUSTER_UPDATE_GOLDEN=1 `now` is written to it first.
inline std::vector<std::uint8_t> goldenBytes(const std::string& name, const std::vector<std::uint8_t>& now) {
    const std::string path = sourceFolder() + "/tests/golden/" + name;
    if (std::getenv("MUSTER_UPDATE_GOLDEN") != nullptr)
        std::ofstream(path, std::ios::binary)
            .write(reinterpret_cast<const char*>(now.data()), static_cast<std::streamsize>(now.size()));
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace muster
