#include <doctest.h>

#include <map>
#include <set>

#include "lab/study/series/trial_series.h"
#include "temporary_folder.h"

namespace muster {
namespace {

struct Folder : testing::TemporaryFolder {
    Folder() : TemporaryFolder("series") {}
};

SeriesDef small() {
    return {.seeds = 2, .environments = {"single-block"}, .schemes = {"touch", "mouse-full-continuum"}};
}

StudyStore opened(const std::string& path) {
    return StudyStore::open(path, StoreMode::Create).value();
}

void none(const SeriesProgress&) {}

/// All that a report could read, whatever the order in which trials were kept.
std::map<std::string, std::string> contents(StudyStore& store) {
    std::map<std::string, std::string> found;
    const auto runs = store.runs().value();
    for (const StudyRun& run : runs)
        found["run " + std::to_string(run.id)] = run.version + run.note +
                                                 std::to_string(static_cast<int>(run.state));
    const auto trials = store.trials().value();
    for (const StudyTrial& trial : trials) {
        const std::string key = trial.def.environment + " " + trial.def.scheme + " " +
                                std::to_string(trial.def.seed) + " " + trial.setting;
        CHECK(found.count(key) == 0);
        found[key] = std::to_string(trial.run) + " " + std::to_string(trial.result.hash) + " " +
                     std::to_string(trial.result.seconds) + " " +
                     std::to_string(store.inputs(trial.id).value().size()) + " " +
                     std::to_string(store.decisions(trial.id).value().size());
    }
    return found;
}

TEST_CASE("shards are parts of a series without overlap, balanced over environments and controls") {
    SeriesDef def{.seeds = 5};
    const auto all = seriesTrials(def).value();
    CHECK(all.size() == 5 * studyEnvironments().size() * namedSchemes().size());
    std::set<std::string> seen;
    const auto key = [](const SeriesTrial& t) {
        return t.def.environment + t.def.scheme + std::to_string(t.def.seed) + t.setting;
    };
    def.shards = 3;
    for (def.shard = 0; def.shard < 3; ++def.shard) {
        const auto part = seriesTrials(def).value();
        for (const SeriesTrial& trial : part) CHECK(seen.insert(key(trial)).second);
    }
    CHECK(seen.size() == all.size());
    // The first seed comes before the second in all environments and controls.
    for (std::size_t i = 1; i < all.size(); ++i) CHECK(all[i - 1].def.seed <= all[i].def.seed);
}

TEST_CASE("words name settings, and what is unknown or out of range is refused") {
    CHECK(seriesSettings("default").value().size() == 1);
    CHECK(seriesSettings("hypercube").value().size() == static_cast<std::size_t>(kHypercubeDraws));
    CHECK(seriesSettings("one-at-a-time").value().size() == 2 * operatorConstants().size());
    CHECK_FALSE(seriesSettings("quickly").ok());
    const auto refused = [](auto change) {
        SeriesDef def;
        change(def);
        return !seriesTrials(def).ok();
    };
    CHECK(refused([](SeriesDef& def) { def.seeds = 0; }));
    CHECK(refused([](SeriesDef& def) { def.crowd = 0; }));
    CHECK(refused([](SeriesDef& def) { def.shard = 2, def.shards = 2; }));
    CHECK(refused([](SeriesDef& def) { def.environments = {"nowhere"}; }));
    CHECK(refused([](SeriesDef& def) { def.schemes = {"telepathy"}; }));
    CHECK(refused([](SeriesDef& def) { def.settings = {"key=9"}; }));
}

TEST_CASE("a small study of models: all trials end, are kept, and replay from their inputs") {
    const Folder folder;
    StudyStore store = opened(folder / "study.db");
    REQUIRE(runSeries(small(), store, "test", none).ok());
    const auto trials = store.trials().value();
    CHECK(trials.size() == 4);
    for (const StudyTrial& trial : trials) {
        INFO(trial.def.scheme, " ", trial.def.seed);
        CHECK(trial.result.done);
        CHECK(trial.result.collected == trial.result.items);
        CHECK(trial.state == RunState::Complete);
        const double perMinute = 60.0 * trial.result.gestures / trial.result.seconds;
        // A touch draws a whole way, or two; a mouse clicks on each point.
        CHECK(perMinute > (trial.def.scheme == "touch" ? 1.0 : 20.0));
        CHECK(perMinute < 110.0);
        CHECK_FALSE(store.decisions(trial.id).value().empty());
    }
    const auto inputs = store.inputs(trials[0].id).value();
    const auto again = replayTrial(trials[0].def, inputs);
    REQUIRE(again.ok());
    CHECK(again->result().hash == trials[0].result.hash);
    CHECK(store.runs().value().at(0).state == RunState::Complete);
}

TEST_CASE(
    "two shards in one file, or merged from two, hold what one series gives; it goes on where it ended") {
    const Folder folder;
    StudyStore whole = opened(folder / "whole.db");
    SeriesDef def = small();
    // Cut off after the first seed, then gone on with.
    def.seeds = 1;
    REQUIRE(runSeries(def, whole, "test", none).ok());
    def.seeds = 2;
    std::size_t first = 0;
    bool begun = false;
    REQUIRE(runSeries(def, whole, "test", [&](const SeriesProgress& now) {
                if (!begun) first = now.done;
                begun = true;
            }).ok());
    CHECK(first == 2);

    StudyStore shared = opened(folder / "shared.db");
    StudyStore one = opened(folder / "one.db");
    StudyStore two = opened(folder / "two.db");
    def.shards = 2;
    for (def.shard = 0; def.shard < 2; ++def.shard) {
        REQUIRE(runSeries(def, shared, "test", none).ok());
        REQUIRE(runSeries(def, def.shard == 0 ? one : two, "test", none).ok());
    }
    StudyStore merged = opened(folder / "merged.db");
    REQUIRE(mergeSeries(two, merged).ok());
    REQUIRE(mergeSeries(one, merged).ok());
    REQUIRE(mergeSeries(one, merged).ok());  // Nothing twice.
    const auto expected = contents(whole);
    CHECK(expected.size() == 5);
    for (StudyStore* store : {&shared, &merged}) {
        const auto found = contents(*store);
        CHECK(found.size() == expected.size());
        for (const auto& [key, value] : expected) {
            INFO(key);
            CHECK(found.count(key) == 1);
            if (found.count(key) == 1) CHECK(found.at(key) == value);
        }
    }
}

TEST_CASE("tuning seeds are never kept") {
    const Folder folder;
    StudyStore store = opened(folder / "study.db");
    SeriesDef def = small();
    def.tuning = true;
    CHECK_FALSE(runSeries(def, store, "test", none).ok());
    CHECK(store.trials().value().empty());
    for (const SeriesTrial& trial : seriesTrials(def).value()) CHECK(trial.def.seed >= kFirstTuningSeed);
}

}  // namespace
}  // namespace muster
