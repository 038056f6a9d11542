// One run with a person and the page that shows it: messages in, messages out.
#pragma once

#include <optional>
#include <string>
#include <vector>

#include "base/token_bucket.h"
#include "studio/session/inbox/pacer.h"
#include "studio/session/inbox/touch_clock.h"
#include "studio/study/host/trial_screen.h"
#include "studio/study/runs/person_run.h"

namespace muster {

/// Hosts a run: drives its trial in real time while a page is connected and the person goes on. A page that
/// is lost lifts all fingers and pauses the trial.
class HostedRun {
public:
    /// `token`: by which a page comes back to the run.
    HostedRun(PersonRun run, std::string token);

    /// A page shows the run from now on; it knows nothing yet.
    void attach();
    /// The page is lost.
    void detach();
    bool attached() const { return attached_; }          ///< A page shows it.
    const std::string& token() const { return token_; }  ///< By which a page comes back.
    const PersonRun& run() const { return run_; }        ///< The run.
    /// Nothing more can happen.
    bool over() const { return run_.stage() == RunStage::Thanks || run_.stage() == RunStage::BrokenOff; }

    // Messages of the page. Each fails, changing nothing, where it is malformed or not due.
    Status answer(const protocol::AnswerForm& message);
    Status act(protocol::StudyAct act);
    Status inputs(const protocol::Inputs& message, const SessionLimits& limits);
    Status setView(const protocol::SetView& message);
    Status acknowledge(std::uint32_t frame) { return sender_.acknowledge(frame); }
    void attend(const Attention& attention) { attention_ = attention; }
    /// Ends the run for good, where it is not over.
    Status breakOff();

    /// Real time passes [s].
    void elapse(double seconds);
    /// True where a step is due.
    bool stepDue() const;
    /// Real time until a step is due [s].
    double untilNextStep() const;
    /// Makes a step. Fails where it could not be stored; the run then stays where it is.
    Status step();
    /// Appends what the page does not know yet.
    void outgoing(std::vector<MessageBytes>& messages);

private:
    bool plays() const { return attached_ && !paused_ && run_.stage() == RunStage::Trial; }
    protocol::StudyState state() const;
    Status giveInput(const InputEvent& event);
    void liftAll();
    void keepDisplay(const protocol::AnswerForm& message);

    PersonRun run_;
    std::string token_;
    bool attached_ = false;
    bool paused_ = false;  // The trial waits for the person, after the page was lost.
    double mmPerPixel_ = 0.0;
    std::optional<GroundView> view_;  // How the page sees the ground.

    double realTime_ = 0.0;
    Pacer pacer_;
    bool inputsWait_ = false;
    TouchClock clock_;
    TokenBucket bucket_;
    std::vector<PointerEvent> down_;  // The last event of every pointer that is down.
    double echoWaiting_ = 0.0;        // Newest page time among inputs that wait for a step [s].
    double echo_ = 0.0;               // The same, of those that a step has applied [s].

    TrialScreen screen_;
    FrameSender sender_;
    Attention attention_;
    std::uint64_t sentState_ = 0;  // State of the screen that the last frame showed.
    bool stateStale_ = true;       // The page does not know where the run stands.
    MessageBytes sentMarks_;
};

}  // namespace muster
