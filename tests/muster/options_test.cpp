#include "options.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

/// A folder with a file, other names of it, and a folder of its own.
struct Folder : testing::TemporaryFolder {
    Folder() : TemporaryFolder("options") {
        fs::create_directories(base / "sub");
        for (const char* name : {"real.txt", "other.txt"}) put(name, "text");
        fs::create_symlink(base / "real.txt", base / "link.txt");
        fs::create_hard_link(base / "real.txt", base / "hard.txt");
    }
    std::string file(const std::string& name) const { return base.string() + "/" + name; }
};

}  // namespace

TEST_CASE(
    "names of the same file are distinguished from those of different files, whether it exists or not") {
    const Folder folder;
    // The files in each row are one; those of different rows are not.
    const std::vector<std::vector<std::string>> files{
        {folder.file("real.txt"), folder.file("./real.txt"), folder.file("sub/../real.txt"),
         folder.file("link.txt"), folder.file("hard.txt")},
        {folder.file("other.txt")},
        {folder.file("new.txt"), folder.file("sub/../new.txt"), folder.file(".//new.txt")},
        {folder.file("sub/new.txt")},
        {folder.file("none/new.txt"), folder.file("none/./new.txt")}};
    for (std::size_t i = 0; i < files.size(); ++i) {
        for (std::size_t j = 0; j < files.size(); ++j) {
            for (const std::string& a : files[i]) {
                for (const std::string& b : files[j]) {
                    CAPTURE(a);
                    CAPTURE(b);
                    CHECK(differentFiles({a}, {b}).ok() == (i != j));
                    CHECK(differentFiles({}, {a, b}).ok() == (i != j));
                    CHECK(differentFiles({a, b}, {}).ok());  // Reading one twice harms nobody.
                }
            }
        }
    }
}

TEST_CASE("empty names are none, and the sentence begins with the file to be written") {
    CHECK(differentFiles({}, {}).ok());
    CHECK(differentFiles({"", ""}, {"", ""}).ok());
    CHECK(differentFiles({"", "a"}, {"b", "", "c"}).ok());
    const Status read = differentFiles({"", "a", "b"}, {"c", "", "b"});
    CHECK(read.code() == StatusCode::InvalidArgument);
    CHECK(read.message().rfind("b: ", 0) == 0);
    const Status twice = differentFiles({"a"}, {"c", "", "c"});
    CHECK(twice.code() == StatusCode::InvalidArgument);
    CHECK(twice.message().rfind("c: ", 0) == 0);
}

TEST_CASE("two spellings of a file that does not exist yet name one file") {
    CHECK_FALSE(differentFiles({}, {"not_there.csv", "./not_there.csv"}).ok());
    CHECK_FALSE(differentFiles({"folder/../not_there.csv"}, {"not_there.csv"}).ok());
    CHECK(differentFiles({}, {"not_there.csv", "./nor_there.csv"}).ok());
}
