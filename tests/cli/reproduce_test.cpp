// `muster reproduce`, run as a user runs it.
#include <doctest.h>

#include <nlohmann/json.hpp>
#include <set>
#include <string>
#include <vector>

#include "cli/run_program.h"
#include "test_folders.h"

using muster::sourceFolder;
using muster::testing::Outcome;
using muster::testing::put;
using muster::testing::runProgram;
using muster::testing::slurp;
using muster::testing::workFolder;
using OrderedJson = nlohmann::ordered_json;
namespace fs = std::filesystem;

namespace {

std::string quoted(const fs::path& path) {
    return "'" + path.string() + "'";
}

/// Expects that code and one sentence that names the culprit, before the first run: standard error mentions
/// none of the runs.
void refuses(const std::string& line, int code, const std::string& culprit) {
    CAPTURE(line);
    const Outcome outcome = runProgram("reproduce " + line);
    CAPTURE(outcome.error);
    CHECK(outcome.code == code);
    CHECK(outcome.out.empty());
    CHECK(outcome.errorLines() == 1);
    CHECK(outcome.error.rfind("muster: ", 0) == 0);
    CHECK(outcome.error.find(culprit) != std::string::npos);
}

}  // namespace

TEST_CASE("reproduce refuses wrong arguments before the first run") {
    const fs::path free = workFolder() / "refused";
    const std::string out = " --seeds 1000 --out " + quoted(free);
    refuses("X99" + out, 2, "\"X99\"");
    refuses("X2 x12" + out, 2, "\"x12\"");
    refuses("X2 --seeds 0", 2, "--seeds");
    refuses("X2 --seeds 1001", 2, "--seeds");
    refuses("X2 --seeds some", 2, "--seeds");
    refuses("X2 --threads -1", 2, "--threads");
    refuses("X2 --seeds 1000 --out ''", 2, "--out");
    refuses("X2 --scenarios /nowhere/paper" + out, 1, "/nowhere/paper");
    CHECK_FALSE(fs::exists(free));

    const std::string file = put("a_file", "kept");
    refuses("X2 --seeds 1000 --out '" + file + "'", 1, file);
    refuses("X2 --seeds 1000 --out '" + file + "/below'", 1, file + "/below");
    CHECK(slurp(file) == "kept");
    const fs::path taken = workFolder() / "taken";
    fs::create_directories(taken / "index.html");
    refuses("X2 --seeds 1000 --out " + quoted(taken), 1, (taken / "index.html").string());
    const fs::path bare = workFolder() / "no_scenarios";
    fs::create_directories(bare);
    refuses("X2 --scenarios " + quoted(bare) + out, 1, (bare / "x02-line-and-area.json").string());
}

TEST_CASE("reproduce writes a report, a line per experiment in a log, and the verdicts") {
    const fs::path out = workFolder() / "new/report";
    const Outcome text = runProgram("reproduce x2 --seeds 1 --out " + quoted(out));
    REQUIRE_MESSAGE(text.code == 0, text.error);
    CHECK(text.error == "X2   A line and an area on one mesh: complete, 1 of 1 runs in all\n");
    CHECK(text.out.rfind("X2  A line and an area on one mesh: ", 0) == 0);
    CHECK(text.out.find("      pass  muster  ") != std::string::npos);
    CHECK(text.out.find((out / "index.html").string() + "\n") != std::string::npos);
    std::set<std::string> names;
    for (const auto& entry : fs::directory_iterator(out)) names.insert(entry.path().filename().string());
    CHECK(names == std::set<std::string>{"index.html", "results.json", "summary.md", "x2-film.svg"});

    const std::string page = slurp(out / "index.html");
    const std::string version = runProgram("--version").out;
    CHECK(page.find("<dd>" + version.substr(0, version.find('\n')) + "</dd>") != std::string::npos);
    CHECK(page.find(" UTC</dd>") != std::string::npos);

    const OrderedJson results = OrderedJson::parse(slurp(out / "results.json"));
    REQUIRE(results.is_array());
    REQUIRE_FALSE(results.empty());
    std::vector<std::string> keys;
    for (const auto& [key, value] : results[0].items()) keys.push_back(key);
    CHECK(keys == std::vector<std::string>{"experiment", "criterion", "preset", "value", "threshold", "pass",
                                           "binding", "seeds", "low", "high"});
    CHECK(results[0]["experiment"] == "X2");
    CHECK(results[0]["seeds"] == 1);
    CHECK(results[0]["value"].is_number());

    // A second run over the old report, on more threads, gives the same results, also on standard output.
    const Outcome json = runProgram("reproduce X2 --seeds 1 --threads 2 --json --out " + quoted(out));
    CHECK(json.code == 0);
    CHECK(OrderedJson::parse(json.out, nullptr, false) == results);
}

TEST_CASE("a failed criterion gives exit code 3, and every output of results states it") {
    // The scene of X2 with a finger that only touches: nothing bends.
    const fs::path folder = workFolder() / "unbent", out = workFolder() / "failed";
    fs::create_directories(folder / "gestures");
    const std::string source = sourceFolder() + "/scenarios/paper/";
    fs::copy_file(source + "x02-line-and-area.json", folder / "x02-line-and-area.json");
    put("unbent/gestures/x02-line-and-area.json", R"({"format":"muster-gestures","version":1,"events":[
        {"t":0.1,"kind":"down","touch":1,"x":0,"y":0},{"t":3.0,"kind":"up","touch":1}]})");
    const Outcome outcome = runProgram("reproduce X2 --seeds 1 --scenarios " + quoted(folder) + " --out " +
                                       quoted(out));
    CHECK(outcome.code == 3);
    CHECK(outcome.out.find("      FAIL  muster  ") != std::string::npos);
    CHECK(outcome.out.find("\n0 of 1 criterion holds; 1 seed, ") != std::string::npos);
    CHECK(OrderedJson::parse(slurp(out / "results.json"), nullptr, false)[0]["pass"] == false);
    CHECK(slurp(out / "index.html").find("<b>0 of 1</b> criterion holds, 1 fails") != std::string::npos);
    CHECK(slurp(out / "summary.md").find("**fail**") != std::string::npos);
}
