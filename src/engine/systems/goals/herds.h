// The exits that the people in sight of a person choose: for herding (docs/method/goals.md).
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "engine/fields/cost/static_ground.h"
#include "muster/vec2.h"

namespace muster {

/// People by cell and exit.
class Herds {
public:
    /// Begins without people, in a box, for a number of exits.
    void clear(const Box& box, std::size_t exits);
    /// Counts a person at `p` who goes to an exit.
    void add(Vec2 p, std::size_t exit);

    /// The people in sight of a person at a point.
    class Sight {
    public:
        /// Looks round from `p` for a person who goes to exit `own`, -1 for none.
        Sight(const Herds& herds, const StaticGround& ground, Vec2 p, std::int32_t own);
        /// The share of the people in sight who go to an exit; 0 where none are in sight.
        double share(std::size_t exit) const;

    private:
        static constexpr std::int32_t kReach = 4;  // Distance in sight [cells].
        static constexpr std::size_t kAround = (2 * kReach + 1) * (2 * kReach + 1);

        const Herds& herds_;
        std::int32_t own_;
        std::array<std::int32_t, kAround> cells_;  // Cells in sight.
        std::size_t count_ = 0;
        double all_ = 0.0;  // Number of others in these cells.
    };

private:
    static constexpr double kCell = 2.5;     // Width of a cell [m].
    static constexpr double kNearby = 10.0;  // Distance in sight [m].

    Grid grid_;
    std::size_t exits_ = 0;
    std::vector<std::int32_t> count_;  // People by cell and exit.
    std::vector<std::int32_t> all_;    // People by cell.
};

}  // namespace muster
