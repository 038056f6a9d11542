#include "studio/study/runs/person_run.h"

#include <utility>

namespace muster {
namespace {

constexpr double kStoreEvery = 0.5;  // Between durable chunks of inputs [s].

Status misplaced(const char* what) {
    return invalidArgument(std::string(what) + " is not due now.");
}

}  // namespace

Result<PersonRun> PersonRun::begin(StudyStore& store, const PeopleSettings& settings, RunKind kind,
                                   const std::string& started, const std::string& version) {
    if (kind == RunKind::Models) return invalidArgument("A run with a person cannot be one of models.");
    StudyRun run;
    PeoplePlan plan;
    // Counted and added in one transaction, so that two that begin at once get different numbers.
    const Status status = store.batch([&]() -> Status {
        const auto runs = store.runs();
        if (!runs.ok()) return runs.status();
        std::int64_t number = 0;
        for (const StudyRun& other : runs.value()) number += other.kind == kind ? 1 : 0;
        auto planned = planPeople(settings, number);
        if (!planned.ok()) return planned.status();
        plan = std::move(planned).value();
        run.kind = kind;
        run.started = started;
        run.version = version;
        run.environments = kEnvironmentVersion;
        run.order = plan.order;
        run.note = "run number " + std::to_string(number);
        const auto id = store.addRun(run);
        if (!id.ok()) return id.status();
        run.id = id.value();
        return {};
    });
    if (!status.ok()) return status;
    return PersonRun(store, std::move(plan), std::move(run));
}

const Form* PersonRun::form() const {
    return stage_ == RunStage::Form ? &studyForms()[form_] : nullptr;
}

std::string PersonRun::formScheme() const {
    if (stage_ != RunStage::Form || !studyForms()[form_].perScheme) return {};
    return plan_.trials[next_ - 1].def.scheme;
}

const PlannedTrial* PersonRun::planned() const {
    return stage_ == RunStage::Ready || stage_ == RunStage::Trial ? &plan_.trials[next_] : nullptr;
}

Status PersonRun::answer(std::span<const StudyAnswer> answers) {
    if (stage_ != RunStage::Form) return misplaced("A questionnaire");
    const Form& form = studyForms()[form_];
    if (const Status status = checkForm(form, answers); !status.ok()) return status;
    for (const StudyAnswer& answer : answers)
        if (answer.scheme != formScheme())
            return invalidArgument("The answers are about '" + answer.scheme + "', not about '" +
                                   formScheme() + "'.");
    const bool last = form_ + 1 == studyForms().size();
    StudyRun ended = run_;
    ended.state = RunState::Complete;
    const Status status = store_->batch([&]() -> Status {
        if (const Status added = store_->addAnswers(run_.id, answers); !added.ok()) return added;
        return last ? store_->updateRun(ended) : Status();
    });
    if (!status.ok()) return status;
    if (last) run_ = std::move(ended);
    nextForm();
    return {};
}

void PersonRun::nextForm() {
    const auto forms = studyForms();
    const bool wasPerScheme = forms[form_].perScheme;
    ++form_;
    if (form_ == forms.size()) {
        stage_ = RunStage::Thanks;
    } else if (forms[form_].perScheme && !wasPerScheme) {
        stage_ = RunStage::Ready;  // Before the questions on a control come its trials.
    } else if (!forms[form_].perScheme && wasPerScheme && next_ < plan_.trials.size()) {
        stage_ = RunStage::Ready;
        while (forms[form_ - 1].perScheme) --form_;  // The same questions on the other control.
    }
}

Status PersonRun::start() {
    if (stage_ != RunStage::Ready) return misplaced("A trial");
    const PlannedTrial& planned = plan_.trials[next_];
    auto made = Trial::create(planned.def);
    if (!made.ok()) return made.status();
    StudyTrial stored;
    stored.run = run_.id;
    stored.def = planned.def;
    stored.practice = planned.practice;
    stored.period = planned.period;
    stored.position = planned.position;
    const auto id = store_->addTrial(stored);
    if (!id.ok()) return id.status();
    stored.id = id.value();
    stored_ = std::move(stored);
    trial_.emplace(std::move(made).value());
    storedInputs_ = 0;
    storedTime_ = 0.0;
    stage_ = RunStage::Trial;
    return storeInputs();
}

Status PersonRun::input(const InputEvent& event) {
    return stage_ == RunStage::Trial ? trial_->input(event) : misplaced("An input");
}

Status PersonRun::step() {
    if (stage_ != RunStage::Trial) return misplaced("A step");
    // A trial that is over, but whose result could not be stored, makes no more steps: storing is tried
    // again.
    const auto over = [this] {
        return trial_->over() || (stored_.practice && trial_->world().time() >= kPracticeMost);
    };
    if (!over()) trial_->step();
    if (over()) return endTrial(RunState::Complete);
    if (trial_->world().time() - storedTime_ < kStoreEvery) return {};
    return storeInputs();
}

Status PersonRun::storeInputs() {
    const Status status = store_->addInputs(stored_.id, trial_->inputs().subspan(storedInputs_));
    if (!status.ok()) return status;
    storedInputs_ = trial_->inputs().size();
    storedTime_ = trial_->world().time();
    return {};
}

Status PersonRun::endTrial(RunState state) {
    stored_.state = state;
    stored_.result = trial_->result();
    const Status status = store_->batch([&]() -> Status {
        const auto rest = trial_->inputs().subspan(storedInputs_);
        if (const Status inputs = store_->addInputs(stored_.id, rest); !inputs.ok()) return inputs;
        return store_->updateTrial(stored_);
    });
    if (!status.ok()) return status;
    trial_.reset();
    ++next_;
    const bool blockEnds = next_ == plan_.trials.size() || plan_.trials[next_].practice;
    stage_ = blockEnds ? RunStage::Form : RunStage::Ready;
    return {};
}

Status PersonRun::giveUp() {
    if (stage_ != RunStage::Trial) return misplaced("Giving up");
    if (!stored_.practice) return endTrial(RunState::BrokenOff);
    if (trial_->world().time() < kPracticeLeast)
        return invalidArgument("The practice can be ended after 30 seconds.");
    return endTrial(RunState::Complete);
}

Status PersonRun::breakOff() {
    if (stage_ == RunStage::Thanks || stage_ == RunStage::BrokenOff) return misplaced("Stopping");
    if (stage_ == RunStage::Trial)
        if (const Status status = endTrial(RunState::BrokenOff); !status.ok()) return status;
    StudyRun ended = run_;
    ended.state = RunState::BrokenOff;
    if (const Status status = store_->updateRun(ended); !status.ok()) return status;
    run_ = std::move(ended);
    stage_ = RunStage::BrokenOff;
    return {};
}

}  // namespace muster
