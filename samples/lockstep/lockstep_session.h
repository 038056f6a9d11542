// One peer from its first step to its last, with its log.
#pragma once

#include "lockstep_options.h"
#include "udp.h"

namespace lockstep {

/// Exit codes.
enum Outcome : int {
    kEqual = 0,   ///< All states were equal up to the end.
    kDiffer = 1,  ///< States differ.
    kUsage = 2,   ///< The command line is wrong, or a port or a file cannot be used.
    kAlone = 3,   ///< The other peer is gone.
};

/// Plays as player `number`, 0 or 1, against whoever the socket is connected with.
int runPeer(const Options& options, std::uint32_t number, UdpSocket socket);

}  // namespace lockstep
