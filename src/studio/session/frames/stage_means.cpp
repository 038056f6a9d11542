#include "studio/session/frames/stage_means.h"

#include "muster/world.h"
#include "studio/session/inbox/protocol.h"

namespace muster {

void StageMeans::observe(const World& world) {
    const StageTimes times = world.stageTimes();
    for (std::size_t s = 0; s < kStageCount; ++s) sums_[s] += times.milliseconds[s];
    total_ += times.total;
    if (++steps_ == kWindow) make(world.stepCount());
}

void StageMeans::forget() {
    sums_.fill(0.0);
    total_ = 0.0;
    steps_ = 0;
}

void StageMeans::make(std::uint32_t step) {
    protocol::StageTimes message;
    message.step = step;
    message.total = static_cast<float>(total_ / kWindow);
    for (std::size_t s = 0; s < kStageCount; ++s) {
        const StageInfo& stage = stepStages()[s];
        message.stages.push_back(
            {std::string(stage.name), std::string(stage.about), static_cast<float>(sums_[s] / kWindow)});
    }
    message_ = protocol::encode(message);
    ++revision_;
    forget();
}

}  // namespace muster
