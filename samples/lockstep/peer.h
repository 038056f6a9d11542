// One of two players: decides when to step, what to send, and what to make of what comes. It knows no clock
// and no network: whoever owns it carries its datagrams.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>

#include "datagram.h"
#include "rollback.h"

namespace lockstep {

inline constexpr std::uint32_t kInputDelay = 6;  ///< Steps from a player's decision to its effect.

/// What a peer has met with so far.
struct PeerCounts {
    std::uint32_t stalls = 0;    ///< Ticks without a step, as the other's inputs were too late.
    std::uint32_t waits = 0;     ///< Ticks without a step, as the other was behind.
    std::uint32_t refused = 0;   ///< Datagrams that were malformed.
    std::uint32_t compared = 0;  ///< Steps whose hashes were compared, and equal.
};

class Peer {
public:
    /// Gives the player's commands, seen the world as it is for them; they take effect kInputDelay steps
    /// later.
    using Player = std::function<std::vector<muster::CommandBody>(const muster::World&)>;

    /// Player `number`, 0 or 1. It stops after `steps` steps.
    Peer(muster::World world, std::uint32_t number, std::uint32_t steps, Player player);

    /// Takes the bytes of a datagram. What is malformed is counted and changes nothing.
    void receive(ByteSpan bytes);
    /// Once per tick of a sixtieth of a second: steps where it may. Fails where the states of both differ,
    /// naming the step.
    muster::Status tick();
    /// What the other is to be told now.
    Bytes datagram() const;

    /// True once both have final states of all steps and know it of each other.
    bool done() const { return world_.final() == steps_ && otherConfirmed_ >= steps_; }
    std::uint32_t number() const { return number_; }
    const RollbackWorld& world() const { return world_; }
    const PeerCounts& counts() const { return counts_; }
    /// Why the last malformed datagram was refused.
    const std::string& lastRefusal() const { return lastRefusal_; }
    /// All states up to this step are final here and equal to the other's, as far as hashes came.
    std::uint32_t equalUpTo() const { return equalUpTo_; }

private:
    struct Hash {
        std::uint32_t step = ~0u;
        std::uint64_t value = 0;
    };

    bool acceptable(const Datagram& datagram) const;
    void balance(const Datagram& datagram);
    muster::Status compareHashes();
    void decide();

    RollbackWorld world_;
    std::uint32_t number_, other_, steps_;
    Player player_;
    std::uint32_t sequence_ = 0;
    std::array<Input, kWindow> sent_;  // Own inputs by step modulo kWindow.
    std::uint32_t acknowledged_ = 0;   // The other has own inputs of all steps below this one.
    std::uint32_t otherNow_ = 0, otherConfirmed_ = 0;
    std::int32_t ahead_ = 0;
    std::int32_t leadSum_ = 0, leads_ = 0, toWait_ = 0;
    std::array<Hash, kWindow> theirs_;  // The other's hashes by step modulo kWindow.
    std::uint32_t equalUpTo_ = 0;
    PeerCounts counts_;
    std::string lastRefusal_;
};

}  // namespace lockstep
