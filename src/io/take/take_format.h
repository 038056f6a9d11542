// Layout of take files, shared by encoder and reader (docs/take-format.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>

namespace muster {

inline constexpr std::array<std::uint8_t, 8> kTakeMagic{'M', 'U', 'S', 'T', 'A', 'K', 'E', '\n'};
inline constexpr std::uint32_t kTakeVersion = 1;
inline constexpr std::size_t kTakeHeaderBytes = 12;  ///< Magic and version.
inline constexpr std::size_t kRecordHeadBytes = 9;   ///< Length, kind, checksum of these two.
inline constexpr std::size_t kRecordTailBytes = 4;   ///< Checksum of the payload.
inline constexpr std::uint32_t kMaxRecordBytes = 1u << 28;

/// What a record holds.
enum class RecordKind : std::uint8_t {
    Scenario = 1,  ///< Text of the scenario; the first record, once.
    Command = 2,   ///< As encodeCommand() writes it.
    Mark = 3,      ///< u32 step, u64 hash.
    End = 4,       ///< As Mark; nothing follows.
};

}  // namespace muster
