// How long the stages of a step take, for clients that watch them.
#pragma once

#include <array>
#include <cstdint>

#include "muster/session.h"
#include "muster/views.h"

namespace muster {

/// Sums the times of steps and makes a message of the means of every kWindow of them.
class StageMeans {
public:
    static constexpr std::uint32_t kWindow = 60;  ///< Steps that a message tells of.

    /// Adds the times of the last step of the world.
    void observe(const World& world);
    /// Drops what has been summed since the last message.
    void forget();
    /// Number of messages that have been made.
    std::uint32_t revision() const { return revision_; }
    /// The StageTimes message with that number; empty before the first.
    const MessageBytes& message() const { return message_; }

private:
    void make(std::uint32_t step);

    std::array<double, kStageCount> sums_{};  // By stage [ms].
    double total_ = 0.0;                      // Of whole steps [ms].
    std::uint32_t steps_ = 0;                 // Steps in these sums.
    std::uint32_t revision_ = 0;
    MessageBytes message_;
};

}  // namespace muster
