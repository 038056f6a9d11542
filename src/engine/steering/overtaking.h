// Overtaking: an agent that is slowed by another one ahead looks for a heading in which it gets on better
// (after the first heuristic of Moussaid, Helbing and Theraulaz 2011).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/steering/character_arrays.h"
#include "engine/steering/crowd_bodies.h"
#include "engine/steering/near_rows.h"

namespace muster {

/// Turns the velocities of agents that walk out of step.
class Overtaking {
public:
    /// Turns `wanted` [m/s] by 20, 40 or 60 degrees where the walker gets farther that way, by the law of
    /// headway and within the time of foresight, and no wall stands there; of two equal sides to the right.
    /// Each walker looks again within 0.1 s, at a step of its own, and keeps its turn (Claim::turn) in
    /// between. `dt` is the length of a step [s].
    void run(const CrowdBodies& bodies, const Environment& environment, const NearRows& rows,
             std::span<const double> topSpeed, std::uint32_t step, double dt, Characters& now,
             std::span<Vec2> wanted);

private:
    struct Walker {
        Vec2 position;     // [m]
        Vec2 ahead;        // Unit vector along its own path.
        double speed;      // Wanted speed [m/s].
        double radius;     // [m]
        double headway;    // [s]
        double foresight;  // [s]
    };
    // An agent near a walker.
    struct Other {
        Vec2 between;     // Vector from the walker to it [m].
        Vec2 velocity;    // [m/s]
        double touching;  // Distance at which the two touch [m].
    };
    // Result of a heading.
    struct Prospect {
        double speed;  // [m/s]
        double past;   // Distance until it is past the agent ahead [m]; 0 where there is none.
    };

    void list(const CrowdBodies& bodies, const Characters& now, std::span<const std::int32_t> near,
              std::size_t self, const Walker& walker);
    Prospect prospect(Vec2 heading, const Walker& walker, double least) const;
    std::int8_t turnOf(const Walker& walker, const Environment& environment) const;

    std::vector<Other> others_;  // Agents near one walker.
};

}  // namespace muster
