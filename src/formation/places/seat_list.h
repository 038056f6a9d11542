// Who sits where among the goals of places: close ones listed once and used for many steps.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "muster/vec2.h"

namespace muster {

/// The seats of those that have one (marked in `fit`), in cells, and for each the others that may come near.
/// The list holds while seats move alike; those that have moved otherwise than most are listed anew, or all
/// where these are many.
class SeatList {
public:
    /// Brings the list up to date with seats and with where they may move now. Both must lie within slack()
    /// of each other.
    void update(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                const std::vector<std::uint8_t>& fit, double apart);
    /// Calls `visit(other)` for the others that may be nearer than `apart` to this one, for some twice; only
    /// for seats of the last update().
    template <class Visit>
    void forNear(std::size_t seat, const Visit& visit) const {
        for (auto at = static_cast<std::size_t>(start_[seat]);
             at < static_cast<std::size_t>(start_[seat + 1]); ++at)
            visit(static_cast<std::size_t>(other_[at]));
        for (std::int32_t at = laterOther_[seat]; at >= 0; at = link(at).next)
            visit(static_cast<std::size_t>(link(at).seat));
    }
    /// Calls `visit(a, b)` for all pairs that may be nearer than `apart`, some twice, in a fixed order.
    template <class Visit>
    void forPairs(const Visit& visit) const {
        for (const Pair pair : pairs_)
            visit(static_cast<std::size_t>(pair.low), static_cast<std::size_t>(pair.high));
    }
    /// True where a seat that is listed and marked in `fit` lies nearer than `apart` to a spot, `self` left
    /// out.
    bool occupied(Vec2 spot, const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit,
                  std::size_t self) const;
    /// What a seat may move within a step, relative to the others [m].
    static double slack(double apart) { return 0.3 * apart; }

private:
    struct Pair {
        std::int32_t low = 0;
        std::int32_t high = 0;
    };

    struct Link {
        std::int32_t seat = 0;
        std::int32_t next = 0;  // Another link of the same chain, or negative.
    };

    bool findStrays(const std::vector<Vec2>& seats, const std::vector<Vec2>& next,
                    const std::vector<std::uint8_t>& fit);
    void listAll(const std::vector<Vec2>& seats, const std::vector<std::uint8_t>& fit);
    void linkPairs();
    void listAnew(std::size_t seat, Vec2 at);
    void chain(std::int32_t& first, std::size_t seat);
    const Link& link(std::int32_t at) const { return links_[at]; }
    // True once `visit(seat)` is, called for the seats that were found in the nine cells round a point, some
    // twice.
    template <class Visit>
    bool anyRound(Vec2 p, const Visit& visit) const;

    double apart_ = 0.0;
    Vec2 drift_;                        // Mean way of the seats since they were listed [m].
    CellList cells_;                    // Of the listed.
    std::vector<Vec2> foundAt_;         // Of each seat when it was listed; far away for the others [m].
    std::vector<Vec2> listedAt_;        // Of the listed when all were, one after the other [m].
    std::vector<std::int32_t> listed_;  // Their seats, then those that were not listed then.
    std::vector<Pair> pairs_;
    std::vector<std::int32_t> start_;
    std::vector<std::int32_t> other_;
    std::vector<std::int32_t> strays_;      // Working memory of update().
    std::vector<Link> links_;               // Of those listed anew since all were: they and their pairs.
    std::vector<std::int32_t> laterOther_;  // Of each seat the first link of its pairs.
    std::vector<std::int32_t> laterIn_;     // Of each cell the first link of those found in it.
};

}  // namespace muster
