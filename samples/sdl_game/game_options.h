// The command line.
#pragma once

#include <muster/status.h>

#include <cstdint>
#include <string>

namespace game {

struct Options {
    std::int32_t frames = 0;  ///< Frames of the demo, drawn without a window; 0 to play.
    std::string picture;      ///< Where the last frame goes; empty for nowhere.
};

/// Reads the command line; a folder alone stands for a demo with its picture in there. Fails with
/// InvalidArgument, naming the culprit.
muster::Result<Options> readOptions(int count, const char* const* arguments);

}  // namespace game
