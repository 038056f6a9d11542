// All state of a world in archives: one description serves saving, loading and hashing; and snapshots, which
// hold it.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/archive.h"
#include "base/parallel.h"
#include "engine/state/world_state.h"
#include "muster/status.h"

namespace muster {

/// Writes all state.
void saveState(Writer& writer, WorldState& state);
/// Reads what saveState() wrote; the reader has failed where it does not fit. Plans solve their fields again.
void loadState(Reader& reader, WorldState& state, ThreadPool& pool);
/// Adds all state to a hash.
void hashState(Hasher& hasher, WorldState& state);

/// Fails with InvalidArgument where state that was read contradicts itself or holds a number out of its
/// range. Brings the lists of members up to date.
Status checkState(WorldState& state);

/// Takes over from `later` what is still true of `earlier`, which was just read: the rasters of the ground,
/// the factorised systems of meshes, and the solved fields of plans. No background work may be running;
/// `later` becomes useless.
void keepCaches(WorldState& earlier, WorldState& later);

/// Version of the state's format. It grows with every change of what archives hold.
inline constexpr std::uint32_t kSnapshotVersion = 21;

/// Bytes before the state.
inline constexpr std::size_t kSnapshotHeadBytes = 28;

/// Completes a snapshot: `bytes` hold kSnapshotHeadBytes of any content, then the state.
void sealSnapshot(std::vector<std::uint8_t>& bytes);
/// The state in a snapshot. Fails with ParseError or Unsupported, in one sentence, on other bytes, other
/// versions, missing bytes and changed ones.
Result<std::span<const std::uint8_t>> openSnapshot(std::span<const std::uint8_t> bytes);

}  // namespace muster
