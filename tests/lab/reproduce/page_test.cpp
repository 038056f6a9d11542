// The report's page: well-formed, whole, honest, and of itself.
#include <doctest.h>

#include <set>

#include "base/hash.h"
#include "lab/picture/xml.h"
#include "lab/reproduce/fake.h"
#include "lab/reproduce/report/html_parts.h"

using namespace muster;
using muster::testing::Element;
using muster::testing::fakeReproduction;
using muster::testing::XmlReader;

namespace {

/// The page without its first line, which is no element.
std::string bodyOf(const std::string& page) {
    const std::string first = "<!doctype html>\n";
    REQUIRE(page.rfind(first, 0) == 0);
    return page.substr(first.size());
}

std::size_t count(const std::string& text, const std::string& part) {
    std::size_t found = 0;
    for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1)) ++found;
    return found;
}

/// What stands in the chapter of an experiment.
std::string chapterOf(const std::string& page, const std::string& id) {
    const std::size_t from = page.find("<article class=\"chapter\" id=\"" + id + "\"");
    REQUIRE(from != std::string::npos);
    return page.substr(from, page.find("</article>", from) - from);
}

}  // namespace

TEST_CASE("the page is well-formed, its ids differ and its links lead somewhere") {
    const std::string body = bodyOf(reportHtml(fakeReproduction()));
    const XmlReader xml(body);
    REQUIRE(xml.error.empty());
    std::set<std::string> ids;
    for (const Element& element : xml.elements) {
        const std::string id = element.attribute("id");
        if (!id.empty()) CHECK_MESSAGE(ids.insert(id).second, id);
    }
    for (const Element& element : xml.elements) {
        const std::string target = element.attribute("href");
        if (target.empty()) continue;
        CAPTURE(target);
        REQUIRE(target[0] == '#');
        CHECK(ids.count(target.substr(1)) == 1);
    }
}

TEST_CASE("the page asks no network for anything") {
    const std::string page = reportHtml(fakeReproduction());
    const std::string body = bodyOf(page);
    const XmlReader xml(body);
    for (const Element& element : xml.elements) {
        CHECK(element.attribute("src").empty());
        CHECK(element.name != "script");
        CHECK(element.name != "link");
    }
    CHECK(page.find("@import") == std::string::npos);
    CHECK(page.find("url(http") == std::string::npos);
    CHECK(page.find("default-src 'none'") != std::string::npos);
}

TEST_CASE("the page tells what was run, and how many criteria hold") {
    const std::string page = reportHtml(fakeReproduction());
    for (const char* part : {"0.1.0", "2026-01-02 03:04 UTC", "X2, X4", "812 s (13.5 min)",
                             "<b>3 of 6</b> criteria hold, 3 fail"}) {
        CAPTURE(part);
        CHECK(page.find(part) != std::string::npos);
    }
    CHECK(page.find("Fewer than 10 seeds") == std::string::npos);
    CHECK(reportHtml(fakeReproduction(3)).find("Fewer than 10 seeds") != std::string::npos);
}

TEST_CASE("failed criteria are named at the top, in the table of all and in their chapter") {
    const Reproduction reproduction = fakeReproduction();
    const std::string page = reportHtml(reproduction);
    const std::string head = page.substr(0, page.find("</header>"));
    for (const ExperimentResult& experiment : reproduction.experiments) {
        for (const Verdict& verdict : experiment.verdicts) {
            if (verdict.pass || !verdict.binding) continue;
            CAPTURE(verdict.criterion);
            CHECK(head.find(verdict.criterion) != std::string::npos);
        }
    }
    const std::size_t failed = 3 + 2;  // Binding ones, and those of the paper's preset.
    const std::string table = summaryTable(reproduction);
    CHECK(count(table, "class=\"sign fail") == failed);
    CHECK(count(table, "class=\"sign pass") == 4 - 2 + 2);
    CHECK(count(table, "<tr class=") == 9);
    CHECK(count(chapterOf(page, "x4"), "class=\"sign fail") == failed);
}

TEST_CASE("presets stand side by side, and what was not judged is said") {
    const ExperimentResult experiment = testing::fakeWoodland(10);
    CHECK(presetsOf(experiment) == std::vector<std::string>{"muster", "paper"});
    const auto rows = criterionRows(experiment);
    REQUIRE(rows.size() == 5);
    CHECK(rows[0].byPreset[1]->preset == "paper");
    CHECK(rows[0].byPreset[1]->criterion == rows[0].byPreset[0]->criterion);
    CHECK(rows[4].byPreset[1] == nullptr);
    CHECK(count(criteriaTable(experiment, 10), "not judged") == 2);
}

TEST_CASE("the same words judged twice, or with another threshold, stay apart") {
    ExperimentResult experiment = testing::fakeHalves(2);
    Judge judge(1);
    for (const double threshold : {1.0, 1.0, 2.0})
        judge.require("same", "muster", {1.5}, Aggregate::Median, Comparison::AtLeast, threshold);
    judge.require("same", "paper", {1.5}, Aggregate::Median, Comparison::AtLeast, 2.0);
    experiment.verdicts = judge.verdicts();
    const auto rows = criterionRows(experiment);
    REQUIRE(rows.size() == 3);
    CHECK(rows[0].byPreset[1] == nullptr);
    CHECK(rows[2].byPreset[1] == &experiment.verdicts[3]);
}

TEST_CASE("values that were not reached are shown as such") {
    const ExperimentResult experiment = testing::fakeWoodland(10);
    const std::string figures = figuresTables(experiment, 10);
    CHECK(count(figures, "<span class=\"missing\">not reached</span>") == 4);
    CHECK(count(figures, "no value in 2 of 10") == 4);
    CHECK(count(figures, "<span class=\"none\">–</span>") == 1);  // Measured in three arms of four.
    CHECK(figures.find("nan") == std::string::npos);
    CHECK(verdictValueText(experiment.verdicts[6]) == "not reached");
    CHECK(verdictRangeText(experiment.verdicts[6], 10) == "in none of 10 seeds");
    CHECK(verdictRangeText(experiment.verdicts[7], 10) == "12,346 to 123,456, no value in 2 of 10 seeds");
    CHECK(stripPlots(experiment).find("Without a value in any run: what nobody reached.") !=
          std::string::npos);
}

TEST_CASE("medians and ranges of the table") {
    const std::string figures = figuresTables(testing::fakeHalves(10), 10);
    CHECK(figures.find("<b>6.0</b> <small>6.001 to 6.01</small>") != std::string::npos);
    const std::string woodland = figuresTables(testing::fakeWoodland(10), 10);
    CHECK(woodland.find("<b>5.5</b> <small>1 to 10</small>") != std::string::npos);
    CHECK(woodland.find("<b>36</b></td>") != std::string::npos);
    ExperimentResult wide = testing::fakeHalves(1);
    for (int k = 0; k < 8; ++k) wide.arms.push_back({"arm" + std::to_string(k), "Arm " + std::to_string(k)});
    CHECK(count(figuresTables(wide, 1), "<table") == 2);
}

TEST_CASE("what was measured in some seeds only is distinguished from what was not reached") {
    ExperimentResult x = testing::fakeHalves(0);
    for (int seed = 1; seed <= 5; ++seed) {
        RunSample run;
        if (seed <= 3) run.figures["ratio"] = seed == 3 ? testing::kNone : static_cast<double>(seed);
        x.samples.add("both", "muster", run);
    }
    const std::string figures = figuresTables(x, 5);
    CHECK(figures.find("no value in 1 of 3<") != std::string::npos);
    CHECK(figures.find("<small>measured in 3 of 5</small>") != std::string::npos);
    CHECK(stripPlots(x).find("Line and area: 1 without a value<") != std::string::npos);
}

TEST_CASE("a chapter has its pictures, plots, charts, commands and hashes") {
    const std::string page = reportHtml(fakeReproduction());
    const std::string chapter = chapterOf(page, "x4");
    CHECK(count(chapter, "<figcaption><b>") == 10);
    CHECK(count(chapter, "class=\"missing\">no picture<") == 2);
    CHECK(count(chapter, "class=\"chart\"") == 4 + 3);
    CHECK(chapter.find("all runs gave one value: people through the wood and a figure that never differs.") !=
          std::string::npos);
    for (const char* command : {"muster reproduce X4 --seeds 10", "muster studio paper/x04-woodland",
                                "muster play scenarios/paper/x04-woodland.json --demo"})
        CHECK(chapter.find(command) != std::string::npos);
    CHECK(count(chapter, toHex(0x0123456789abcdefull + 1)) == 4);
    // Where there is no scenario and no hash, none is claimed.
    const std::string halves = chapterOf(page, "x2");
    CHECK(halves.find("muster studio") == std::string::npos);
    CHECK(halves.find("<code>none</code>") != std::string::npos);
}

TEST_CASE("whatever words an experiment has, they stay words") {
    const std::string nasty = "</style></title><script>alert(1)</script>\"' & \xff\x01]]>-->";
    ExperimentResult x = testing::fakeWoodland(2);
    x.text = {nasty, nasty, nasty, nasty, nasty, nasty};
    for (Arm& arm : x.arms) arm.title = nasty;
    for (FigureInfo& figure : x.figures) figure.title = figure.unit = nasty;
    for (Verdict& verdict : x.verdicts) verdict.criterion = verdict.unit = verdict.preset = nasty;
    for (ChartDef& chart : x.charts) {
        chart.title = chart.xTitle = chart.yTitle = nasty;
        for (ChartSeries& series : chart.series) series.title = nasty;
    }
    Reproduction reproduction = fakeReproduction(2);
    reproduction.experiments = {x};
    reproduction.version = reproduction.when = nasty;
    const std::string page = reportHtml(reproduction), body = bodyOf(page);
    CHECK(page.find("<script") == std::string::npos);
    const XmlReader xml(body);
    CHECK(xml.error.empty());
}

TEST_CASE("a page of nothing is a page") {
    const std::string body = bodyOf(reportHtml({}));
    const XmlReader xml(body);
    CHECK(xml.error.empty());
}
