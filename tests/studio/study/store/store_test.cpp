#include "studio/study/store/store.h"

#include <doctest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <limits>
#include <thread>

#include "temporary_folder.h"

using namespace muster;

namespace {

/// A path of its own, in a folder of its own.
struct TemporaryFile : testing::TemporaryFolder {
    explicit TemporaryFile(const std::string& name) : TemporaryFolder("store_" + name) {}
    const std::string path = *this / "study.db";
};

StudyStore opened(const std::string& path, StoreMode mode = StoreMode::Create) {
    auto store = StudyStore::open(path, mode);
    INFO(store.status().message());
    REQUIRE(store.ok());
    return std::move(store).value();
}

StudyTrial trialOf(std::int64_t run) {
    return {.run = run,
            .def = {"corridor", 36, "touch", 0xFFFFFFFFFFFFFFF1ull, true},
            .setting = "draw 17",
            .practice = true,
            .period = 2,
            .position = 3,
            .state = RunState::Complete,
            .result = {true, 1234, 20.5, 24, 23, 7, 9, 1.25, 0x00FEDCBA98765432ull},
            .misses = 4,
            .operatorSeconds = 12.125};
}

std::vector<StampedInput> inputsOf(std::uint32_t from, int count) {
    std::vector<StampedInput> inputs(static_cast<std::size_t>(count));
    for (int i = 0; i < count; ++i)
        inputs[static_cast<std::size_t>(i)].step = from + static_cast<std::uint32_t>(i);
    return inputs;
}

std::string contentOf(const std::string& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

}  // namespace

TEST_CASE("All that is written is read back, also after closing") {
    const TemporaryFile file("back");
    std::int64_t run = 0;
    std::int64_t trial = 0;
    {
        StudyStore store = opened(file.path);
        StudyRun def{.kind = RunKind::People,
                     .started = "2026-11-24T06:00:00Z",
                     .version = "0.1.0",
                     .environments = 3,
                     .order = 5,
                     .note = "quote ' and \"; DROP TABLE runs; --"};
        run = *store.addRun(def);
        trial = *store.addTrial(trialOf(run));
        REQUIRE(store.addInputs(trial, inputsOf(0, 3)).ok());
        REQUIRE(store.addInputs(trial, {}).ok());
        REQUIRE(store.addInputs(trial, inputsOf(3, 2)).ok());
        const std::vector<StudyDecision> decisions{{7, "plan", 1.2, "nearest"}, {9, "look", 0.3, ""}};
        REQUIRE(store.addDecisions(trial, decisions).ok());
        const std::vector<StudyAnswer> answers{
            {"touch", "sus", "sus-1", "4", 4.0},
            {"", "before", "hand", "left", std::numeric_limits<double>::quiet_NaN()}};
        REQUIRE(store.addAnswers(run, answers).ok());
        def.id = run;
        def.state = RunState::BrokenOff;
        REQUIRE(store.updateRun(def).ok());
    }
    StudyStore store = opened(file.path, StoreMode::Existing);
    const auto runs = store.runs();
    REQUIRE(runs->size() == 1);
    CHECK(runs->front().kind == RunKind::People);
    CHECK(runs->front().state == RunState::BrokenOff);
    CHECK(runs->front().note == "quote ' and \"; DROP TABLE runs; --");
    CHECK(runs->front().order == 5);
    const auto trials = store.trials();
    REQUIRE(trials->size() == 1);
    const StudyTrial& back = trials->front();
    CHECK(back.def.seed == 0xFFFFFFFFFFFFFFF1ull);
    CHECK(back.def.mirrored);
    CHECK(back.practice);
    CHECK(back.setting == "draw 17");
    CHECK(back.result.hash == 0x00FEDCBA98765432ull);
    CHECK(back.result.seconds == 20.5);
    CHECK(back.result.idleSeconds == 1.25);
    CHECK(back.misses == 4);
    CHECK(back.operatorSeconds == 12.125);
    const auto inputs = store.inputs(trial);
    REQUIRE(inputs->size() == 5);
    for (std::uint32_t i = 0; i < 5; ++i) CHECK((*inputs)[i].step == i);
    CHECK(store.decisions(trial)->at(1).kind == "look");
    const auto answers = store.answers(run);
    REQUIRE(answers->size() == 2);
    CHECK(answers->at(0).number == 4.0);
    CHECK(std::isnan(answers->at(1).number));
}

TEST_CASE("A complete trial is found by its key, and by no other") {
    const TemporaryFile file("key");
    StudyStore store = opened(file.path);
    StudyRun run{.environments = 1, .operators = 2};
    StudyTrial trial = trialOf(*store.addRun(run));
    trial.state = RunState::Running;
    trial.id = *store.addTrial(trial);
    TrialKey key{RunKind::Models, 1, 2, trial.def, trial.setting};
    CHECK_FALSE(*store.hasTrial(key));
    trial.state = RunState::Complete;
    REQUIRE(store.updateTrial(trial).ok());
    CHECK(*store.hasTrial(key));
    for (const int change : {0, 1, 2, 3, 4}) {
        TrialKey other = key;
        if (change == 0) other.kind = RunKind::Test;
        if (change == 1) other.operators = 3;
        if (change == 2) other.def.seed = 1;
        if (change == 3) other.setting = "default";
        if (change == 4) other.def.crowd = 16;
        CHECK_FALSE(*store.hasTrial(other));
    }
}

TEST_CASE("What refers to nothing is refused, and a batch that fails leaves nothing") {
    const TemporaryFile file("refer");
    StudyStore store = opened(file.path);
    CHECK_FALSE(store.addTrial(trialOf(99)).ok());
    CHECK_FALSE(store.addInputs(99, inputsOf(0, 1)).ok());
    CHECK(store.updateTrial(trialOf(1)).code() == StatusCode::NotFound);
    const Status status = store.batch([&]() -> Status {
        const auto run = store.addRun({});
        if (!run.ok()) return run.status();
        return store.addTrial(trialOf(*run + 1)).status();
    });
    CHECK_FALSE(status.ok());
    CHECK(store.runs()->empty());
    CHECK(store.addRun({}).ok());  // It goes on.
}

TEST_CASE("Files that the study did not make are refused and stay as they are") {
    const TemporaryFile file("other");
    CHECK_FALSE(StudyStore::open(file.path, StoreMode::Existing).ok());
    CHECK_FALSE(std::filesystem::exists(file.path));
    CHECK_FALSE(StudyStore::open("/nowhere/at/all.db", StoreMode::Create).ok());
    const std::string text = "This is a letter and no database, and it is long enough to be looked at. ";
    std::ofstream(file.path) << text + text;
    const auto letter = StudyStore::open(file.path, StoreMode::Create);
    REQUIRE_FALSE(letter.ok());
    CHECK(letter.status().message().find("not a database of the study") != std::string::npos);
    CHECK(contentOf(file.path) == text + text);
}

TEST_CASE("A damaged file gives a sentence") {
    const TemporaryFile file("damaged");
    {
        StudyStore store = opened(file.path);
        StudyTrial trial = trialOf(*store.addRun({}));
        for (int i = 0; i < 200; ++i) REQUIRE(store.addTrial(trial).ok());
    }
    std::string bytes = contentOf(file.path);
    REQUIRE(bytes.size() > 8192);
    for (std::size_t at = 4096; at < bytes.size(); at += 3) bytes[at] = 'x';
    std::ofstream(file.path, std::ios::binary) << bytes;
    auto store = StudyStore::open(file.path, StoreMode::Existing);
    if (store.ok()) {
        const auto trials = store->trials();
        REQUIRE_FALSE(trials.ok());
        CHECK_FALSE(trials.status().message().empty());
    }
}

TEST_CASE("Two that write at once do not mix and do not fail") {
    const TemporaryFile file("two");
    std::vector<Status> statuses(2);
    const auto write = [&](std::size_t index) {
        auto store = StudyStore::open(file.path, StoreMode::Create);
        if (!store.ok()) return store.status();
        StudyRun run{.note = std::to_string(index)};
        const auto id = store->addRun(run);
        if (!id.ok()) return id.status();
        for (int i = 0; i < 40; ++i) {
            StudyTrial trial = trialOf(*id);
            trial.def.seed = index;
            const auto added = store->addTrial(trial);
            if (!added.ok()) return added.status();
            if (Status s = store->addInputs(*added, inputsOf(static_cast<std::uint32_t>(index), 2)); !s.ok())
                return s;
        }
        return Status();
    };
    std::thread other([&] { statuses[1] = write(1); });
    statuses[0] = write(0);
    other.join();
    for (const Status& status : statuses) {
        INFO(status.message());
        CHECK(status.ok());
    }
    StudyStore store = opened(file.path, StoreMode::Existing);
    const auto runs = store.runs();
    REQUIRE(runs->size() == 2);
    for (const StudyRun& run : *runs) {
        const auto trials = store.trials(run.id);
        CHECK(trials->size() == 40);
        for (const StudyTrial& trial : *trials) {
            CHECK(std::to_string(trial.def.seed) == run.note);
            CHECK(store.inputs(trial.id)->front().step == trial.def.seed);
        }
    }
}
