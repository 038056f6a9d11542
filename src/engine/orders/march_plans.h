// The plans of a group's marches; earlier plans are kept for worlds that are rewound.
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

/// Plans one march at a time. A rewound world repeats its plans from the same input and with the same
/// budgets: in each step they are as far as they were then, but nothing is computed. All earlier plans are
/// caches.
class MarchPlans {
public:
    /// Begins a plan from a copy of the definition. `ground` is the version for all later calls, `cells` are
    /// its cells.
    void start(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground, const Grid& cells);
    /// Goes on with a plan that was begun in another world, where `spent` operations were spent.
    void resume(const StreamDef& def, std::span<const HeldSpot> held, GroundVersion ground, const Grid& cells,
                StreamGround room, std::int64_t spent);
    /// Goes on for about `operations` operations.
    StreamStatus advance(StreamGround room, std::int64_t operations);
    /// Tells the plan that the ground was changed where it has not looked.
    void stay(GroundVersion ground) { kept_[now_].input.ground = ground; }
    /// Takes over the plans of a world that is rewound.
    void keep(MarchPlans& before);

    bool begun() const { return begun_; }               ///< False until start() or resume().
    std::int64_t operations() const { return spent_; }  ///< Operations since the start.
    /// The march that was planned.
    Stream& best() { return kept_[now_].ways.best(); }
    /// The tiles that the plan has read; complete only once it is planned.
    const AskedTiles& asked() const { return kept_[now_].asked; }

private:
    /// Result of one call of advance().
    struct Turn {
        std::int64_t from = 0, operations = 0, to = 0;
    };
    /// Input of a plan.
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
    /// A plan; it may be ahead of the world that uses it.
    struct Kept {
        Input input;
        StreamWays ways;
        std::vector<Turn> turns;
        AskedTiles asked;

        StreamStatus advance(StreamGround room, std::int64_t operations);
    };

    std::array<Kept, 2> kept_;
    Input wanted_;
    std::size_t now_ = 0;     // Index of the present plan.
    bool begun_ = false;      // True if there is a present plan.
    bool rewinds_ = false;    // True if the world is rewound: both plans are used.
    std::int64_t spent_ = 0;  // Operations spent on the present plan by this world.
};

}  // namespace muster
