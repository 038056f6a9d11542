// Who sits where among the goals of places: close ones listed once and used for many steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "muster/base/cell_list.h"
#include "muster/base/vec2.h"

namespace muster {

/// The seats of those that have one (marked in `fit`), in cells, and for each the others that may come near. The list
/// holds while seats move alike; it is made anew where one has moved otherwise than most.
class SeatList {
public:
    /// Brings the list up to date with seats and with where they may move now. Both must lie within slack() of each
    /// other.
    void update(const std::vector<Vec2>& seats, const std::vector<Vec2>& next, const std::vector<std::uint8_t>& fit,
                double apart);
    /// Others that may be nearer than `apart` to this one; only for seats of the last update().
    std::span<const std::int32_t> near(std::size_t seat) const {
        const auto begin = static_cast<std::size_t>(start_[seat]);
        return {other_.data() + begin, static_cast<std::size_t>(start_[seat + 1]) - begin};
    }
    /// Calls `visit(a, b)` for all pairs that may be nearer than `apart`, in a fixed order.
    template <class Visit>
    void forPairs(const Visit& visit) const {
        for (const Pair pair : pairs_) visit(static_cast<std::size_t>(pair.low), static_cast<std::size_t>(pair.high));
    }
    /// True where a seat that is listed and marked in `fit` lies nearer than `apart` to a spot, `self` left out.
    bool occupied(Vec2 spot, const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit,
                  std::size_t self) const;
    /// What a seat may move within a step, relative to the others [m].
    static double slack(double apart) { return 0.3 * apart; }

private:
    struct Pair {
        std::int32_t low = 0;
        std::int32_t high = 0;
    };

    bool holds(const std::vector<Vec2>& seats, const std::vector<Vec2>& next, const std::vector<std::uint8_t>& fit);
    void link();

    double apart_ = 0.0;
    Vec2 drift_;                        // Mean way of the seats since they were listed [m].
    CellList cells_;                    // Of the listed.
    std::vector<Vec2> foundAt_;         // Of each seat when it was listed; far away for the others [m].
    std::vector<Vec2> listedAt_;        // Of the listed, one after the other [m].
    std::vector<std::int32_t> listed_;  // Their seats.
    std::vector<Pair> pairs_;
    std::vector<std::int32_t> start_;
    std::vector<std::int32_t> other_;
};

}  // namespace muster
