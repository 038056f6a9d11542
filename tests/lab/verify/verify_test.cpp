// The registry of standard tests, what is chosen of it, its outcomes and its report.
#include "lab/verify/verify.h"

#include <doctest.h>

#include <cmath>
#include <set>

using namespace muster;

namespace {

/// A scene that measures its variant as a number, plus the seed over ten.
SceneDef numberScene() {
    return {"number",
            [](const SceneRun& run) -> Result<VerifySample> {
                if (run.variant == "broken") return invalidArgument("it broke");
                VerifySample sample;
                sample.figures["value"] = std::atof(run.variant.c_str()) +
                                          0.1 * static_cast<double>(run.seed);
                if (run.picture)
                    sample.picture = "<svg width=\"10\" height=\"10\"><title>drawn</title></svg>";
                return sample;
            },
            1.0};
}

RowDef numberRow(const std::string& id, double most, const std::string& variant = "5") {
    RowDef row{.id = id,
               .suite = id.substr(0, id.find(' ')),
               .title = "A number",
               .expected = "at most " + std::to_string(most),
               .scene = "number",
               .variants = {variant},
               .seeds = 2,
               .briefSeeds = most < 10.0 ? 1 : 0};
    row.judge = [=](const VerifySamples& samples, RowReport& report) {
        report.atMost("the largest", samples.most(variant, "value"), most, "m", Whose::Own);
        report.shown("the mean", samples.mean(variant, "value"), "m");
        report.plots.push_back({"A plot", "x", "y", {{"line", {{0, 0}, {1, 2}}}}, {}, {}, ""});
    };
    return row;
}

RowDef lackingRow() {
    return {.id = "Beta 1", .suite = "Beta", .missing = "needs <floors>"};
}

Verification madeOf(const VerifyDef& def, double most) {
    auto made = verifyRowsOf(def, {numberRow("Alpha 1", most), numberRow("Alpha 2", 100.0), lackingRow()},
                             {numberScene()});
    REQUIRE_MESSAGE(made.ok(), made.status().message());
    return std::move(made).value();
}

std::size_t occurrences(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

}  // namespace

TEST_CASE("every test of the standards has a row") {
    std::map<std::string, std::set<std::string>> numbers;
    std::set<std::string> ids;
    for (const RowDef& row : verifyRows()) {
        CAPTURE(row.id);
        CHECK(ids.insert(row.id).second);
        CHECK(row.id.rfind(row.suite + " ", 0) == 0);
        CHECK_FALSE(row.title.empty());
        CHECK_FALSE(row.expected.empty());
        if (row.missing.empty()) {
            CHECK_FALSE(row.variants.empty());
            CHECK(row.seeds >= 1);
            CHECK_FALSE(row.source.empty());
            CHECK_FALSE(row.setup.empty());
            REQUIRE(row.judge);
        }
        std::string number = row.id.substr(row.suite.size() + 1);
        if (const std::size_t old = number.find(" (3.0)"); old != std::string::npos) number.resize(old);
        if (number == "12c") number = "12";
        numbers[row.suite].insert(number);
    }
    CHECK(numbers["RiMEA"].size() == 16);
    CHECK(numbers["IMO"].size() == 11);
    CHECK(numbers["NIST"].size() == 17);
    CHECK(numbers["ISO"].size() == 19);
    CHECK(numbers["Data"].size() >= 9);
    for (const char* old : {"RiMEA 12 (3.0)", "RiMEA 13 (3.0)", "RiMEA 12c"}) CHECK(ids.contains(old));
}

TEST_CASE("rows look at scenes that are there, and a broken judge is none that passes") {
    for (const RowDef& row : verifyRows()) {
        if (!row.missing.empty()) continue;
        CAPTURE(row.id);
        bool found = false;
        for (const SceneDef& scene : verifyScenes()) found = found || scene.id == row.scene;
        CHECK(found);
        // Without a sample nothing passes.
        RowReport report;
        VerifySamples none;
        row.judge(none, report);
        bool passes = !report.checks.empty();
        for (const VerifyCheck& check : report.checks) passes = passes && (!check.binding || check.pass());
        CHECK_FALSE(passes);
    }
}

TEST_CASE("tests are chosen by name, by suite, and by how long they take") {
    VerifyDef def{.only = {"rimea 4", "IMO-11"}};
    auto rows = chosenRows(def, verifyRows());
    REQUIRE(rows.ok());
    REQUIRE(rows->size() == 2);
    CHECK((*rows)[0].id == "RiMEA 4");
    CHECK((*rows)[1].id == "IMO 11");
    def.only = {"nist"};
    CHECK(chosenRows(def, verifyRows())->size() == 17);
    def.only = {"RiMEA 99"};
    rows = chosenRows(def, verifyRows());
    CHECK(rows.status().code() == StatusCode::NotFound);
    CHECK(rows.status().message().find("found the test \"RiMEA 99\"") != std::string::npos);
    CHECK(rows.status().message().find("RiMEA, IMO, NIST, ISO, Data") != std::string::npos);
    VerifyDef brief{.brief = true};
    const auto short1 = chosenRows(brief, verifyRows());
    CHECK(short1->size() > 30);
    CHECK(short1->size() < verifyRows().size());
}

TEST_CASE("outcomes: pass, fail, missing") {
    const Verification good = madeOf({}, 5.2);
    CHECK(good.passed());
    CHECK(good.exitCode() == 0);
    CHECK(good.count(Outcome::Pass) == 2);
    CHECK(good.count(Outcome::Missing) == 1);
    CHECK(good.rows[0].seeds == 2);
    const Verification bad = madeOf({}, 5.15);
    CHECK_FALSE(bad.passed());
    CHECK(bad.exitCode() == 1);
    CHECK(bad.rows[0].outcome == Outcome::Fail);
    // With one seed the value is smaller.
    VerifyDef one{.seeds = 1};
    CHECK(madeOf(one, 5.15).passed());
    VerifyDef brief{.brief = true};
    CHECK(madeOf(brief, 5.15).rows.size() == 2);
}

TEST_CASE("results do not depend on the number of threads") {
    VerifyDef one, three;
    one.threads = 1;
    three.threads = 3;
    Verification a = madeOf(one, 5.2), b = madeOf(three, 5.2);
    a.seconds = b.seconds = 0.0;
    CHECK(verificationJson(a) == verificationJson(b));
}

TEST_CASE("a scene that breaks is told with its name, and one that is unknown, too") {
    const auto broken = verifyRowsOf({}, {numberRow("Alpha 1", 5.0, "broken")}, {numberScene()});
    CHECK(broken.status().message() == "scene number broken: it broke");
    CHECK_FALSE(verifyRowsOf({}, {numberRow("Alpha 1", 5.0)}, {}).ok());
    VerifyDef many{.seeds = 2000};
    CHECK_FALSE(verifyRowsOf(many, {numberRow("Alpha 1", 5.0)}, {numberScene()}).ok());
}

TEST_CASE("a value that was not measured fails") {
    VerifyCheck check{"x", kUnmeasured, -1e300, 1e300, "", Whose::Standard, true};
    CHECK_FALSE(check.pass());
    VerifySamples samples;
    CHECK(std::isnan(samples.mean("a", "b")));
    samples.add("a", {{{"b", 2.0}}, {}, "", 0, 0.0});
    samples.add("a", {});
    CHECK(std::isnan(samples.mean("a", "b")));
    CHECK(std::isnan(samples.least("a", "b")));
    CHECK(samples.values("a", "b").size() == 2);
}

TEST_CASE("the table has aligned columns and a line of counts") {
    Verification bad = madeOf({}, 5.15);
    const std::string text = verificationText(bad);
    CHECK(text.find("Alpha 1         FAIL    2") != std::string::npos);
    CHECK(text.find("Alpha 2         pass    2") != std::string::npos);
    CHECK(text.find("Beta 1          missing -") != std::string::npos);
    CHECK(text.find("1 pass, 1 fail, 1 missing") != std::string::npos);
    CHECK(text.find("[own]") != std::string::npos);
    CHECK(text.find("nan") == std::string::npos);
    const std::string markdown = verificationMarkdown(bad);
    CHECK(markdown.find("| Alpha 1 A number | ") != std::string::npos);
    CHECK(markdown.find("| 2 | **fail** |") != std::string::npos);
    CHECK(occurrences(markdown, "\n") == 5);
}

TEST_CASE("the page has every row, its plots and pictures, and words stay words") {
    Verification made = madeOf({}, 5.15);
    made.rows[0].row.title = "<script>alert(1)</script>";
    const std::string page = verificationPage(made);
    CHECK(page.find("<script>") == std::string::npos);
    for (const RowResult& row : made.rows)
        CHECK(page.find("id=\"" +
                        std::string(row.row.id == "Beta 1"    ? "beta-1"
                                    : row.row.id == "Alpha 1" ? "alpha-1"
                                                              : "alpha-2") +
                        "\"") != std::string::npos);
    CHECK(occurrences(page, "class=\"chart\"") == 2);
    // Both rows look at the same runs: their paths are shown once.
    CHECK(occurrences(page, "<title>drawn</title>") == 1);
    CHECK(page.find("see <a href=\"#alpha-1\">") != std::string::npos);
    CHECK(page.find("needs &lt;floors&gt;") != std::string::npos);
    CHECK(page.find("http://www.w3.org") != std::string::npos);
    CHECK(page.find("src=") == std::string::npos);
}

TEST_CASE("the page of the real registry has a chapter for each row, run or not") {
    Verification all;
    for (const RowDef& row : verifyRows())
        all.rows.push_back({.row = row, .outcome = row.missing.empty() ? Outcome::Fail : Outcome::Missing});
    const std::string page = verificationPage(all);
    CHECK(occurrences(page, "class=\"chapter\"") == verifyRows().size());
}
