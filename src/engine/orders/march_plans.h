// The plans of a group's marches, those of before kept for worlds that are rewound.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "engine/orders/asked_tiles.h"
#include "engine/orders/held_spot.h"
#include "engine/orders/stream_ways.h"
#include "engine/orders/way_ground.h"

namespace muster {

/// Plans one march at a time. A world that was rewound plans again what it has planned before, from the same
/// and with the same budgets: it is then as far in each step as it was then, but computes nothing. All plans
/// of before are caches.
class MarchPlans {
public:
    /// Begins a plan; what the definition refers to is copied. `ground` is that of all later calls, `cells`
    /// are its.
    void start(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground, const Grid& cells);
    /// Goes on with a plan that was begun in another world, where so many operations were spent.
    void resume(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground, const Grid& cells,
                StreamGround room, std::int64_t spent);
    /// Goes on for about so many operations.
    StreamStatus advance(StreamGround room, std::int64_t operations);
    /// The ground was changed where the present plan has not looked.
    void stay(GroundVersion ground) { kept_[now_].input.ground = ground; }
    /// Takes over the plans of a world that is rewound.
    void keep(MarchPlans& before);

    bool begun() const { return begun_; }               ///< False until start() or resume().
    std::int64_t operations() const { return spent_; }  ///< Since the start.
    /// The march that was planned.
    Stream& best() { return kept_[now_].ways.best(); }
    /// Where it has looked; all of that only once it is planned.
    const AskedTiles& asked() const { return kept_[now_].asked; }

private:
    /// What one call of advance() came to.
    struct Turn {
        std::int64_t from = 0, operations = 0, to = 0;
    };
    /// What a plan is made from.
    struct Input {
        std::vector<Vec2> offsets, starts, ends, way;
        std::vector<HeldSpot> held;
        double spacing = 1.0, radius = 0.25, closest = 1.0;
        bool drawn = false;
        std::vector<Pose> poses;
        GroundVersion ground;

        StreamDef def() const { return {offsets, starts, ends, way, spacing, radius, closest, drawn, poses}; }
        friend bool operator==(const Input&, const Input&) = default;
    };
    /// A plan; it may be further than the world that uses it.
    struct Kept {
        Input input;
        StreamWays ways;
        std::vector<Turn> turns;
        AskedTiles asked;

        StreamStatus advance(StreamGround room, std::int64_t operations);
    };

    std::array<Kept, 2> kept_;
    Input wanted_;
    std::size_t now_ = 0;     // The present one.
    bool begun_ = false;      // There is a present one.
    bool rewinds_ = false;    // The world is one that is rewound: both are used.
    std::int64_t spent_ = 0;  // On the present one by this world.
};

}  // namespace muster
