// A made grid map of caves: as much detail as the real ones, of any size.
#pragma once

#include <cstdint>

#include "muster/ground.h"

namespace muster::scale {

/// Caves by a cellular automaton: random cells, each of which takes what most of its neighbours are, a few
/// times. Nearly all free cells hang together. `width` and `height` in cells, at least 16.
MapGrid madeCaves(std::int32_t width, std::int32_t height, std::uint64_t seed);

}  // namespace muster::scale
