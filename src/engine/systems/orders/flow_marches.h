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

/// Leads groups. Its functions are called by the stage of orders.
class FlowMarches {
public:
    /// Begins a step, in which plans may take about so many operations.
    void begin(std::int64_t operations) { budget_ = operations; }
    /// Begins a march of the group to `end` along `way` [m], which is kept to or not, and begins and ends at
    /// about its middle. Who goes to which place of it is found again, so that nobody crosses the way of
    /// others.
    void start(WorldState& state, Group& group, const Pose& end, std::span<const Vec2> way,
               bool drawn = false);
    /// Begins one in one piece, in which everybody keeps the own place, to where that leads. Where the ground
    /// has no room for it, it becomes one that flows.
    void startPiece(WorldState& state, Group& group, const PieceDef& piece, bool drawn);
    /// True where the group, sent to a point [m] for want of a way to the target of its order, would come
    /// nearer to that by enough of its walk from where it stands or goes, or has to turn.
    bool pays(WorldState& state, Group& group, Vec2 at, std::optional<double> facing);
    /// Puts the places of the group where it is to stand, at the pose of its mesh, at once: what each will
    /// really walk says who goes to which.
    void stand(WorldState& state, Group& group);
    /// Lays the places of a group out on the ground whose mesh rests where many of them cannot be, or where
    /// others stand who were there before. After a stop places come to those who stand beside them.
    void settle(WorldState& state, Group& group);
    /// One step: plans, or moves places at most at `def.speed` times the speed of the ground, so far
    /// `offCourse` of their course [m]. False where the way is blocked; then the mesh leads, and stands at
    /// the end.
    bool advance(WorldState& state, const WayGround& ways, Group& group, const MarchDef& def,
                 Vec2 offCourse = {});
    /// True where the march of the group stays as it is on the ground as it was edited in this step.
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
