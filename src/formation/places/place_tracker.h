// Places that travel: from points of Vf to where characters can stand (SPEC M5).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/cell_list.h"
#include "base/parallel.h"
#include "environment/environment.h"

namespace muster {

/// Working memory of a search for pairs of points that lie too near to each other: points by cells.
struct SpacingMemory {
    /// Two points, `low` < `high`.
    struct Pair {
        std::int32_t low = 0;   ///< Index of a point.
        std::int32_t high = 0;  ///< Index of a point.
    };

    CellList cells;             ///< The points, in cells at least as large as the distance looked for.
    std::vector<Vec2> push;     ///< Of each point [m].
    std::vector<Pair> near;     ///< Pairs that may come too near.
    std::vector<Vec2> foundAt;  ///< Where the points were when these were looked for [m]; empty for never.
    std::vector<Pair> close;    ///< Pairs too near.
};

/// How places travel.
struct PlaceDef {
    double radius = 0.25;     ///< Of the characters [m] > 0.
    double clearance = 0.02;  ///< Kept from obstacles beyond the radius [m] >= 0.
    double maxSpeed = 2.0;    ///< [m/s] > 0, times the ground's travel speed.
};

struct CarryMemory;  // Working memory of goals that are carried from step to step.

/// Places of one group: each follows its target continuously, along ways a character could take.
class PlaceTracker {
public:
    PlaceTracker();  ///< No places.
    ~PlaceTracker();
    PlaceTracker(PlaceTracker&&) noexcept;             ///< Moves.
    PlaceTracker& operator=(PlaceTracker&&) noexcept;  ///< Moves.

    /// Puts every place on its reachable target at once (a new group).
    void reset(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
               std::int32_t region);
    /// Moves places towards `targets` (one per place) for `dt` [s]. Where targets are clear of obstacles and
    /// of each other they are the places' goals; goals of others are seats near by, in the region with
    /// clearance and a diameter apart. These are carried from step to step, and better ones sought in turns;
    /// those that find no room are marked unfit. A place whose straight way is blocked follows a path round
    /// the obstacle; it never crosses one. A changed number of targets adds places at their reachable targets
    /// or drops the last ones.
    void advance(const PlaceDef& def, std::span<const Vec2> targets, const Environment& environment,
                 std::int32_t region, double dt, ThreadPool* pool = nullptr);

    const std::vector<Vec2>& positions() const { return position_; }   ///< [m]
    const std::vector<Vec2>& velocities() const { return velocity_; }  ///< [m/s]
    /// 1 where a character can stand, 0 where the place is unfit and stays unmatched.
    const std::vector<std::uint8_t>& fit() const { return fit_; }

    /// Where each place is bound for: its reachable target of the last reset() or advance() [m].
    const std::vector<Vec2>& goals() const { return goal_; }

    /// Lets an archive read or write the state.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position_, velocity_, fit_, detours_, turn_, goal_, target_, seatTurn_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    /// The rest of a way round an obstacle.
    struct Detour {
        std::int32_t place = 0;
        Vec2 goal;              ///< The target it was made for [m].
        std::vector<Vec2> way;  ///< Corners still ahead [m]; empty where none was found.

        /// Lets an archive read or write the detour.
        template <class Archive>
        void visit(Archive& archive) {
            archive(place, goal, way);
        }
    };

    class Mover;  // One step's travel.

    bool consistent() const;
    template <class Drop>
    void dropDetours(const Drop& drop);
    void readTargets(std::span<const Vec2> targets, const Environment& environment);
    void findGoals(const PlaceDef& def, const Environment& environment, std::int32_t region);
    void moveAll(Mover& mover, ThreadPool* pool);
    void findWays(const PlaceDef& def, const Environment& environment);

    std::vector<Vec2> position_;
    std::vector<Vec2> velocity_;
    std::vector<std::uint8_t> fit_;
    std::vector<Detour> detours_;  ///< Ordered by place.
    std::uint32_t turn_ = 0;       ///< Place whose turn it is to look for a way first.
    std::vector<Vec2> goal_;       ///< Seats: reachable targets [m].
    std::vector<Vec2> target_;     ///< Targets they are for [m].
    std::uint32_t seatTurn_ = 0;   ///< Place whose turn it is to look for a better seat.
    std::vector<Vec2> wanted_;     // Working memory: targets, all finite.
    std::vector<std::uint8_t> mark_;
    std::unique_ptr<CarryMemory> carry_;
    SpacingMemory spacing_;
    std::vector<std::vector<Vec2>> spareWays_;  // Memory of ways that ended.
};

}  // namespace muster
