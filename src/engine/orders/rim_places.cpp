#include "engine/orders/rim_places.h"

#include <algorithm>
#include <cmath>

namespace muster {
namespace {

/// The point at an arc length on the rim, from the middle of the front on counter-clockwise.
Vec2 onRim(Vec2 half, double at) {
    const double sides[] = {half.y, 2.0 * half.x, 2.0 * half.y, 2.0 * half.x, half.y};
    const Vec2 from[] = {
        {half.x, 0.0}, {half.x, half.y}, {-half.x, half.y}, {-half.x, -half.y}, {half.x, -half.y}};
    const Vec2 along[] = {{0, 1}, {-1, 0}, {0, -1}, {1, 0}, {0, 1}};
    for (int k = 0; k < 4; ++k) {
        if (at <= sides[k]) return from[k] + along[k] * at;
        at -= sides[k];
    }
    return from[4] + along[4] * std::min(at, sides[4]);
}

}  // namespace

std::vector<Vec2> rimPlaces(std::int32_t count, Vec2 half, double spacing) {
    std::vector<Vec2> places;
    if (count == 1 && std::max(half.x, half.y) <= 0.0) return {Vec2{}};
    // Otherwise the two sides of a line would lie on each other.
    half = {std::max(half.x, 0.75 * spacing), std::max(half.y, 0.75 * spacing)};
    while (std::ssize(places) < count) {
        const double rim = 4.0 * (half.x + half.y);
        const auto left = static_cast<std::int32_t>(count - std::ssize(places));
        // Places round a corner are nearer to each other than along the rim.
        const double room = std::floor(rim / (1.5 * spacing));
        const std::int32_t here = std::min(left, std::max(1, static_cast<std::int32_t>(std::min(room, 1e6))));
        for (std::int32_t k = 0; k < here; ++k) places.push_back(onRim(half, rim * k / here));
        half += Vec2{1.1 * spacing, 1.1 * spacing};
    }
    return places;
}

}  // namespace muster
