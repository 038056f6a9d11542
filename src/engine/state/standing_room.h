// Spots where nobody stands yet, for characters that join a world.
#pragma once

#include <cstdint>
#include <map>
#include <utility>
#include <vector>

#include "engine/ground/environment/environment.h"

namespace muster {

/// Points where characters stand. Those added later keep a diameter from all others.
class StandingRoom {
public:
    /// For characters of `radius` [m] in this environment, which must outlive it.
    StandingRoom(const Environment& environment, double radius)
        : environment_(environment), radius_(radius) {}

    /// Somebody stands at `p` [m].
    void occupy(Vec2 p) { standing_[cellOf(p)].push_back(p); }
    /// A free point near `wanted` [m], a little more than a diameter from everybody, where there is one
    /// within 500 diameters; else the nearest free point. It is occupied from then on.
    Vec2 take(Vec2 wanted);

private:
    using CellKey = std::pair<std::int32_t, std::int32_t>;

    CellKey cellOf(Vec2 p) const;
    bool isOccupied(Vec2 p) const;

    const Environment& environment_;
    double radius_;                                  // [m]
    std::map<CellKey, std::vector<Vec2>> standing_;  // By cells as wide as a diameter.
};

}  // namespace muster
