// Report and export of made databases.
#include <doctest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <sstream>

#include "json/json.h"
#include "lab/study/report/study_report.h"

using namespace muster;

namespace {

struct Folder {
    std::filesystem::path path = std::filesystem::temp_directory_path() /
                                 ("muster_study_report_" + std::to_string(::getpid()));
    Folder() { std::filesystem::create_directories(path); }
    ~Folder() { std::filesystem::remove_all(path); }
    std::string text(const std::string& name) const {
        std::ifstream file(path / name, std::ios::binary);
        std::stringstream all;
        all << file.rdbuf();
        return all.str();
    }
    StudyStore store() const {
        return std::move(StudyStore::open((path / "s.db").string(), StoreMode::Create)).value();
    }
};

void addTrial(StudyStore& store, std::int64_t run, const std::string& scheme, std::uint64_t seed,
              double seconds) {
    StudyTrial trial;
    trial.run = run;
    trial.def = {"corridor", 36, scheme, seed, false};
    trial.setting = "default";
    trial.state = RunState::Complete;
    trial.result.done = true;
    trial.result.seconds = seconds;
    REQUIRE(store.addTrial(trial).ok());
}

}  // namespace

TEST_CASE("An empty study is reported in sentences") {
    const Folder folder;
    StudyStore store = folder.store();
    REQUIRE(writeStudyReport(store, folder.path.string(), "0").ok());
    CHECK(folder.text("report.html").find("There are no runs of models.") != std::string::npos);
    CHECK(folder.text("report.html").find("There are no runs of people.") != std::string::npos);
    CHECK(folder.text("results.json").find_first_not_of("[] \n") == std::string::npos);
}

TEST_CASE("Ratios are those to the better mouse, and tests never count") {
    const Folder folder;
    StudyStore store = folder.store();
    const std::int64_t models = *store.addRun({});
    StudyRun test;
    test.kind = RunKind::Test;
    const std::int64_t tested = *store.addRun(test);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        addTrial(store, models, "touch", seed, 30.0);
        addTrial(store, models, "mouse-full-continuum", seed, 60.0);
        addTrial(store, models, "mouse-full-free", seed, 40.0);
        addTrial(store, tested, "touch", seed, 1.0);
    }
    REQUIRE(writeStudyReport(store, folder.path.string(), "0").ok());
    const auto rows = parseJson(folder.text("results.json"), "results.json");
    REQUIRE(rows.ok());
    REQUIRE(rows->size() == 3);
    for (const Json& row : rows->elements()) {
        CHECK(row.find("kind")->text() == "models");
        CHECK(row.find("n")->whole<int>() == 5);
        if (row.find("control")->text() != "touch") continue;
        CHECK(row.find("median_s")->number() == 30.0);
        CHECK(row.find("ratio_to_best_mouse")->number() == doctest::Approx(0.75));
        CHECK(row.find("low")->number() == doctest::Approx(0.75));
        CHECK(row.find("share_of_draws")->isNull());
    }
}

TEST_CASE("Exports quote what must be quoted, and the codebook names every column") {
    CHECK(csvField("plain") == "plain");
    CHECK(csvField("a,\"b\"\n") == "\"a,\"\"b\"\"\n\"");
    const Folder folder;
    StudyStore store = folder.store();
    StudyRun run;
    run.kind = RunKind::People;
    run.note = "left, then \"came back\"";
    addTrial(store, *store.addRun(run), "touch", 1, 30.5);
    REQUIRE(exportStudy(store, folder.path.string()).ok());
    CHECK(folder.text("runs.csv").find("\"left, then \"\"came back\"\"\"\r\n") != std::string::npos);
    CHECK(folder.text("trials.csv").find(",30.5,") != std::string::npos);
    std::stringstream heading(folder.text("trials.csv").substr(0, folder.text("trials.csv").find("\r\n")));
    for (std::string column; std::getline(heading, column, ',');)
        CHECK(folder.text("codebook.csv").find("trials.csv," + column + ",") != std::string::npos);
}
