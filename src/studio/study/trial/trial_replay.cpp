#include "studio/study/trial/trial_replay.h"

#include <algorithm>
#include <utility>

namespace muster {

Result<TrialReplay> TrialReplay::create(const TrialDef& def, std::vector<StampedInput> inputs,
                                        std::uint32_t steps) {
    auto trial = Trial::create(def);
    if (!trial.ok()) return trial.status();
    if (steps == 0 && !inputs.empty()) steps = inputs.back().step;
    return TrialReplay(std::move(trial).value(), std::move(inputs), steps);
}

Status TrialReplay::restart() {
    auto trial = Trial::create(trial_.def());
    if (!trial.ok()) return trial.status();
    trial_ = std::move(trial).value();
    next_ = 0;
    view_ = trial_.view();
    down_.clear();
    shown_.clear();
    return {};
}

Status TrialReplay::step() {
    for (; next_ < inputs_.size() && inputs_[next_].step <= trial_.world().stepCount(); ++next_) {
        const InputEvent& event = inputs_[next_].event;
        // A new trial begins with its view.
        const auto* view = std::get_if<GroundView>(&event);
        if (next_ == 0 && view != nullptr && *view == trial_.view()) {
            view_ = *view;
            continue;
        }
        if (Status status = trial_.input(event); !status.ok()) return status;
        follow(event);
    }
    trial_.step();
    return {};
}

void TrialReplay::follow(const InputEvent& event) {
    if (const auto* view = std::get_if<GroundView>(&event)) view_ = *view;
    const auto* pointer = std::get_if<PointerEvent>(&event);
    if (pointer == nullptr) return;
    std::erase_if(down_, [&](const Pointer& one) { return one.pointer == pointer->pointer; });
    const auto ground = view_.groundAt(pointer->screen);
    const bool down = pointer->phase == PointerPhase::Down || pointer->phase == PointerPhase::Move;
    if (down && ground) down_.push_back({pointer->pointer, *ground});
    shown_.clear();
    for (const Pointer& one : down_) shown_.push_back(one.ground);
}

}  // namespace muster
