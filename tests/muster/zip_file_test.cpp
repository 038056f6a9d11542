#include "zip_file.h"

#include <doctest.h>

#include <filesystem>
#include <fstream>

#include "base/hash.h"
#include "base/text_file.h"

using namespace muster;

namespace {

std::uint32_t wordAt(const std::string& text, std::size_t at) {
    std::uint32_t word = 0;
    for (int i = 3; i >= 0; --i)
        word = word << 8 | static_cast<unsigned char>(text[at + static_cast<std::size_t>(i)]);
    return word;
}

}  // namespace

TEST_CASE("An archive holds the files of a folder as they are") {
    const std::string folder = (std::filesystem::temp_directory_path() / "muster-zip-test").string();
    std::filesystem::remove_all(folder);
    std::filesystem::create_directories(folder + "/in/below");
    std::ofstream(folder + "/in/b.txt") << "second";
    std::ofstream(folder + "/in/a.txt") << "the first one";
    std::ofstream(folder + "/in/below/c.txt") << "not this one";
    REQUIRE(zipFolder(folder + "/in", folder + "/out.zip").ok());
    const std::string zip = readTextFile(folder + "/out.zip").value();
    // The end record: two files, and where the list of them begins.
    const std::size_t end = zip.size() - 22;
    CHECK(wordAt(zip, end) == 0x06054b50);
    CHECK(wordAt(zip, end + 8) == 0x00020002);
    const std::size_t list = wordAt(zip, end + 16);
    CHECK(list + wordAt(zip, end + 12) == end);
    CHECK(wordAt(zip, list) == 0x02014b50);
    CHECK(zip.substr(list + 46, 5) == "a.txt");
    CHECK(wordAt(zip, list + 42) == 0);
    const std::string text = "the first one";
    CHECK(wordAt(zip, list + 16) == crc32({reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}));
    CHECK(wordAt(zip, 0) == 0x04034b50);
    CHECK(zip.substr(30, 5) == "a.txt");
    CHECK(zip.substr(35, text.size()) == text);
    CHECK(zip.find("not this one") == std::string::npos);
    CHECK_FALSE(zipFolder(folder + "/none", folder + "/none.zip").ok());
    CHECK_FALSE(std::filesystem::exists(folder + "/none.zip"));
    std::filesystem::remove_all(folder);
}
