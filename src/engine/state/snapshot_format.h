// What stands round the state in a snapshot: kind, version, length and checksum.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/status.h"

namespace muster {

/// Version of the state's format. It grows with every change of what archives hold.
inline constexpr std::uint32_t kSnapshotVersion = 13;

/// Bytes before the state.
inline constexpr std::size_t kSnapshotHeadBytes = 28;

/// Completes a snapshot: `bytes` hold kSnapshotHeadBytes of any content, then the state.
void sealSnapshot(std::vector<std::uint8_t>& bytes);
/// The state in a snapshot. Fails with ParseError or Unsupported, in one sentence, on other bytes, other
/// versions, missing bytes and changed ones.
Result<std::span<const std::uint8_t>> openSnapshot(std::span<const std::uint8_t> bytes);

}  // namespace muster
