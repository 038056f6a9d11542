// The replay of an opened take, step by step.
#pragma once

#include <optional>

#include "muster/take.h"

namespace muster {

/// Gives a take's commands back to a world and compares its marks, in the order that replayTake() does.
class Replayer {
public:
    explicit Replayer(Take take) : take_(std::move(take)), steps_(take_.steps()) {}

    /// The take.
    const Take& take() const { return take_; }
    /// The world was begun anew.
    void restart() { nextCommand_ = 0, nextMark_ = 0; }
    /// True where the take goes no further.
    bool atEnd(const World& world) const { return world.stepCount() >= steps_; }
    /// Steps behind the last mark: replayed, compared with nothing.
    std::uint32_t unmarked() const { return steps_ - take_.markedSteps(); }
    /// Call before each step: submits what belongs to it. Fails as World::submit does.
    Status feed(World& world);
    /// Call after each step: fails with Corrupt where a mark differs.
    Status compare(World& world);

private:
    Take take_;
    std::uint32_t steps_;  // Of the take: counting them takes a while.
    std::size_t nextCommand_ = 0;
    std::size_t nextMark_ = 0;
};

}  // namespace muster
