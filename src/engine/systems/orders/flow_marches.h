// Marches that flow: plans them, and leads the places of groups along them (docs/method/march-stream.md).
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "base/cell_list.h"
#include "engine/formation/places/free_space.h"
#include "engine/orders/end_places.h"
#include "engine/orders/march.h"
#include "engine/orders/pairing.h"
#include "engine/orders/way_ground.h"
#include "engine/state/world_state.h"

namespace muster {

/// Leads marches that flow. Its functions are called by the stage of orders.
class FlowMarches {
public:
    /// Begins a step, in which plans may take about `operations` operations.
    void begin(std::int64_t operations) { budget_ = operations; }
    /// Begins a march of the group to `end` along a route [m], which begins and ends at about its middle; a
    /// `drawn` route is kept to. Places are paired with their ends again, so that no two agents cross.
    void start(WorldState& state, Group& group, const Pose& end, std::span<const Vec2> way,
               bool drawn = false);
    /// Begins a march in one piece, in which every member keeps its place. Where the ground has no room for
    /// it, it becomes a march that flows.
    void startPiece(WorldState& state, Group& group, const PieceDef& piece, bool drawn);
    /// True where a group that is sent to a point [m], for want of a route to the target of its order, would
    /// get nearer to the target by a sufficient share of its walk, or has to turn.
    bool pays(WorldState& state, Group& group, Vec2 at, std::optional<double> facing);
    /// Puts the places of the group at once where it is to stand, at the pose of its mesh; plans then decide
    /// who goes to which place by real walks.
    void stand(WorldState& state, Group& group);
    /// Lays places out again where the mesh of a group rests on ground that many of them cannot reach, or on
    /// the ground of groups with precedence. After a stop, places come to members that stand beside them.
    void settle(WorldState& state, Group& group);
    /// One step: plans, or moves places at most at `def.speed` times the speed of the ground, `offCourse` [m]
    /// off their course. False where the route is blocked; then the mesh leads, and stands at the end.
    bool advance(WorldState& state, const WayGround& ways, Group& group, const MarchDef& def,
                 Vec2 offCourse = {});
    /// True where the edits of this step leave the march of the group as it is.
    bool goesOn(const WorldState& state, Group& group) const;

private:
    double takeOffsets(const WorldState& state, const Group& group, std::vector<Vec2>& offsets);
    PlaceDef layOut(WorldState& state, Group& group, EndDef def, std::vector<Vec2>& ends, Pose& to);
    EndDef endsAt(const WorldState& state, const Group& group, const Pose& end,
                  std::span<const Vec2> offsets);
    bool findEnds(WorldState& state, Group& group, const Pose& end);
    void findStanding(const WorldState& state, const Group& group);
    static bool isInWalls(const Group& group);
    static void comeToStanding(const WorldState& state, Group& group);
    bool isOnOthers(const WorldState& state, const Group& group);
    void findTaken(const WorldState& state, const Group& group);
    FreeSpace spaceOf(WorldState& state, const Group& group, const PlaceDef& places);
    void findStarts(WorldState& state, const Group& group);
    void exchange(WorldState& state, Group& group, double reach);
    void keepSpeed(const WorldState& state, Group& group);
    bool stays(const WorldState& state, const Group& group) const;
    static void plan(WorldState& state, Group& group, Vec2 moves);
    void move(WorldState& state, Group& group, const MarchDef& def, Vec2 offCourse);

    std::int64_t budget_ = 0;
    EndPlaces endPlaces_;
    NearestReachable nearest_;
    Pairing pairing_;
    std::vector<std::int32_t> places_, regions_;
    std::vector<double> speeds_;
    std::vector<Vec2> taken_, together_, targets_, offsets_, starts_, way_;
    std::vector<Pose> poses_;
    CellList cells_;
    HeldGround held_;
};

}  // namespace muster
