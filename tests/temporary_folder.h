// A folder for the files of a test.
#pragma once

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

namespace muster::testing {

/// Removed, with all that is in it, when the test is over.
struct TemporaryFolder {
    const std::filesystem::path base;

    explicit TemporaryFolder(const std::string& name)
        : base(std::filesystem::temp_directory_path() /
               ("muster_" + name + "_" + std::to_string(::getpid()))) {
        std::filesystem::remove_all(base);
        std::filesystem::create_directories(base);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
    ~TemporaryFolder() {
        std::error_code ignored;
        std::filesystem::remove_all(base, ignored);
    }

    /// The path of a file in it.
    std::string operator/(const std::string& name) const { return (base / name).string(); }
    /// Writes a file, and the folder that it lies in; returns its path.
    std::string put(const std::string& name, const std::string& text) const {
        std::filesystem::create_directories((base / name).parent_path());
        std::ofstream file(base / name, std::ios::binary);
        file << text;
        REQUIRE(file.good());
        return *this / name;
    }
    /// What a file holds; empty where there is none.
    std::string read(const std::string& name) const {
        std::ifstream file(base / name, std::ios::binary);
        return {std::istreambuf_iterator<char>(file), {}};
    }
};

}  // namespace muster::testing
