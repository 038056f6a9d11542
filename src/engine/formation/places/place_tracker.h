// Travelling places: from targets on the final mesh to points where characters can stand (paper section 6.1,
// SPEC M5).
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/parallel.h"
#include "engine/formation/places/target_separation.h"
#include "engine/formation/places/target_update.h"
#include "engine/ground/environment/environment.h"
#include "engine/ground/routes/shared_ways.h"

namespace muster {

/// Places of one group: each heads for its reachable target along a path that a character could take, at
/// bounded speed.
class PlaceTracker {
public:
    /// Puts every place on its reachable target at once (a new group).
    void reset(const PlaceDef& def, std::span<const Vec2> targets, const RouteGraph& routes,
               std::int32_t region);
    /// Moves places towards `targets` (one per place) for `dt` [s]. Reachable targets lie in the free space
    /// of the region, a diameter apart; places that find none are unfit. A place whose straight line is
    /// blocked follows a route round the obstacle; it never crosses one. `routes` are those of the
    /// characters' radius. If there are more targets than places, places are added at their reachable
    /// targets; if there are fewer, the last places are dropped.
    void advance(const PlaceDef& def, std::span<const Vec2> targets, RouteGraph& routes, std::int32_t region,
                 double dt, ThreadPool* pool = nullptr);

    /// Puts the places, of which there must be as many, where a march has led them in `dt` [s] > 0.
    void lead(std::span<const Vec2> positions, double dt);
    /// Puts the places where they are to stand.
    void stand(std::span<const Vec2> positions);

    /// The begin of a place of another arrangement.
    struct Origin {
        const PlaceTracker* tracker = nullptr;  ///< Tracker of the place before; null for a new place.
        std::int32_t place = -1;                ///< Its index in that tracker.
        Vec2 position;                          ///< Begin of a new place [m].
    };
    /// Takes over places from trackers, of which this may be one, and new ones. They go on from where they
    /// are; reachable targets stay until the next advance().
    void assemble(std::span<const Origin> origins);

    const std::vector<Vec2>& positions() const { return position_; }   ///< Positions of the places [m].
    const std::vector<Vec2>& velocities() const { return velocity_; }  ///< Velocities of the places [m/s].
    /// 1 where a character can stand, 0 where the place is unfit and stays unmatched.
    const std::vector<std::uint8_t>& fit() const { return targets_.fit; }
    /// Target of each place in the last reset() or advance(): a point of the final mesh [m].
    const std::vector<Vec2>& targets() const { return asked_; }
    /// Targets, of which those that are cut off from the region are brought within reach; state [m].
    const std::vector<Vec2>& targetsWithinReach() const { return targets_.target; }
    /// Reachable target of each place after the last reset() or advance() [m].
    const std::vector<Vec2>& reachableTargets() const { return targets_.reachable; }

    /// Lets an archive read or write the state.
    template <class Archive>
    void visit(Archive& archive) {
        archive(position_, velocity_, targets_.fit, detours_, nextPathSearch_, targets_.reachable,
                targets_.target, targets_.nextSearch, targets_.quiet, targets_.pause, ways_);
        if constexpr (Archive::kReading)
            if (!consistent()) archive.fail();
    }

private:
    // The rest of a path round an obstacle.
    struct Detour {
        std::int32_t place = 0;
        Vec2 goal;               // The reachable target that the path was searched for [m].
        std::vector<Vec2> path;  // Corners still ahead [m]; empty where no path was found.

        template <class Archive>
        void visit(Archive& archive) {
            archive(place, goal, path);
        }
    };

    // The need of a place for a path after its step.
    enum class PathNeed : std::uint8_t { None, Search, KeepDetour };

    class Mover;

    bool consistent() const;
    template <class Drop>
    void dropDetours(const Drop& drop);
    void readTargets(std::span<const Vec2> targets, const Environment& environment);
    void bringWithinReach(const FreeSpace& space);
    void separateAll(const PlaceDef& def, const RouteGraph& routes, std::int32_t region);
    void keepOrder(const FreeSpace& space);
    void keepRows(std::span<const std::int32_t> places, std::span<std::int32_t> points,
                  std::int32_t first) const;
    void moveAll(Mover& mover, ThreadPool* pool);
    void searchPaths(RouteGraph& routes);
    void reserve(const Environment& environment);
    std::int64_t findPath(RouteGraph& routes, Vec2 from, Vec2 to, std::vector<Vec2>& path);
    std::int64_t passMovingObstacles(RouteGraph& routes, std::vector<Vec2>& path);

    std::vector<Vec2> position_;  // Positions of the places [m].
    std::vector<Vec2> velocity_;  // Velocities of the places [m/s].
    ReachableTargets targets_;
    std::vector<Detour> detours_;       // Detours in ascending order of places.
    std::uint32_t nextPathSearch_ = 0;  // Place at which the round robin of path searches begins.
    SharedWays ways_;

    // Working memory and caches.
    std::vector<Vec2> wanted_;  // Targets, all finite [m].
    std::vector<Vec2> asked_;   // Targets before some were brought within reach [m].
    /// The shift that brings a target within reach; it holds while the target rests on the same ground.
    struct Reach {
        Vec2 target;  // Target [m].
        Vec2 way;     // Vector to the region [m].
        bool cutOff = false;
    };
    std::vector<Reach> reach_;  // Shifts per place, for the graph, its version and the region.
    const RouteGraph* reachGraph_ = nullptr;
    std::uint64_t reachVersion_ = 0;
    std::int32_t reachRegion_ = -1;
    std::vector<std::int32_t> cutOff_;  // Places whose targets are cut off.
    std::vector<PathNeed> needs_;       // Need of each place.
    TargetUpdateMemory updateMemory_;
    SeparationMemory separationMemory_;
    std::vector<std::vector<Vec2>> sparePaths_;  // Memory of paths that ended.
    NearestReachable nearest_;
    std::vector<Vec2> before_;  // Reachable targets of the last step [m].
    SiteFlood order_;
    std::vector<std::int32_t> displaced_, inOrder_;  // Places whose targets lie in walls.
    std::vector<Vec2> points_;                       // Their reachable targets [m].
    RouteSearch search_;
    std::vector<Vec2> samples_;  // Samples of a path [m].
};

}  // namespace muster
