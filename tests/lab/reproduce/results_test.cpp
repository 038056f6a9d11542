// results.json, summary.md, the lines for a terminal, and the report's folder.
#include <unistd.h>

#include <doctest.h>

#include <algorithm>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <set>

#include "base/text_file.h"
#include "lab/reproduce/fake.h"
#include "muster/scenario.h"

using namespace muster;
using muster::testing::fakeReproduction;
using Json = nlohmann::ordered_json;
namespace fs = std::filesystem;

TEST_CASE("results.json has an entry per verdict with the keys that were agreed on") {
    const Reproduction reproduction = fakeReproduction();
    const Json all = Json::parse(resultsJson(reproduction));
    REQUIRE(all.is_array());
    REQUIRE(all.size() == 9);
    const std::vector<std::string> keys = {"experiment", "criterion", "preset", "value", "threshold",
                                           "pass",       "binding",   "seeds",  "low",   "high"};
    for (const Json& entry : all) {
        std::vector<std::string> found;
        for (const auto& [key, value] : entry.items()) found.push_back(key);
        CHECK(found == keys);
    }
    CHECK(all[0]["experiment"] == "X2");
    CHECK(all[0]["value"].get<double>() == reproduction.experiments[0].verdicts[0].value);
    CHECK(all[0]["pass"] == true);
    CHECK(all[0]["seeds"] == 10);
    // No value is null, not 0.
    const Json& none = all[7];
    CHECK(none["criterion"] == "what nobody reached");
    CHECK(none["value"].is_null());
    CHECK(none["low"].is_null());
    CHECK(none["pass"] == false);
    CHECK(none["seeds"] == 0);
    CHECK(none["threshold"] == 10.0);
    CHECK(Json::parse(resultsJson({})).empty());
}

TEST_CASE("the summary is one Markdown table") {
    const std::string text = summaryMarkdown(fakeReproduction());
    std::size_t rows = 0;
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = text.find('\n', from);
        const std::string line = text.substr(from, end - from);
        if (!line.empty() && line[0] == '|') {
            ++rows;
            CHECK(std::count(line.begin(), line.end(), '|') == 8);
        }
        from = end + 1;
    }
    CHECK(rows == 2 + 9);
    CHECK(text.rfind("3 of 6 criteria hold over 10 seeds.", 0) == 0);
    CHECK(text.find("| what nobody reached | muster | not reached | in none of 10 seeds | at most 10 s in "
                    "the median | "
                    "**fail** |") != std::string::npos);
}

TEST_CASE("lines for a terminal tell every verdict and the sum") {
    const std::string text = summaryText(fakeReproduction());
    CHECK(text.find("X2  A line and an area: 1 of 1\n") == 0);
    CHECK(text.find("      FAIL  muster  not reached (in none of 10 seeds)\n") != std::string::npos);
    CHECK(text.find("      fail  paper   34.23 s") != std::string::npos);
    CHECK(text.find("\n3 of 6 criteria hold; 10 seeds, 812 s\n") != std::string::npos);
    for (std::size_t from = 0; from < text.size();) {
        const std::size_t end = text.find('\n', from);
        CHECK(end - from <= 110);
        from = end + 1;
    }
}

TEST_CASE("the report's files are written into a new folder; a file in its place is an error") {
    const fs::path folder = fs::temp_directory_path() / ("muster_report_test_" + std::to_string(::getpid()));
    const fs::path deep = folder / "deep" / "er";
    REQUIRE(writeReport(fakeReproduction(2), deep.string()).ok());
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(deep)) names.insert(entry.path().filename().string());
    CHECK(names == std::set<std::string>{"index.html", "results.json", "summary.md", "x2-film.svg",
                                         "x4-film-fixed.svg", "x4-film-transport.svg"});
    CHECK(*readTextFile((deep / "index.html").string()) == reportHtml(fakeReproduction(2)));
    const std::string file = (folder / "file").string();
    REQUIRE(writeTextFile(file, "x").ok());
    const Status status = writeReport(fakeReproduction(2), file);
    CHECK(status.code() == StatusCode::IoError);
    CHECK(status.message().find(file) == 0);
    fs::remove_all(folder);
}
