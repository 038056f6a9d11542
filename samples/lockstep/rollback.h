// A world whose inputs may come late: it goes on without them, and goes back where they change the past.
#pragma once

#include <muster/world.h>

#include <array>
#include <cstdint>

#include "bytes.h"
#include "datagram.h"

namespace lockstep {

inline constexpr std::uint32_t kPlayers = 2;
inline constexpr std::uint32_t kMostRollback = 8;  ///< Steps.
inline constexpr std::uint32_t kWindow = 64;       ///< Steps whose inputs and hashes are kept.

/// How often and how far it went back.
struct RollbackCounts {
    std::uint32_t rollbacks = 0;
    std::uint32_t longest = 0;   ///< Steps of the longest.
    std::uint32_t repeated = 0;  ///< Steps that were done again.
    std::uint32_t refused = 0;   ///< Commands that a final state could not carry out.
};

/// Steps a world with the inputs of all players. Where one is not there yet, it expects none.
class RollbackWorld {
public:
    explicit RollbackWorld(muster::World world);

    /// Takes the input of step known(player), early or late. False where that is too far ahead to be kept.
    bool give(std::uint32_t player, Input input);
    /// The inputs of that player are there for all steps below this one.
    std::uint32_t known(std::uint32_t player) const { return known_[player]; }

    /// True unless a step more could make a rollback longer than kMostRollback.
    bool mayStep() const { return now() < firstUnknown() + kMostRollback; }
    /// Goes back where a late input changes the past, and comes forward again to where it was.
    muster::Status correct();
    /// Advances by one step. Only where mayStep(), and after correct().
    muster::Status step();

    const muster::World& world() const { return world_; }
    std::uint32_t now() const { return world_.stepCount(); }
    /// The state after this many steps, and all before, will not change any more.
    std::uint32_t final() const;
    /// Hash of the state after `step` steps; only of the last kWindow states.
    std::uint64_t hash(std::uint32_t step) const { return hashes_[step % kWindow]; }
    const RollbackCounts& counts() const { return counts_; }

private:
    std::uint32_t firstUnknown() const;
    muster::Status advance();

    muster::World world_;
    std::array<std::uint32_t, kPlayers> known_{};
    std::array<std::array<Input, kPlayers>, kWindow> inputs_;  // By step modulo kWindow.
    std::array<Bytes, kMostRollback> states_;                  // Snapshots by step modulo kMostRollback.
    std::array<std::uint64_t, kWindow> hashes_{};
    std::array<std::uint32_t, kWindow> refusals_{};
    std::uint32_t counted_ = 0;  // Steps whose refusals are counted.
    std::uint32_t wrong_;        // The first step that was done without an input that was not empty.
    RollbackCounts counts_;
};

}  // namespace lockstep
