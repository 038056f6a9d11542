// What one peer tells the other, as bytes of one UDP datagram.
#pragma once

#include <muster/command.h>

#include <cstdint>
#include <vector>

#include "bytes.h"

namespace lockstep {

/// All commands of one player for one step; mostly none.
using Input = std::vector<muster::Command>;

inline constexpr std::size_t kMostBytes = 1200;  ///< Of a datagram: what every network carries in one piece.
inline constexpr std::size_t kMostHashes = 16;   ///< In a datagram.
inline constexpr std::size_t kMostInputs = 64;   ///< Steps whose inputs are in a datagram.
inline constexpr std::size_t kMostInputBytes = 1000;  ///< Of one step, so that it fits into a datagram.

/// Everything that the other may not know yet. Each datagram stands for itself: any may get lost.
struct Datagram {
    std::uint32_t now = 0;        ///< Steps that the sender has done.
    std::int32_t ahead = 0;       ///< By how many steps it believes to be ahead of the last datagram it got.
    std::uint32_t received = 0;   ///< It has the receiver's inputs of all steps below this one.
    std::uint32_t confirmed = 0;  ///< Its states up to this step are final.
    std::uint32_t firstHash = 0;  ///< Step of the first of the hashes.
    std::vector<std::uint64_t> hashes;  ///< Of final states, one per step.
    std::uint32_t firstInput = 0;       ///< Step of the first of the inputs.
    std::vector<Input> inputs;          ///< The sender's own, one per step.
};

/// The datagram as bytes. Inputs that do not fit are left out, the latest first.
Bytes encode(const Datagram& datagram);
/// Reads a datagram of the player of that number. Fails with ParseError on all bytes that encode() does not
/// make, and on commands of other players.
muster::Result<Datagram> decode(ByteSpan bytes, std::uint32_t player);
/// Bytes that an input takes in a datagram.
std::size_t encodedSize(const Input& input);

}  // namespace lockstep
