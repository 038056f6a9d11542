#include "rollback.h"

#include <algorithm>

namespace lockstep {
namespace {

constexpr std::uint32_t kNever = ~0u;

}  // namespace

RollbackWorld::RollbackWorld(muster::World world) : world_(std::move(world)), wrong_(kNever) {
    hashes_[0] = world_.hash();
}

std::uint32_t RollbackWorld::firstUnknown() const {
    return *std::min_element(known_.begin(), known_.end());
}

std::uint32_t RollbackWorld::final() const {
    return std::min({firstUnknown(), now(), wrong_});
}

bool RollbackWorld::give(std::uint32_t player, Input input) {
    const std::uint32_t step = known_[player];
    // The slot of this step is free once no rollback reaches the step that used it before.
    if (step >= final() + kWindow) return false;
    if (step < now() && !input.empty()) wrong_ = std::min(wrong_, step);
    inputs_[step % kWindow][player] = std::move(input);
    ++known_[player];
    return true;
}

muster::Status RollbackWorld::advance() {
    const std::uint32_t step = now();
    // Nobody goes back to a state whose inputs are all there.
    if (step >= firstUnknown()) states_[step % kMostRollback] = world_.snapshot();
    for (std::uint32_t player = 0; player < kPlayers; ++player) {
        if (step >= known_[player]) continue;
        for (const muster::Command& command : inputs_[step % kWindow][player])
            if (muster::Status status = world_.submit(command); !status.ok()) return status;
    }
    world_.step();
    hashes_[now() % kWindow] = world_.hash();
    refusals_[step % kWindow] = static_cast<std::uint32_t>(world_.rejections().size());
    return {};
}

muster::Status RollbackWorld::correct() {
    if (wrong_ != kNever) {
        const std::uint32_t then = now();
        ++counts_.rollbacks;
        counts_.longest = std::max(counts_.longest, then - wrong_);
        counts_.repeated += then - wrong_;
        if (muster::Status status = world_.rewind(states_[wrong_ % kMostRollback]); !status.ok())
            return status;
        wrong_ = kNever;
        while (now() < then)
            if (muster::Status status = advance(); !status.ok()) return status;
    }
    for (; counted_ < final(); ++counted_) counts_.refused += refusals_[counted_ % kWindow];
    return {};
}

muster::Status RollbackWorld::step() {
    return advance();
}

}  // namespace lockstep
