#include "studio/study/host/hosted_run.h"

#include <algorithm>
#include <utility>

#include "studio/session/inbox/chosen_scheme.h"
#include "studio/study/host/trial_screen.h"

namespace muster {
namespace {

constexpr double kInputsPerSecond = 2000;  // Of one page, on average, and the largest number at once.

}  // namespace

HostedRun::HostedRun(PersonRun run, std::string token)
    : run_(std::move(run)), token_(std::move(token)), bucket_(kInputsPerSecond, kInputsPerSecond) {}

// ---- The page ----

void HostedRun::attach() {
    attached_ = true;
    sender_ = FrameSender();
    sentState_ = 0;
    sentMarks_.clear();
    stateStale_ = true;
    clock_ = TouchClock();
    clock_.restart();
    pacer_.reset();
    echo_ = echoWaiting_ = 0.0;
    view_.reset();
}

void HostedRun::detach() {
    attached_ = false;
    attention_ = {};
    if (run_.stage() != RunStage::Trial) return;
    liftAll();
    paused_ = true;
    screen_.touch();
}

void HostedRun::liftAll() {
    const std::vector<PointerEvent> down = std::move(down_);
    down_.clear();
    for (PointerEvent event : down) {
        event.phase = PointerPhase::Cancel;
        event.time = run_.trial()->world().time();
        (void)run_.input(event);  // It was a sound event when it came.
    }
}

protocol::StudyState HostedRun::state() const {
    using protocol::StudyStage;
    constexpr StudyStage kStages[] = {StudyStage::Form, StudyStage::Ready, StudyStage::Trial,
                                      StudyStage::Thanks, StudyStage::BrokenOff};
    protocol::StudyState message;
    message.stage = kStages[static_cast<std::size_t>(run_.stage())];
    if (message.stage == StudyStage::Trial && paused_) message.stage = StudyStage::Paused;
    message.token = token_;
    message.run = static_cast<std::uint32_t>(run_.run().id);
    message.test = run_.run().kind == RunKind::Test;
    message.mmPerPixel = mmPerPixel_;
    message.trials = static_cast<std::uint32_t>(run_.plan().trials.size());
    if (const PlannedTrial* planned = run_.planned()) {
        describeTrial(planned->def, message);
        message.practice = planned->practice;
        message.trial = static_cast<std::uint32_t>(planned - run_.plan().trials.data()) + 1;
        if (planned->practice) {
            message.least = PersonRun::kPracticeLeast;
            message.limit = PersonRun::kPracticeMost;
        }
    }
    const StudyTrial& last = run_.last();
    const bool ended = run_.stage() != RunStage::Trial && last.id != 0;
    if (ended) {
        message.ended = endOf(last);
        message.seconds = last.result.seconds;
        message.collected = static_cast<std::uint32_t>(last.result.collected);
    }
    return message;
}

void HostedRun::outgoing(std::vector<MessageBytes>& messages) {
    if (stateStale_) {
        messages.push_back(protocol::encode(state()));
        if (const Form* form = run_.form())
            messages.push_back(protocol::encode(formOf(*form, run_.formScheme())));
        stateStale_ = false;
    }
    const Trial* trial = run_.trial();
    if (trial == nullptr) return;
    const MessageBytes marks = protocol::encode(marksOf(trial->def().scheme, trial->scheme().marks()));
    if (marks != sentMarks_) {
        messages.push_back(marks);
        sentMarks_ = marks;
    }
    if (sender_.waits() || sentState_ == screen_.state()) return;
    screen_.send(*trial, plays(), 1.0, echo_, sender_, messages);
    sentState_ = screen_.state();
}

// ---- What the person does ----

Status HostedRun::answer(const protocol::AnswerForm& message) {
    const Status status = run_.answer(answersOf(message, run_.formScheme()));
    if (!status.ok()) return status;
    keepDisplay(message);
    stateStale_ = true;
    return {};
}

// The size of a pixel is asked for once; views of trials need it.
void HostedRun::keepDisplay(const protocol::AnswerForm& message) {
    for (const protocol::AnswerFrame& answer : message.answers)
        if (message.instrument == "before" && answer.name == "mm-per-pixel") mmPerPixel_ = answer.number;
}

Status HostedRun::act(protocol::StudyAct act) {
    Status status;
    switch (act) {
        case protocol::StudyAct::Start:
            status = run_.start();
            if (!status.ok()) return status;
            down_.clear();
            paused_ = false;
            clock_.restart();
            screen_.begin(*run_.trial());
            sender_.restart();
            if (view_) status = run_.input(*view_);
            break;
        case protocol::StudyAct::GoOn:
            if (!paused_ || run_.stage() != RunStage::Trial)
                return invalidArgument("nothing is paused that could go on");
            paused_ = false;
            screen_.touch();
            break;
        case protocol::StudyAct::GiveUp:
            status = run_.giveUp();
            break;
        case protocol::StudyAct::BreakOff:
            status = run_.breakOff();
            break;
    }
    if (!status.ok()) return status;
    pacer_.reset();
    stateStale_ = true;
    return {};
}

Status HostedRun::breakOff() {
    return over() ? Status() : run_.breakOff();
}

Status HostedRun::setView(const protocol::SetView& message) {
    const auto view = groundViewOf(message);
    if (!view.ok()) return view.status();
    view_ = view.value();
    return run_.stage() == RunStage::Trial ? run_.input(*view_) : Status();
}

Status HostedRun::inputs(const protocol::Inputs& message, const SessionLimits& limits) {
    // Inputs that were on their way when a trial ended, or the page was lost, belong to nothing.
    if (!plays()) return {};
    if (Status status = checkInputs(message, limits); !status.ok()) return status;
    if (!view_) return invalidArgument("found inputs, expected a view of the ground before them");
    if (!bucket_.take(realTime_, static_cast<double>(message.events.size())))
        return {StatusCode::LimitExceeded,
                "more than " + std::to_string(static_cast<int>(kInputsPerSecond)) + " inputs a second"};
    for (const protocol::RawInput& raw : message.events) {
        const double time = clock_.stamp(raw.time, realTime_, run_.trial()->world().time(), 1.0);
        if (Status status = giveInput(inputOf(raw, time)); !status.ok()) return status;
        echoWaiting_ = std::max(echoWaiting_, raw.time);
    }
    inputsWait_ = true;
    return {};
}

Status HostedRun::giveInput(const InputEvent& event) {
    if (Status status = run_.input(event); !status.ok()) return status;
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer == nullptr) return {};
    std::erase_if(down_, [&](const PointerEvent& one) { return one.pointer == pointer->pointer; });
    if (pointer->phase == PointerPhase::Down || pointer->phase == PointerPhase::Move)
        down_.push_back(*pointer);
    return {};
}

// ---- Time ----

void HostedRun::elapse(double seconds) {
    realTime_ += seconds;
    if (plays()) pacer_.elapse(seconds, 1.0, run_.trial()->world().parameters().stepTime);
}

bool HostedRun::stepDue() const {
    return plays() && pacer_.due(run_.trial()->world().parameters().stepTime, inputsWait_);
}

double HostedRun::untilNextStep() const {
    if (!plays()) return kLongWait;
    return pacer_.until(1.0, run_.trial()->world().parameters().stepTime, inputsWait_);
}

Status HostedRun::step() {
    pacer_.pay(run_.trial()->world().parameters().stepTime);
    inputsWait_ = false;
    const Status status = run_.step();
    echo_ = std::max(echo_, echoWaiting_);
    if (run_.trial() != nullptr) {
        screen_.observe(*run_.trial(), {attention_});
    } else {
        stateStale_ = true;
        pacer_.reset();
    }
    return status;
}

}  // namespace muster
