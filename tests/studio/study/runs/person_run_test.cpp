#include "studio/study/runs/person_run.h"

#include <doctest.h>

#include "temporary_folder.h"

namespace muster {
namespace {

/// A database of its own, removed at the end.
struct Base : testing::TemporaryFolder {
    explicit Base(const std::string& name) : TemporaryFolder("people_" + name) {}
    StudyStore open() const {
        auto store = StudyStore::open(*this / "study.db", StoreMode::Create);
        INFO(store.status().message());
        REQUIRE(store.ok());
        return std::move(store).value();
    }
};

PersonRun beginOf(StudyStore& store, RunKind kind = RunKind::Test) {
    auto run = PersonRun::begin(store, {"mouse-full-free", 16}, kind, "2026-11-24T06:00:00Z", "1.0.0");
    INFO(run.status().message());
    REQUIRE(run.ok());
    return std::move(run).value();
}

void answerForm(PersonRun& run) {
    std::vector<StudyAnswer> answers;
    for (const Question& question : run.form()->questions) {
        StudyAnswer answer{run.formScheme(), std::string(run.form()->instrument), std::string(question.name),
                           "", question.low};
        if (!question.choices.empty()) answer.text = question.choices[0];
        answers.push_back(answer);
    }
    const Status status = run.answer(answers);
    INFO(status.message());
    REQUIRE(status.ok());
}

void steps(PersonRun& run, int count) {
    for (int i = 0; i < count && run.stage() == RunStage::Trial; ++i) REQUIRE(run.step().ok());
}

/// Drags from the middle of the crowd towards the middle of the ground or to the right, by finger or mouse.
void drag(PersonRun& run) {
    const TrialDef def = run.planned()->def;
    const Vec2 start = studyEnvironment(def.environment).value().start;
    const Vec2
        from = run.trial()->view().screenOf({start.x, def.mirrored ? -start.y : start.y}).value_or(Vec2{});
    const double way = start.x > 0.0 ? -10.0 : 10.0;
    const auto device = def.scheme == "touch" ? PointerDevice::Touch : PointerDevice::Mouse;
    for (int i = 0; i <= 30; ++i) {
        const PointerPhase phase = i == 0    ? PointerPhase::Down
                                   : i == 30 ? PointerPhase::Up
                                             : PointerPhase::Move;
        PointerEvent event{
            phase, device, PointerButton::Left, 1, {from.x + way * i, from.y}, run.trial()->world().time(),
            {}};
        if (device == PointerDevice::Mouse && i < 30) event.button = PointerButton::Right;
        REQUIRE(run.input(event).ok());
        steps(run, 2);
    }
}

TEST_CASE("a run goes from consent to thanks, and is stored whole") {
    const Base base("whole");
    StudyStore store = base.open();
    PersonRun run = beginOf(store);
    std::vector<std::string> seen;
    while (run.stage() != RunStage::Thanks) {
        if (run.stage() == RunStage::Form) {
            seen.push_back(std::string(run.form()->instrument) + run.formScheme());
            answerForm(run);
        } else {
            const bool practice = run.planned()->practice;
            seen.push_back(practice ? "practice" : "trial");
            REQUIRE(run.start().ok());
            drag(run);
            if (practice) {
                CHECK(!run.giveUp().ok());
                while (run.trial()->world().time() < PersonRun::kPracticeLeast) steps(run, 1);
            }
            REQUIRE(run.giveUp().ok());
        }
    }
    const std::string mouse = "mouse-full-free";
    CHECK(seen == std::vector<std::string>{"consent",       "before",        "practice",    "trial",
                                           "trial",         "trial",         "trial",       "papertouch",
                                           "sustouch",      "tlxtouch",      "ueq-stouch",  "borgtouch",
                                           "practice",      "trial",         "trial",       "trial",
                                           "trial",         "paper" + mouse, "sus" + mouse, "tlx" + mouse,
                                           "ueq-s" + mouse, "borg" + mouse,  "preference"});
    const auto runs = store.runs();
    REQUIRE(runs.ok());
    CHECK(runs.value()[0].state == RunState::Complete);
    CHECK(runs.value()[0].kind == RunKind::Test);
    CHECK(store.answers(run.run().id).value().size() == 1 + 6 + 2 * (5 + 10 + 6 + 8 + 1) + 2);
    const auto trials = store.trials(run.run().id);
    REQUIRE(trials.ok());
    CHECK(trials.value().size() == 10);
}

TEST_CASE("stored inputs give the same trial again, bit for bit") {
    const Base base("replay");
    StudyStore store = base.open();
    PersonRun run = beginOf(store);
    answerForm(run);
    answerForm(run);
    REQUIRE(run.start().ok());
    drag(run);
    while (run.stage() == RunStage::Trial) steps(run, 1);  // The practice ends by itself.
    REQUIRE(run.stage() == RunStage::Ready);
    REQUIRE(run.start().ok());
    drag(run);
    while (run.stage() == RunStage::Trial) steps(run, 1);
    const StudyTrial trial = store.trials(run.run().id).value()[1];
    CHECK(trial.state == RunState::Complete);
    CHECK(trial.result.commands > 0);
    const auto inputs = store.inputs(trial.id);
    REQUIRE(inputs.ok());
    const auto again = replayTrial(trial.def, inputs.value());
    REQUIRE(again.ok());
    CHECK(again.value().result().hash == trial.result.hash);
    CHECK(again.value().result().steps == trial.result.steps);
    CHECK(again.value().result().collected == trial.result.collected);
    const auto without = replayTrial(trial.def, {});
    REQUIRE(without.ok());
    CHECK(without.value().result().hash != trial.result.hash);
}

TEST_CASE("inputs are in the file twice a second; a broken-off run is kept and marked") {
    const Base base("broken");
    StudyStore store = base.open();
    PersonRun run = beginOf(store);
    answerForm(run);
    answerForm(run);
    REQUIRE(run.start().ok());
    drag(run);
    {
        StudyStore other = base.open();
        const StudyTrial trial = other.trials(run.run().id).value()[0];
        CHECK(trial.state == RunState::Running);
        CHECK(other.inputs(trial.id).value().size() + 31 > run.trial()->inputs().size());
    }
    const std::size_t count = run.trial()->inputs().size();
    REQUIRE(run.breakOff().ok());
    CHECK(run.stage() == RunStage::BrokenOff);
    CHECK(!run.breakOff().ok());
    CHECK(!run.start().ok());
    CHECK(store.runs().value()[0].state == RunState::BrokenOff);
    const StudyTrial trial = store.trials(run.run().id).value()[0];
    CHECK(trial.state == RunState::BrokenOff);
    CHECK(store.inputs(trial.id).value().size() == count);
}

TEST_CASE("two runs at once do not mix, and tests do not shift the orders of people") {
    const Base base("two");
    StudyStore first = base.open();
    StudyStore second = base.open();
    PersonRun test = beginOf(first, RunKind::Test);
    PersonRun one = beginOf(first, RunKind::People);
    PersonRun two = beginOf(second, RunKind::People);
    CHECK(test.run().order == 0);
    CHECK(one.run().order == 0);
    CHECK(two.run().order == 1);
    for (PersonRun* run : {&one, &two}) {
        answerForm(*run);
        answerForm(*run);
        REQUIRE(run->start().ok());
    }
    drag(one);
    CHECK(two.trial()->world().stepCount() == 0);
    CHECK(two.trial()->inputs().size() == 1);
    REQUIRE(two.breakOff().ok());
    CHECK(one.stage() == RunStage::Trial);
    CHECK(first.runs().value()[1].state == RunState::Running);
    CHECK(first.trials(one.run().id).value().size() == 1);
}

TEST_CASE("what is not due is refused and changes nothing") {
    const Base base("due");
    StudyStore store = base.open();
    PersonRun run = beginOf(store);
    CHECK(!run.start().ok());
    CHECK(!run.step().ok());
    CHECK(!run.giveUp().ok());
    CHECK(!run.input(PointerEvent{}).ok());
    CHECK(!run.answer({}).ok());
    CHECK(run.form()->instrument == "consent");
    CHECK(store.answers(run.run().id).value().empty());
    CHECK(!PersonRun::begin(store, {}, RunKind::Models, "", "").ok());
    CHECK(!PersonRun::begin(store, {"touch", 36}, RunKind::People, "", "").ok());
    CHECK(store.runs().value().size() == 1);
}

}  // namespace
}  // namespace muster
