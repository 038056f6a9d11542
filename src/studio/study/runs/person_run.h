// One run with a person, from consent to thanks: without sockets, clocks and pictures.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "studio/study/runs/forms.h"
#include "studio/study/runs/run_plan.h"
#include "studio/study/store/store.h"

namespace muster {

/// Where a run stands.
enum class RunStage : std::uint8_t {
    Form,      ///< Questions wait for answers.
    Ready,     ///< The next trial, or practice, waits for the person.
    Trial,     ///< One goes on.
    Thanks,    ///< All is done.
    BrokenOff  ///< The person has stopped.
};

/// The state machine of a run. All that happens is in the store before a call returns, but for the inputs of
/// the last half second. Several runs share a file, each with its own worlds. Nothing runs by itself: whoever
/// hosts it makes steps, and none while nobody is connected, so a lost connection is a pause.
class PersonRun {
public:
    /// Practice can be ended after this time, and ends after `kPracticeMost` [s].
    static constexpr double kPracticeLeast = 30.0;
    /// Longest practice [s].
    static constexpr double kPracticeMost = 120.0;

    /// Begins a run of kind People or Test and stores it. Its number in the plan counts the runs of this kind
    /// before it. Fails where the settings make no sense, or the store does. The store must outlive it.
    static Result<PersonRun> begin(StudyStore& store, const PeopleSettings& settings, RunKind kind,
                                   const std::string& started, const std::string& version);

    /// Answers the form that waits, as a whole, and goes on. Fails, changing nothing, where it is not
    /// complete.
    Status answer(std::span<const StudyAnswer> answers);
    /// Begins the trial that waits.
    Status start();
    /// Takes an input of the trial that goes on.
    Status input(const InputEvent& event);
    /// Makes a step of it; stores inputs twice a second, and the result where it ends by this step.
    Status step();
    /// Gives the trial up: it is kept, marked as broken off, and the run goes on. Practice is ended only
    /// after `kPracticeLeast`.
    Status giveUp();
    /// Stops the run for good; what there is is kept.
    Status breakOff();

    RunStage stage() const { return stage_; }           ///< Where it stands.
    const StudyRun& run() const { return run_; }        ///< As it is stored.
    const PeoplePlan& plan() const { return plan_; }    ///< All its trials.
    const Form* form() const;                           ///< The form that waits; null for none.
    std::string formScheme() const;                     ///< Whom it is about; empty for none.
    const PlannedTrial* planned() const;                ///< The trial that waits or goes on, or null.
    const StudyTrial& last() const { return stored_; }  ///< The last trial that began, as it is stored.
    const Trial* trial() const { return trial_ ? &*trial_ : nullptr; }  ///< The one that goes on, or null.

private:
    PersonRun(StudyStore& store, PeoplePlan plan, StudyRun run)
        : store_(&store), plan_(std::move(plan)), run_(std::move(run)) {}
    void nextForm();
    Status storeInputs();
    Status endTrial(RunState state);

    StudyStore* store_;
    PeoplePlan plan_;
    StudyRun run_;
    RunStage stage_ = RunStage::Form;
    std::size_t form_ = 0;          // Index of the form that waits.
    std::size_t next_ = 0;          // Index of the trial that waits or goes on.
    StudyTrial stored_;             // It, as it is stored.
    std::size_t storedInputs_ = 0;  // How many of its inputs are.
    double storedTime_ = 0.0;       // When they were stored last [s].
    std::optional<Trial> trial_;
};

}  // namespace muster
