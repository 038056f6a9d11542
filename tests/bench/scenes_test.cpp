// Scenes for measuring: they stand as they say, and the drag leads where the course goes.
#include <doctest.h>

#include <algorithm>
#include <cmath>

#include "engine/state/validation.h"
#include "scale/bench_options.h"
#include "scale/bench_report.h"
#include "scale/case.h"
#include "scale/quality.h"

using namespace muster;
using namespace muster::scale;

namespace {

SceneDef sceneOf(const std::string& name, Regime regime, std::int32_t count) {
    SceneDef def;
    def.name = name;
    def.regime = regime;
    def.count = count;
    return def;
}

double meanX(std::span<const Vec2> points) {
    double sum = 0.0;
    for (const Vec2 p : points) sum += p.x;
    return sum / static_cast<double>(points.size());
}

}  // namespace

TEST_CASE("every scene makes a world in every regime, at several sizes") {
    for (const std::string& name : sceneNames()) {
        if (name == "city") continue;
        for (const Regime regime : {Regime::Far, Regime::Tracking, Regime::Reversing})
            for (const std::int32_t count : {36, 400, 2500}) {
                const Result<Scene> scene = makeScene(sceneOf(name, regime, count));
                REQUIRE_MESSAGE(scene.ok(), scene.status().message());
                CHECK(validate(scene->world).ok());
                CHECK(scene->world.groups.size() == 1);
                CHECK(scene->world.groups[0].starts.size() == static_cast<std::size_t>(count));
            }
    }
}

TEST_CASE("where far, at least 40 m lie between the crowd and the formation") {
    for (const std::string name : {"open", "paths"}) {
        const Scene scene = makeScene(sceneOf(name, Regime::Far, 900)).value();
        const GroupDef& group = scene.world.groups[0];
        double nearest = 1e9;
        for (const Vec2 p : group.starts)
            nearest = std::min(nearest, group.position.x - 0.5 * scene.side - p.x);
        CHECK(nearest >= 39.0);
    }
}

TEST_CASE("a seed gives other starts and trees, the same seed the same") {
    SceneDef def = sceneOf("woodland", Regime::Tracking, 100);
    const Scene first = makeScene(def).value();
    const Scene again = makeScene(def).value();
    def.seed = 2;
    const Scene other = makeScene(def).value();
    CHECK(first.world.obstacles[3].centre == again.world.obstacles[3].centre);
    CHECK(first.world.obstacles[3].centre != other.world.obstacles[3].centre);
    CHECK(first.course.speed != other.course.speed);
}

TEST_CASE("a course goes to and fro, round, and back every so often") {
    Course course;
    course.points = {{0, 0}, {10, 0}};
    course.speed = 1.0;
    CHECK(poseAt(course, 4.0).position.x == doctest::Approx(4.0));
    CHECK(poseAt(course, 13.0).position.x == doctest::Approx(7.0));
    course.reverseEvery = 2.5;
    CHECK(poseAt(course, 2.5).position.x == doctest::Approx(2.5));
    CHECK(poseAt(course, 4.0).position.x == doctest::Approx(1.0));
    CHECK(poseAt(course, 5.5).position.x == doctest::Approx(0.5));
    const Scene open = makeScene(sceneOf("open", Regime::Tracking, 100)).value();
    const double radius = length(poseAt(open.course, 0.0).position);
    for (double t = 0.0; t < 60.0; t += 1.0) {
        const CoursePose pose = poseAt(open.course, t);
        CHECK(length(pose.position) == doctest::Approx(radius).epsilon(0.01));
        // It faces where it goes, up to its own turning.
        const Vec2 way = poseAt(open.course, t + 0.1).position - pose.position;
        CHECK(std::fabs(std::remainder(std::atan2(way.y, way.x) - pose.angle, 6.283185307)) <
              open.course.turn + 0.1);
    }
}

TEST_CASE("the formation is dragged, the crowd follows at a distance, and the judge changes nothing") {
    CaseDef def{.scene = sceneOf("block", Regime::Tracking, 49), .plan = "exact", .seconds = 4.0};
    std::vector<double> lead;
    const Row row = runCase(def, [&](const World& world) {
                        lead.push_back(meanX(world.group(0).placePositions) -
                                       meanX(world.characters().position));
                    }).value();
    CHECK(row.steps == 239);
    CHECK(row.lagMean > 0.7);
    CHECK(row.lagMean < 3.0);
    CHECK(lead.back() > 0.5);
    ThreadPool pool(1);
    QualityPass pass(60, "", pool);
    const Row judged = runCase(def, [&](const World& world) { pass.observe(world); }).value();
    CHECK(judged.hash == row.hash);
    CHECK(pass.quality().looks == 4);
    CHECK(pass.quality().judge == "exact");
    CHECK(pass.quality().gapMax < 20.0);
    CHECK(pass.quality().objectiveMean > 0.3);
}

TEST_CASE("a far crowd arrives, and the run ends there") {
    CaseDef def{.scene = sceneOf("open", Regime::Far, 9), .plan = "exact"};
    const Row row = runCase(def).value();
    CHECK(row.arrived == 1.0);
    CHECK(row.steps < 60 * 60);
    CHECK(row.steps > 40 * 25);
}

TEST_CASE("a row says the same in JSON, Markdown and the table") {
    Row row{.def = {.scene = sceneOf("block", Regime::Reversing, 1000)}, .p95 = 0.875, .hash = 0xabcdef};
    const std::string bare = jsonRow(row);
    CHECK(bare.find("\"gap_max_pct\": null") != std::string::npos);
    row.quality = {"bound", 3, 12.5, 0.25, 0.5, 2.0};
    const std::string json = jsonRow(row);
    for (const char* part :
         {"\"scene\": \"block\"", "\"regime\": \"reversing\"", "\"n\": 1000", "\"ms_p95\": 0.875",
          "\"gap_mean_pct\": 0.25", "\"gap_max_pct\": 0.5", "\"gap_cold_pct\": 12.5", "\"judge\": \"bound\"",
          "\"contacts\": 0.0000", "\"hash\": \"0000000000abcdef\"}"})
        CHECK_MESSAGE(json.find(part) != std::string::npos, part);
    CHECK(json.front() == '{');
    CHECK(json.find('\n') == std::string::npos);
    CHECK(markdownRow(row).find("| bound | 0.250 / 0.500 / 12.5 |") != std::string::npos);
    const std::string head = markdownHead();
    const std::string line = markdownRow(row);
    CHECK(std::count(head.begin(), head.begin() + head.find('\n'), '|') ==
          std::count(line.begin(), line.end(), '|'));
    CHECK(tableRow(row).find("0.875") != std::string::npos);
}

TEST_CASE("growth is the slope of each series on its own") {
    std::vector<Row> rows;
    for (const double factor : {1.0, 7.0})
        for (const std::int32_t n : {100, 1000, 10000})
            rows.push_back({.def = {.scene = sceneOf(factor > 1.0 ? "block" : "open", Regime::Far, n)},
                            .p50 = factor * std::pow(n, 1.1)});
    const Growth growth = growthOf(rows, Regime::Far);
    CHECK(growth.exponent == doctest::Approx(1.1));
    CHECK(growth.least == 100);
    CHECK(growth.most == 10000);
    CHECK(growthOf(rows, Regime::Tracking).points == 0);
    rows.resize(1);
    CHECK(growthOf(rows, Regime::Far).points == 0);
}

TEST_CASE("bad options fail with one sentence, good ones make the requested cases") {
    const auto read = [](std::vector<const char*> words, Options& options) {
        words.insert(words.begin(), "muster-bench");
        return readOptions(static_cast<int>(words.size()), words.data(), options);
    };
    Options options;
    CHECK(read({"scale", "--scene", "moon"}, options) == 2);
    Options second;
    CHECK(read({"scale", "--n", "3"}, second) == 2);
    Options third;
    CHECK(read({"scale", "--regime", "near"}, third) == 2);
    Options none;
    CHECK(read({}, none) == 2);
    Options good;
    REQUIRE(read({"scale", "--scene", "open,block", "--n", "64", "--threads", "1,2", "--seed", "4"}, good) ==
            -1);
    const auto cases = casesOf(good).value();
    CHECK(cases.size() == 2 * 3 * 2);
    CHECK(cases[0].scene.seed == 4);
    CHECK(cases[1].threads == 2);
}
