// Finds the narrowest passage on a way.
#pragma once

#include <optional>
#include <span>

#include "engine/ground/environment/environment.h"
#include "engine/passages/passage.h"

namespace muster {

/// The passage of least capacity on a way, given by points at most a cell apart; among nearly equal ones the
/// first. None where nothing stands within 3 m of the way and no edge of the world does. Only what stands
/// still counts. Its ends are the nearest points of the two surfaces, exactly, where these face each other
/// across the way.
std::optional<Passage> narrowestPassage(const Environment& environment, std::span<const Vec2> way);

/// The gap across the way at `p`: from the nearest surface through `p` to the opposite one; none where no
/// surface is within 3 m.
std::optional<Passage> gapAcross(const Environment& environment, Vec2 p);

}  // namespace muster
