// Places round the rim of a rectangle.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/vec2.h"

namespace muster {

/// `count` places round a rectangle of half its length and width `half` [m] about the origin: evenly on its
/// rim, and on further rims outside it where they would be nearer to each other than `spacing` [m].
std::vector<Vec2> rimPlaces(std::int32_t count, Vec2 half, double spacing);

}  // namespace muster
