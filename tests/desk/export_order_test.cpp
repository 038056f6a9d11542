#include "export_order.h"

#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <string>
#include <vector>

#include "base/text_file.h"
#include "desk/made_take.h"
#include "temporary_folder.h"

using namespace muster;
namespace fs = std::filesystem;

namespace {

/// A shelf with a take of two seconds.
struct OrderedFrom : testing::TemporaryFolder {
    TakeShelf shelf{(base / "takes").string()};
    std::string name;

    OrderedFrom() : TemporaryFolder("export_order") {
        const auto kept = shelf.put(testing::bytesOf(testing::madeTake(base, 120)));
        REQUIRE_MESSAGE(kept.ok(), kept.status().message());
        name = *kept;
    }

    std::string refusal(const std::string& text) {
        const auto order = readExportOrder(text, shelf);
        return order.ok() ? "" : order.status().message();
    }
};

}  // namespace

TEST_CASE("an order is read as it was written, and what it leaves out has its usual value") {
    OrderedFrom from;
    const auto plain = readExportOrder(R"({"take":")" + from.name + R"(","format":"pedpy"})", from.shelf);
    REQUIRE_MESSAGE(plain.ok(), plain.status().message());
    CHECK(plain->format == "pedpy");
    CHECK(plain->from == 0.0);
    CHECK(plain->to == -1.0);
    CHECK(plain->fps == 30.0);
    CHECK(plain->speeds);
    CHECK(fs::exists(plain->take));
    const auto full = readExportOrder(
        R"({"take":")" + from.name + R"(","format":"glb","from":0.5,"to":1.5,"fps":24,"speeds":false})",
        from.shelf);
    REQUIRE(full.ok());
    CHECK(full->from == 0.5);
    CHECK(full->to == 1.5);
    CHECK(full->fps == 24.0);
    CHECK_FALSE(full->speeds);
}

TEST_CASE("a bad order is refused by a sentence that names the culprit") {
    OrderedFrom from;
    const std::string take = R"({"take":")" + from.name + R"(",)";
    CHECK(from.refusal("[]").find("export: found") == 0);
    CHECK(from.refusal("{}") == "export: expected a text for take");
    CHECK(from.refusal(take + R"("format":7})") == "export: expected a text for format");
    CHECK(from.refusal(take + R"("format":"glb","fps":"fast"})").find("for fps, expected a number") !=
          std::string::npos);
    CHECK(from.refusal(take + R"("format":"glb","to":null})").find("for to, expected a number") !=
          std::string::npos);
    CHECK(from.refusal("{").find("export") == 0);
    CHECK(from.refusal(R"({"take":"none.take","format":"glb"})") == "no take is called 'none.take'");
    // A name is no path.
    CHECK(from.refusal(R"({"take":"../made.take","format":"glb"})") == "no take is called '../made.take'");
}

TEST_CASE("the file's name is the title in plain letters with the ending of the format") {
    ExportOrder order{.format = "glb"};
    for (const auto& [title, name] : std::vector<std::pair<std::string, std::string>>{
             {"First take", "First-take.glb"},
             {"  a / b: c ", "a-b-c.glb"},
             {"\xc3\xa9t\xc3\xa9", "t.glb"},
             {"///", "take.glb"},
             {"", "take.glb"},
             {std::string(100, 'x'), std::string(60, 'x') + ".glb"}}) {
        order.title = title;
        CHECK(*exportFileName(order) == name);
    }
    order.title = "a";
    for (const auto& [format, name] : std::vector<std::pair<std::string, std::string>>{
             {"bvh", "a-bvh.zip"}, {"usda", "a.usda"}, {"pedpy", "a.txt"}, {"jupedsim", "a.sqlite"}}) {
        order.format = format;
        CHECK(*exportFileName(order) == name);
    }
    order.format = "avi";
    CHECK(exportFileName(order).status().message().find("format: found \"avi\", expected one of glb") == 0);
}

TEST_CASE("an export has the part that was asked for, and tells how far it is") {
    OrderedFrom from;
    auto order = readExportOrder(
        R"({"take":")" + from.name + R"(","format":"pedpy","from":0.5,"to":1.5,"fps":10})", from.shelf);
    REQUIRE(order.ok());
    const std::string path = (from.base / "out.txt").string();
    std::vector<double> shares;
    REQUIRE(writeExport(*order, {}, path, [&](double share) {
                shares.push_back(share);
                return true;
            }).ok());
    const auto text = readTextFile(path);
    REQUIRE(text.ok());
    std::size_t rows = 0;
    for (std::size_t at = 0; at < text->size(); at = text->find('\n', at) + 1)
        rows += (*text)[at] != '#' ? 1 : 0;
    CHECK(rows == 11 * 9);
    REQUIRE_FALSE(shares.empty());
    CHECK(shares.back() == 1.0);
    for (std::size_t i = 1; i < shares.size(); ++i) CHECK(shares[i] >= shares[i - 1]);
}

TEST_CASE("a folder of files becomes one ZIP, and nothing else is left") {
    OrderedFrom from;
    auto order = readExportOrder(R"({"take":")" + from.name + R"(","format":"bvh","fps":10,"to":0.5})",
                                 from.shelf);
    REQUIRE(order.ok());
    const std::string path = (from.base / "out.zip").string();
    REQUIRE(writeExport(*order, {}, path, [](double) { return true; }).ok());
    const auto bytes = readTextFile(path, std::size_t{64} << 20);
    REQUIRE(bytes.ok());
    CHECK(bytes->substr(0, 4) == std::string("PK\x03\x04", 4));
    CHECK(bytes->find("HIERARCHY") != std::string::npos);
    CHECK_FALSE(fs::exists(path + "-files"));
}

TEST_CASE("an export that is ended leaves no file") {
    OrderedFrom from;
    for (const char* format : {"glb", "bvh", "jupedsim"}) {
        auto order = readExportOrder(R"({"take":")" + from.name + R"(","format":")" + format + R"("})",
                                     from.shelf);
        REQUIRE(order.ok());
        const std::string path = (from.base / "ended").string();
        CHECK_FALSE(writeExport(*order, {}, path, [](double) { return false; }).ok());
        CHECK_FALSE(fs::exists(path));
        CHECK_FALSE(fs::exists(path + "-files"));
        CHECK_FALSE(fs::exists(path + ".part"));
    }
}
