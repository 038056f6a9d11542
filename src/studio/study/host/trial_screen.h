// The picture of a trial's world for those who watch it, and what a page learns of a trial and of a form.
#pragma once

#include <string>
#include <vector>

#include "studio/session/frames/frame_sender.h"
#include "studio/session/inbox/protocol.h"
#include "studio/study/runs/forms.h"
#include "studio/study/runs/run_plan.h"
#include "studio/study/store/records.h"
#include "studio/study/trial/trial.h"

namespace muster {

/// Builds scenes, motions and frames of one trial after the other.
class TrialScreen {
public:
    /// Another trial begins.
    void begin(const Trial& trial);
    /// Call after every step.
    void observe(const Trial& trial, const std::vector<Attention>& attentions);
    /// Something else that a frame shows has changed.
    void touch() { ++state_; }
    /// It grows with all that a frame shows.
    std::uint64_t state() const { return state_; }
    /// Appends a frame for one client. `echo`: newest page clock among its inputs that the world shows.
    void send(const Trial& trial, bool playing, double speed, double echo, FrameSender& sender,
              std::vector<MessageBytes>& messages);

private:
    void refreshScene(const Trial& trial);

    WorldDef def_;
    FrameBuilder frames_;
    MotionFrames motion_;
    protocol::Frame frame_;
    std::uint64_t state_ = 0;
    std::uint64_t built_ = 0;  // State that `frame_` shows.
    std::uint32_t sceneRevision_ = 0;
    std::uint64_t signature_ = 0;
    MessageBytes scene_;
};

/// Fills in what a trial is of: environment, control, items, limit.
void describeTrial(const TrialDef& def, protocol::StudyState& state);
/// How a stored trial ended.
protocol::TrialEnd endOf(const StudyTrial& trial);
/// A form as a message; `scheme` is the control that it is about, or empty.
protocol::StudyForm formOf(const Form& form, const std::string& scheme);
/// The answers of a message, about that control.
std::vector<StudyAnswer> answersOf(const protocol::AnswerForm& message, const std::string& scheme);

}  // namespace muster
