// The records of take files (docs/take-format.md).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/take.h"

namespace muster {

/// Encodes a take record by record (docs/take-format.md).
class TakeEncoder {
public:
    /// Encodes the file header and the scenario record.
    static std::vector<std::uint8_t> begin(const WorldDef& def);
    /// Encodes a command record.
    static std::vector<std::uint8_t> command(const Command& command);
    /// Encodes an event.
    static std::vector<std::uint8_t> event(const TakeEvent& event);
    /// Encodes the events of orders in a world's last step, one record each.
    static std::vector<std::uint8_t> events(const World& world);
    /// Encodes what is said about the take.
    static std::vector<std::uint8_t> about(const TakeAbout& about);
    /// Encodes stored frames; nothing for none.
    static std::vector<std::uint8_t> frames(std::span<const TakeFrame> frames);
    /// Encodes a hash mark.
    static std::vector<std::uint8_t> mark(const HashMark& mark);
    /// Encodes a finished take as a file, with that said about it.
    static std::vector<std::uint8_t> whole(const Take& take, const TakeAbout& about);
    /// Encodes the end record, with the last mark.
    static std::vector<std::uint8_t> end(const HashMark& mark);
};

}  // namespace muster
