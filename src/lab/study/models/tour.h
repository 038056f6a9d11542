// Ways that collect items: tours, and which items a moving crowd sweeps up beside its way.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "lab/study/models/chance.h"
#include "lab/study/models/seen_ground.h"

namespace muster {

/// A crowd or a part of it, as it would move: all keep their offsets from its middle.
struct Sweep {
    std::vector<Vec2> offsets;  ///< Offsets of its characters from its middle [m].
    double reach = 0.0;         ///< Distance to an item at which a character collects it [m].
    Vec2 aim;  ///< Offset of the character that is steered over an item: that nearest to the middle [m].

    /// True where a straight move of the middle from `a` to `b` collects an item there.
    bool collects(Vec2 a, Vec2 b, Vec2 item) const;
};

/// Distance of a point to the straight line from `a` to `b` [m].
double distanceToSegment(Vec2 p, Vec2 a, Vec2 b);

/// Finds tours. The best found are made worse on purpose, as people's tours are.
class TourFinder {
public:
    TourFinder(const SeenGround& ground, std::span<const Vec2> items);

    /// An order of the items `open` in which to visit them from `from`, about `detour` longer than the best
    /// found.
    std::vector<std::int32_t> tour(Vec2 from, std::span<const std::int32_t> open, double detour,
                                   Chance& chance) const;
    /// Length of a tour [m].
    double length(Vec2 from, std::span<const std::int32_t> order) const;
    /// Leaves out items that the crowd collects on its way to others.
    std::vector<std::int32_t> thinned(Vec2 from, std::span<const std::int32_t> order,
                                      const Sweep& sweep) const;
    /// Shortest way between two items [m].
    double between(std::int32_t a, std::int32_t b) const { return lengths_[a * count_ + b]; }

    const SeenGround& ground() const { return *ground_; }   ///< The ground round whose blocks ways lead.
    std::span<const Vec2> items() const { return items_; }  ///< Positions of all items [m].

private:
    void improve(std::vector<std::int32_t>& order, std::span<const double> fromStart) const;

    const SeenGround* ground_;
    std::vector<Vec2> items_;
    std::size_t count_ = 0;
    std::vector<double> lengths_;
};

}  // namespace muster
