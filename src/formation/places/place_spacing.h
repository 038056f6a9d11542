// Points moved a diameter apart.
#pragma once

#include <cstdint>
#include <vector>

#include "formation/places/place_tracker.h"

namespace muster {

/// Moves points that lie nearer than `apart` [m] away from each other, once. Looks only at pairs with
/// a point marked in `moved` (those that moved since all was well); afterwards the marks tell what has
/// moved now. Returns false where none were too near. Coincident points part in fixed directions.
bool partClosePairs(std::vector<Vec2>& points, double apart, SpacingMemory& memory,
                    std::vector<std::uint8_t>& moved);

/// Marks with 0 every point that lies nearer than `apart` [m] to one of lower index marked with 1.
void markUnfit(const std::vector<Vec2>& points, double apart, SpacingMemory& memory,
               std::vector<std::uint8_t>& fit);

/// Looks up whether a spot is taken, among points as they were sorted when this was made and spots
/// taken since. Uses the memory of its maker; one search at a time.
class NearSearch {
public:
    NearSearch(const std::vector<Vec2>& points, double apart, SpacingMemory& memory);

    /// True where a point whose `fit` is 1, or a spot taken, lies nearer than `apart`.
    bool occupied(Vec2 spot, const std::vector<std::uint8_t>& fit, const std::vector<Vec2>& points) const;
    /// Takes a spot.
    void take(Vec2 spot) { memory_.push.push_back(spot); }

private:
    double apart_;
    SpacingMemory& memory_;
};

}  // namespace muster
