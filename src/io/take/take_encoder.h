// The records of take files (docs/take-format.md).
#pragma once

#include <cstdint>
#include <vector>

#include "muster/take.h"

namespace muster {

/// Makes the bytes of a take record by record (docs/take-format.md).
class TakeEncoder {
public:
    /// Header and scenario record.
    static std::vector<std::uint8_t> begin(const WorldDef& def);
    /// A command record.
    static std::vector<std::uint8_t> command(const Command& command);
    /// A hash mark.
    static std::vector<std::uint8_t> mark(const HashMark& mark);
    /// The last record, with the last mark.
    static std::vector<std::uint8_t> end(const HashMark& mark);
};

}  // namespace muster
