// All state of a world in archives: one description serves saving, loading and hashing.
#pragma once

#include "base/archive.h"
#include "base/parallel.h"
#include "engine/state/world_state.h"

namespace muster {

/// Writes all state.
void saveState(Writer& writer, WorldState& state);
/// Reads what saveState() wrote; the reader has failed where it does not fit. Plans solve their fields again.
void loadState(Reader& reader, WorldState& state, ThreadPool& pool);
/// Adds all state to a hash.
void hashState(Hasher& hasher, WorldState& state);

}  // namespace muster
