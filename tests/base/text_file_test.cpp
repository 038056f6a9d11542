#include "base/text_file.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>

#include "base/random.h"
#include "temporary_folder.h"

using namespace muster;

namespace {

/// A path for one test case, free before and after it.
struct Path : testing::TemporaryFolder {
    Path() : TemporaryFolder("text_file") {}
    const std::string text = *this / "a.txt";
};

}  // namespace

TEST_CASE("files come back byte for byte, whatever their size; a shorter one replaces a longer one") {
    const Path path;
    Random random(5);
    for (const std::size_t size : {200000u, 65537u, 65536u, 65535u, 100u, 1u, 0u}) {
        std::string bytes(size, '\0');
        for (char& c : bytes) c = static_cast<char>(random.next());
        REQUIRE(writeTextFile(path.text, bytes).ok());
        CHECK(std::filesystem::file_size(path.text) == size);
        const auto read = readTextFile(path.text);
        REQUIRE(read.ok());
        CHECK(*read == bytes);
    }
}

TEST_CASE("a file may be as large as the limit and not a byte larger") {
    const Path path;
    for (const std::size_t size : {1u, 10u, 65536u, 70000u}) {
        REQUIRE(writeTextFile(path.text, std::string(size, 'x')).ok());
        CHECK(readTextFile(path.text, size).ok());
        CHECK(readTextFile(path.text, size + 1).ok());
        const Status status = readTextFile(path.text, size - 1).status();
        CHECK(status.code() == StatusCode::LimitExceeded);
        CHECK(status.message().rfind(path.text + ": ", 0) == 0);
        CHECK(status.message().find(std::to_string(size - 1)) != std::string::npos);
    }
}

TEST_CASE("what is missing, a folder or in no folder fails with its path") {
    const std::string folder = std::filesystem::temp_directory_path().string();
    for (const std::string& bad : {std::string("/nowhere/a.txt"), folder}) {
        const auto read = readTextFile(bad);
        CHECK(read.status().code() == StatusCode::IoError);
        CHECK(read.status().message().rfind(bad + ": ", 0) == 0);
        const Status written = writeTextFile(bad, "text");
        CHECK(written.code() == StatusCode::IoError);
        CHECK(written.message().rfind(bad + ": ", 0) == 0);
    }
}
