#include "base/output_file.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

/// An empty folder that goes away with the test case.
struct Folder : testing::TemporaryFolder {
    Folder() : TemporaryFolder("output_file") {}
    /// Number of files and folders in it.
    std::ptrdiff_t entries() const {
        return std::distance(fs::directory_iterator(base), fs::directory_iterator());
    }
};

std::string contents(const std::string& path) {
    std::ifstream stream(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(stream), {}};
}

}  // namespace

TEST_CASE("a file is in its place only after commit(), and whole then") {
    const Folder folder;
    const std::string path = folder / "a.bin", bytes("one\0two\r\n\xFF", 11);
    OutputFile file;
    REQUIRE(file.open(path).ok());
    CHECK(file.partPath() == path + ".part");
    CHECK(fs::exists(file.partPath()));
    REQUIRE(file.write(bytes).ok());
    REQUIRE(file.write("").ok());
    REQUIRE(file.write("end").ok());
    CHECK(file.size() == 14);
    CHECK(!fs::exists(path));
    REQUIRE(file.commit().ok());
    CHECK(contents(path) == bytes + "end");
    CHECK(folder.entries() == 1);
}

TEST_CASE("what is not committed leaves no trace, and the file that was there stays") {
    const Folder folder;
    const std::string path = folder / "a.txt";
    folder.put("a.txt", "before");
    {
        OutputFile file;
        REQUIRE(file.open(path).ok());
        REQUIRE(file.write("half of it").ok());
        CHECK(contents(path) == "before");
    }
    CHECK(contents(path) == "before");
    CHECK(folder.entries() == 1);
    OutputFile file;
    REQUIRE(file.open(path).ok());
    REQUIRE(file.commit().ok());
    CHECK(fs::file_size(path) == 0);
    CHECK(folder.entries() == 1);
}

TEST_CASE("bytes are rewritten anywhere, and writing goes on at the end") {
    const Folder folder;
    const std::string path = folder / "a.txt";
    std::string expected = "0123456789";
    OutputFile file;
    REQUIRE(file.open(path).ok());
    REQUIRE(file.write(expected).ok());
    for (const std::size_t offset : {0u, 3u, 8u}) {
        REQUIRE(file.rewrite(offset, "xy").ok());
        expected.replace(offset, 2, "xy");
        CHECK(file.size() == expected.size());
        REQUIRE(file.write("+").ok());
        expected += "+";
    }
    REQUIRE(file.commit().ok());
    CHECK(contents(path) == expected);
}

TEST_CASE("a folder that does not exist, and a path that is a folder, are refused with the full path") {
    const Folder folder;
    OutputFile file;
    const std::string nowhere = folder / "none/deeper/a.txt";
    const Status missing = file.open(nowhere);
    CHECK(missing.code() == StatusCode::IoError);
    CHECK(missing.message().rfind(nowhere + ": ", 0) == 0);
    const std::string inside = folder / "sub";
    fs::create_directory(inside);
    const Status taken = file.open(inside);
    CHECK(taken.code() == StatusCode::IoError);
    CHECK(taken.message().rfind(inside + ": ", 0) == 0);
    CHECK(folder.entries() == 1);
    // It can still be used for a path that is good.
    REQUIRE(file.open(folder / "a.txt").ok());
    REQUIRE(file.write("good").ok());
    REQUIRE(file.commit().ok());
    CHECK(contents(folder / "a.txt") == "good");
}

TEST_CASE("a place taken by a folder meanwhile fails at commit() and leaves no part") {
    const Folder folder;
    const std::string path = folder / "a";
    {
        OutputFile file;
        REQUIRE(file.open(path).ok());
        REQUIRE(file.write("text").ok());
        fs::create_directory(path);
        folder.put("a/inner", "inner");
        const Status status = file.commit();
        CHECK(status.code() == StatusCode::IoError);
        CHECK(status.message().rfind(path + ": ", 0) == 0);
    }
    CHECK(!fs::exists(path + ".part"));
    CHECK(contents(folder / "a/inner") == "inner");
}

TEST_CASE("opened again or moved onto, the first file is given up") {
    const Folder folder;
    OutputFile file;
    REQUIRE(file.open(folder / "first").ok());
    REQUIRE(file.write("first").ok());
    REQUIRE(file.open(folder / "second").ok());
    CHECK(file.size() == 0);
    CHECK(folder.entries() == 1);
    REQUIRE(file.write("second").ok());

    OutputFile other;
    REQUIRE(other.open(folder / "third").ok());
    other = std::move(file);
    CHECK(folder.entries() == 1);
    CHECK(other.size() == 6);
    OutputFile last(std::move(other));
    REQUIRE(last.write("!").ok());
    REQUIRE(last.commit().ok());
    CHECK(contents(folder / "second") == "second!");
    CHECK(folder.entries() == 1);
}
