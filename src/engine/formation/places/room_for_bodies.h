// Room for large bodies among the places of a formation.
#pragma once

#include <span>
#include <vector>

#include "base/cell_list.h"
#include "muster/vec2.h"

namespace muster {

/// Moves places apart as far as the bodies of their holders need it. Its working memory is reused.
class RoomForBodies {
public:
    /// Moves `places` [m], so that two are at least `least` [m] apart, and at least as far as the sum of
    /// their `radii` [m] and a little more. Large bodies, or clusters of them, push all others away, so that
    /// the density elsewhere stays. Pairs that remain too close after a bounded number of sweeps stay as they
    /// are. Moves nothing where all have room.
    void make(std::span<const double> radii, double least, std::span<Vec2> places);

private:
    double needed(std::int32_t a, std::int32_t b) const;
    bool isTight(std::span<const Vec2> places);
    double nearest(std::span<const Vec2> places, std::int32_t place) const;
    void push(std::span<Vec2> places, std::int32_t large) const;
    void findNearest(std::span<const Vec2> places);
    void growCluster(std::span<Vec2> places, std::span<const std::int32_t> cluster) const;
    void grow(std::span<Vec2> places, std::span<std::int32_t> cluster, std::size_t share);
    bool separate(std::span<Vec2> places);

    std::span<const double> radii_;    // Radius of each place's body [m].
    double least_ = 0.0;               // Least distance of two places [m].
    double reach_ = 0.0;               // Greatest distance that any two need [m].
    std::vector<std::int32_t> large_;  // Places of large bodies, the largest first.
    std::vector<double> near_;         // Distance of each place to the next one, at most the reach [m].
    CellList cells_;
};

}  // namespace muster
