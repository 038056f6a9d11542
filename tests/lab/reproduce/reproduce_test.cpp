// Running experiments: what is refused before the first run, and that threads change nothing.
#include "lab/reproduce/reproduce.h"
#include "test_folders.h"

#include <unistd.h>

#include <doctest.h>

#include <cstdio>
#include <filesystem>
#include <set>

using namespace muster;
namespace fs = std::filesystem;

namespace {

const std::string kFolder = sourceFolder() + "/scenarios/paper";

Status refused(const ReproduceDef& def) {
    bool ran = false;
    const auto result = reproduce(def, [&](const ReproduceProgress&) { ran = true; });
    CHECK_FALSE(ran);
    REQUIRE_FALSE(result.ok());
    CHECK(checkReproduce(def).message() == result.status().message());
    return result.status();
}

}  // namespace

TEST_CASE("experiments have ids, titles and arms of their own") {
    std::set<std::string> ids;
    for (const auto& experiment : paperExperiments()) {
        const ExperimentText text = experiment->text();
        CAPTURE(text.id);
        CHECK(ids.insert(text.id).second);
        CHECK_FALSE(text.title.empty());
        CHECK_FALSE(text.paper.empty());
        CHECK_FALSE(text.scene.empty());
        CHECK_FALSE(experiment->arms().empty());
        std::set<std::pair<std::string, std::string>> arms;
        for (const Arm& arm : experiment->arms()) CHECK(arms.insert({arm.id, arm.preset}).second);
        std::set<std::string> figures;
        for (const FigureInfo& figure : experiment->figures()) CHECK(figures.insert(figure.name).second);
    }
}

TEST_CASE("what cannot be run is reported by name before the first run") {
    const Status unknown = refused({{"X2", "X99"}, 1, 1, kFolder});
    CHECK(unknown.code() == StatusCode::NotFound);
    CHECK(unknown.message().find("\"X99\"") != std::string::npos);
    CHECK(unknown.message().find("X2") != std::string::npos);

    CHECK(refused({{"X2"}, 0, 1, kFolder}).code() == StatusCode::InvalidArgument);
    CHECK(refused({{"X2"}, 1001, 1, kFolder}).message().find("1001") != std::string::npos);

    const Status folder = refused({{"X2"}, 1, 1, "/nowhere/paper"});
    CHECK(folder.code() == StatusCode::NotFound);
    CHECK(folder.message().find("/nowhere/paper:") == 0);

    const fs::path empty = fs::temp_directory_path() /
                           ("muster_reproduce_test_" + std::to_string(::getpid()));
    fs::create_directories(empty);
    const Status scenario = refused({{"x2"}, 1, 1, empty.string()});
    CHECK(scenario.message().find((empty / "x02-line-and-area.json").string() + ":") == 0);
    CHECK(scenario.message().find("X2") != std::string::npos);
    fs::remove_all(empty);
}

TEST_CASE("a scenario that is there but cannot be read ends it, naming experiment and file") {
    const fs::path folder = fs::temp_directory_path() /
                            ("muster_reproduce_torn_" + std::to_string(::getpid()));
    fs::create_directories(folder);
    const std::string path = (folder / "x02-line-and-area.json").string();
    std::FILE* file = std::fopen(path.c_str(), "w");
    REQUIRE(file != nullptr);
    std::fputs("{\"format\":", file);
    std::fclose(file);
    std::size_t reports = 0;
    const auto result = reproduce({{"X2"}, 3, 2, folder.string()},
                                  [&](const ReproduceProgress&) { ++reports; });
    REQUIRE_FALSE(result.ok());
    CHECK(result.status().message().rfind("X2: " + path + ":", 0) == 0);
    CHECK(reports == 0);
    fs::remove_all(folder);
}

TEST_CASE("the number of threads changes nothing but the time") {
    std::vector<Reproduction> all;
    for (const std::int32_t threads : {1, 3}) {
        std::int32_t last = 0, of = 0, own = 0;
        auto result = reproduce({{"x2", "X2"}, 2, threads, kFolder}, [&](const ReproduceProgress& p) {
            CHECK(p.done == last + 1);
            CHECK(p.experiment == "X2");
            last = p.done;
            of = p.of;
            own = p.experimentDone;
            CHECK(p.experimentOf == p.of);
        });
        REQUIRE(result.ok());
        CHECK(last == 2);
        CHECK(of == 2);
        CHECK(own == 2);
        result->seconds = 0.0;
        all.push_back(std::move(*result));
    }
    REQUIRE(all[0].experiments.size() == 1);
    CHECK(resultsJson(all[0]) == resultsJson(all[1]));
    CHECK(reportHtml(all[0]) == reportHtml(all[1]));
    const auto& runs = all[0].experiments[0].samples.runs("both", "muster");
    REQUIRE(runs.size() == 2);
    CHECK(runs[0].hash != 0);
    CHECK(runs[0].hash != runs[1].hash);  // Seeds differ.
    CHECK(runs[0].film.size() == 4);
    CHECK(runs[1].film.empty());
    CHECK(runs[0].hash == all[1].experiments[0].samples.runs("both", "muster")[0].hash);
}
