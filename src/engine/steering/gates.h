// Gates: gaps that are wide enough for one and too narrow for two. Where people come from both sides they
// take turns.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/grid.h"
#include "engine/ground/environment/environment.h"
#include "muster/parameters.h"

namespace muster {

struct Characters;

/// Changes preferred velocities at gates that people want to pass in both directions. Turns follow the clock:
/// each direction has the gate for a while, and before it changes nobody enters. Meanwhile the others wait
/// beside the lane in which people come out. A cache: it keeps nothing that the environment does not tell.
class Gates {
public:
    /// Who must leave a lane gets a velocity in `leaving` [m/s], null for all others; who must not enter
    /// loses the part of `preferred` that leads there [m/s]. True where somebody has to leave.
    bool run(const Parameters::Character& def, const Characters& now, const Environment& environment,
             std::span<Vec2> leaving, std::span<Vec2> preferred);

private:
    struct Gate {
        Vec2 centre, through, across;
        double halfWidth;  // [m]
        double depth;      // Half the length in which two have no room beside each other [m].
    };
    // A character near a gate.
    struct Visitor {
        std::int32_t character;
        double through, across;  // From the gate's centre [m].
        std::int8_t way;         // Direction in which it wants to pass: 1 or -1; 0 where it does not.
        bool passing;            // It comes or walks through, and does not only stand in the gate.
    };

    void find(const Environment& environment, double radius);
    void sortIntoCells(const Box& box);
    void listVisitors(const Characters& now);
    void takeTurns(const Gate& gate, double time, double topSpeed, double radius,
                   std::span<const Visitor> visitors, std::span<Vec2> leaving, std::span<Vec2> preferred);
    void wait(const Gate& gate, const Visitor& visitor, double turn, double topSpeed, double radius,
              std::span<Vec2> leaving, std::span<Vec2> preferred);

    std::uint64_t instance_ = 0, version_ = 0;
    double radius_ = -1.0;
    std::vector<Gate> gates_;
    Grid grid_;                                   // Coarse cells of the world.
    std::vector<std::int32_t> first_;             // Per coarse cell, its first in near_; then the end.
    std::vector<std::int32_t> near_;              // Gates, cell by cell.
    std::vector<std::vector<Visitor>> visitors_;  // Per gate.
    std::vector<std::int32_t> visited_;           // Gates with visitors.
    std::vector<ClosedGap> gaps_;
    bool any_ = false;
};

}  // namespace muster
