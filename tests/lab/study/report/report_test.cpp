// Report and export of made databases.
#include <doctest.h>
#include <unistd.h>

#include <sstream>

#include "json/json.h"
#include "lab/study/report/study_report.h"
#include "temporary_folder.h"

using namespace muster;

namespace {

struct Folder : testing::TemporaryFolder {
    Folder() : TemporaryFolder("study_report") {}
    StudyStore store() const {
        return std::move(StudyStore::open(*this / "s.db", StoreMode::Create)).value();
    }
};

void addTrial(StudyStore& store, std::int64_t run, const std::string& scheme, std::uint64_t seed,
              double seconds) {
    StudyTrial trial{.run = run,
                     .def = {"corridor", 36, scheme, seed, false},
                     .setting = "default",
                     .state = RunState::Complete,
                     .result = {.done = true, .seconds = seconds}};
    REQUIRE(store.addTrial(trial).ok());
}

}  // namespace

TEST_CASE("An empty study is reported in sentences") {
    const Folder folder;
    StudyStore store = folder.store();
    REQUIRE(writeStudyReport(store, folder.base.string(), "0").ok());
    CHECK(folder.read("report.html").find("There are no runs of models.") != std::string::npos);
    CHECK(folder.read("report.html").find("There are no runs of people.") != std::string::npos);
    CHECK(folder.read("results.json").find_first_not_of("[] \n") == std::string::npos);
}

TEST_CASE("Ratios are those to the better mouse, and tests never count") {
    const Folder folder;
    StudyStore store = folder.store();
    const std::int64_t models = *store.addRun({});
    StudyRun test{.kind = RunKind::Test};
    const std::int64_t tested = *store.addRun(test);
    for (std::uint64_t seed = 1; seed <= 5; ++seed) {
        addTrial(store, models, "touch", seed, 30.0);
        addTrial(store, models, "mouse-full-continuum", seed, 60.0);
        addTrial(store, models, "mouse-full-free", seed, 40.0);
        addTrial(store, tested, "touch", seed, 1.0);
    }
    REQUIRE(writeStudyReport(store, folder.base.string(), "0").ok());
    const auto rows = parseJson(folder.read("results.json"), "results.json");
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
    StudyRun run{.kind = RunKind::People, .note = "left, then \"came back\""};
    addTrial(store, *store.addRun(run), "touch", 1, 30.5);
    REQUIRE(exportStudy(store, folder.base.string()).ok());
    CHECK(folder.read("runs.csv").find("\"left, then \"\"came back\"\"\"\r\n") != std::string::npos);
    CHECK(folder.read("trials.csv").find(",30.5,") != std::string::npos);
    std::stringstream heading(folder.read("trials.csv").substr(0, folder.read("trials.csv").find("\r\n")));
    for (std::string column; std::getline(heading, column, ',');)
        CHECK(folder.read("codebook.csv").find("trials.csv," + column + ",") != std::string::npos);
}
