// Layout of take files, shared by encoder and reader, and what is said about a take, as text
// (docs/take-format.md).
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include "base/archive.h"
#include "muster/take.h"

namespace muster {

inline constexpr std::array<std::uint8_t, 8> kTakeMagic{'M', 'U', 'S', 'T', 'A', 'K', 'E', '\n'};
inline constexpr std::uint32_t kTakeVersion = kArchiveVersion;  ///< As written.
inline constexpr std::uint32_t kOldestTakeVersion = 1;          ///< That is read.
inline constexpr std::size_t kTakeHeaderBytes = 12;             ///< Size of magic and version.
inline constexpr std::size_t kRecordHeadBytes = 9;  ///< Size of length, kind and checksum of both.
inline constexpr std::size_t kRecordTailBytes = 4;  ///< Size of the payload's checksum.
inline constexpr std::uint32_t kMaxRecordBytes = 1u << 28;

/// The kinds of records.
enum class RecordKind : std::uint8_t {
    Scenario = 1,  ///< Text of the scenario; the first record, exactly once.
    Command = 2,   ///< A command as encodeCommand() writes it.
    Mark = 3,      ///< u32 step, u64 hash.
    End = 4,       ///< Like Mark; only about records follow.
    Event = 5,     ///< u32 step, u8 kind, u32 subject, u32 value, f64 x, f64 y.
    About = 6,     ///< JSON text; the last one counts.
    Frames = 7,    ///< As packFrames() writes them.
};

/// The JSON text of an about record.
std::string writeTakeAbout(const TakeAbout& about);
/// Reads one back. Unknown keys are ignored, so that later versions may add some. Fails with ParseError, or
/// as TakeAbout::check() does.
Result<TakeAbout> readTakeAbout(std::string_view text, const std::string& sourceName);

}  // namespace muster
