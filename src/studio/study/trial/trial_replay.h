// A trial that runs again from its stored inputs, step by step.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/study/trial/trial.h"

namespace muster {

/// Feeds a trial with its inputs up to a step; its end may be earlier than that of the trial itself, where it
/// was given up.
class TrialReplay {
public:
    /// Begins at the start. `steps`: where it ends; 0 for the step of the last input. Fails as Trial::create
    /// does.
    static Result<TrialReplay> create(const TrialDef& def, std::vector<StampedInput> inputs,
                                      std::uint32_t steps);

    /// Makes a step. Fails where a stored input is malformed.
    Status step();
    /// Goes back to the start.
    Status restart();
    bool atEnd() const { return trial_.world().stepCount() >= steps_; }  ///< No step is left.
    std::uint32_t steps() const { return steps_; }                       ///< All steps.
    const Trial& trial() const { return trial_; }                        ///< The trial.
    /// Where fingers and buttons are down now [m].
    const std::vector<Vec2>& pointers() const { return shown_; }

private:
    TrialReplay(Trial trial, std::vector<StampedInput> inputs, std::uint32_t steps)
        : trial_(std::move(trial)), inputs_(std::move(inputs)), steps_(steps) {}
    void follow(const InputEvent& event);

    struct Pointer {
        std::uint32_t pointer = 0;
        Vec2 ground;  // [m]
    };
    Trial trial_;
    std::vector<StampedInput> inputs_;
    std::uint32_t steps_ = 0;
    std::size_t next_ = 0;  // The input that comes next.
    GroundView view_;
    std::vector<Pointer> down_;
    std::vector<Vec2> shown_;
};

}  // namespace muster
