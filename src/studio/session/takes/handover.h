// What another session needs to go on with a world: the commands that it has had, and its present state.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "muster/status.h"

namespace muster {

/// A session's world at one moment (docs/protocol.md, "Handover"). A keeper asks for it again and again: it
/// gets the take's bytes that it does not have yet, and all the rest each time.
struct Handover {
    std::uint32_t world = 0;             ///< The number of the world in its session.
    std::uint64_t takeFrom = 0;          ///< Bytes of the take before `take`, which the keeper has.
    std::vector<std::uint8_t> take;      ///< The take up to now, or the take that is open, from there on.
    std::string name;                    ///< The scenario's name.
    std::string place;                   ///< The place as a scenario file, where it was edited; else empty.
    bool open = false;                   ///< True where the take is open, as a replay.
    bool complete = true;                ///< False where the take had become too large, and ends early.
    bool playing = true;                 ///< False where it is paused.
    double speed = 1.0;                  ///< Seconds of the world per second.
    std::uint32_t step = 0;              ///< Steps done.
    bool recording = false;              ///< True where it is being recorded.
    std::uint32_t recordedFrom = 0;      ///< Steps done when the recording began.
    std::vector<std::uint8_t> snapshot;  ///< World::snapshot(); empty where a take is open.

    /// The handover as bytes.
    std::vector<std::uint8_t> bytes() const;
    /// Reads bytes(). Fails with ParseError, and with Unsupported on those of another version.
    static Result<Handover> parse(std::span<const std::uint8_t> bytes);
};

}  // namespace muster
