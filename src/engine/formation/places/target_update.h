// Reachable targets from step to step: they move along with their targets, conflicts are resolved, and single
// targets are relocated.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "base/neighbour_list.h"
#include "base/parallel.h"
#include "engine/formation/places/free_space.h"
#include "engine/formation/places/site_flood.h"

namespace muster {

/// Targets of the places of a group.
struct ReachableTargets {
    std::vector<Vec2> target;       ///< Targets of the last step: points of the final mesh [m].
    std::vector<Vec2> reachable;    ///< Point of the free space for which each place heads [m].
    std::vector<std::uint8_t> fit;  ///< 1 where a place has such a point, 0 where it stays unmatched.
    std::uint32_t nextSearch = 0;   ///< Index of the place whose search for a better point comes next.
    std::uint32_t quiet = 0;        ///< Searches without success since a reachable target moved.
    std::uint32_t pause = 0;        ///< Steps until a flood is tried again, after one that found no room.
};

/// Proposals of the last step for targets that rested. One holds while all its inputs are the same.
struct RestingProposals {
    struct Proposal {
        Vec2 reachable, target;             ///< Inputs of the proposal [m].
        Vec2 advected, next;                ///< Proposed points [m].
        std::uint8_t level = 0, exact = 0;  ///< Proposed level and state.
        bool known = false;                 ///< True only for places that were fit and at rest.
    };
    std::vector<Proposal> proposals;  ///< Proposals per place.
    std::uint64_t instance = 0, version = 0;
    std::int32_t region = -1;
    double attraction = -1.0, separation = -1.0, clear = -1.0;
};

/// Working memory of TargetUpdate. Only neighbour list and resting proposals outlive a step, as caches.
struct TargetUpdateMemory {
    NeighbourList neighbours;             ///< Neighbours of the reachable targets.
    std::vector<Vec2> advected;           ///< Point of each if it moves along with its target [m].
    std::vector<Vec2> next;               ///< Point of each by its level [m].
    std::vector<std::uint8_t> level;      ///< Level of movement of each.
    std::vector<std::uint8_t> exact;      ///< 1 for points on their targets.
    std::vector<std::uint8_t> inWall;     ///< 1 for points that are not, because their targets are not free.
    std::vector<std::uint8_t> yielding;   ///< 1 for points listed in `yields`.
    std::vector<std::int32_t> yields;     ///< Points whose level is lowered next.
    std::vector<std::int32_t> lowered;    ///< Points whose level was lowered last.
    std::vector<std::int32_t> searching;  ///< Points that are not on their targets, round robin.
    std::vector<std::int32_t> relocated;  ///< Points relocated in this step.
    RestingProposals resting;             ///< Resting proposals of the last step.
    SiteFlood flood;                      ///< Flood for places with no free point near by.
};

/// One step of reachable targets. A reachable target that lies on its target moves with it. Others are
/// advected by the displacement of their targets and attracted by them. Where two come too close, one gives
/// up attraction first, then advection; where all keep their points none is too close. Where most targets lie
/// in walls, and none is nearer yet, they stay kLooseSpacing separations apart. Places without a point, or
/// not on their targets, search for a better one, round robin and within a budget. A flood over the region
/// serves places without a point that find none near by.
class TargetUpdate {
public:
    /// Reachable targets stay `separation` [m] apart; attraction moves them by up to `attraction` [m] per
    /// step.
    TargetUpdate(const FreeSpace& space, double separation, double attraction, ReachableTargets& state,
                 TargetUpdateMemory& memory)
        : space_(space), separation_(separation), attraction_(attraction), s_(state), m_(memory) {}

    /// Advances to `targets`. False, with nothing changed, where more targets jumped than separateTargets()
    /// suits better.
    bool run(std::span<const Vec2> targets, ThreadPool* pool);

private:
    enum Level : std::uint8_t { Fixed, Advected, Attracted, Discontinuous };

    double maxStep() const;
    bool mostAreInWalls() const;
    bool nobodyIsNear(double distance) const;
    bool restingHold();
    void proposeOrRecall(std::int32_t place, Vec2 target, bool recalls);
    void propose(std::int32_t place, Vec2 target);
    void proposeAttracted(std::int32_t place, Vec2 target, Vec2 advected, bool free);
    bool correct(Vec2& point, Vec2 from) const;
    void resolveConflicts();
    void listNeighbours();
    bool inConflict(std::int32_t a, std::int32_t b) const;
    void chooseYielding(std::int32_t a, std::int32_t b);
    void lowerLevel(std::int32_t place);
    void relocateRoundRobin(std::span<const Vec2> targets, double tight);
    double strayDistance(std::span<const Vec2> targets) const;
    void listSearching(std::span<const Vec2> targets, std::int32_t first);
    bool flood();
    bool relocate(std::int32_t place, Vec2 target, std::int32_t& budget);
    bool tryPoint(std::int32_t place, Vec2 point);

    const FreeSpace& space_;
    double separation_;
    double attraction_;
    double stray_ = 0.0;  // Distance from its target beyond which a place in a wall leaps [m].
    ReachableTargets& s_;
    TargetUpdateMemory& m_;
};

}  // namespace muster
