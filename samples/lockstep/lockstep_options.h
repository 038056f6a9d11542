// The command line.
#pragma once

#include <muster/status.h>

#include <cstdint>
#include <string>

#include "lossy_link.h"

namespace lockstep {

struct Options {
    std::string folder;        ///< Where logs are kept; empty for nowhere.
    double seconds = 60.0;     ///< Simulated time [s].
    double every = 10.0;       ///< Simulated time between two lines of the log [s].
    bool real = false;         ///< Ticks last a sixtieth of a second; else as long as they take.
    double patience = 10.0;    ///< Without a word for so long, the other peer counts as gone [s].
    std::int32_t people = 50;  ///< Of each player.
    std::uint16_t port = 0;    ///< Own port; 0 to start both peers.
    std::uint16_t peer = 0;    ///< Port of the other peer.
    LinkDef link;
};

/// Reads the command line. Fails with InvalidArgument, naming the culprit.
muster::Result<Options> readOptions(int count, const char* const* arguments);
/// What can be said on the command line.
const char* usage();

}  // namespace lockstep
