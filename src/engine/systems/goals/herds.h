// Which exits those nearby choose, whom somebody sees: for herding (docs/method/goals.md).
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
    /// Nobody is counted, in this box, for so many exits.
    void clear(const Box& box, std::size_t exits);
    /// Somebody at `p` goes to an exit.
    void add(Vec2 p, std::size_t exit);

    /// What somebody at a point sees of the others.
    class Sight {
    public:
        /// Looks round from `p`, who goes to exit `own`, -1 for none.
        Sight(const Herds& herds, const StaticGround& ground, Vec2 p, std::int32_t own);
        /// The share of all others nearby, in sight, who go to an exit; 0 where there are none.
        double share(std::size_t exit) const;

    private:
        static constexpr std::int32_t kReach = 4;  // Cells.
        static constexpr std::size_t kAround = (2 * kReach + 1) * (2 * kReach + 1);

        const Herds& herds_;
        std::int32_t own_;
        std::array<std::int32_t, kAround> cells_;  // Those in sight.
        std::size_t count_ = 0;
        double all_ = 0.0;  // Others in them.
    };

private:
    static constexpr double kCell = 2.5;     // [m]
    static constexpr double kNearby = 10.0;  // [m]

    Grid grid_;
    std::size_t exits_ = 0;
    std::vector<std::int32_t> count_;  // By cell and exit.
    std::vector<std::int32_t> all_;    // By cell.
};

}  // namespace muster
