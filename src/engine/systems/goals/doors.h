// The doors between people and exits, the walks to them, and where they lead (docs/method/goals.md).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "base/infinite_cost.h"
#include "engine/passages/door_search.h"
#include "engine/passages/walk_field.h"
#include "engine/passages/way_number.h"
#include "engine/state/world_state.h"
#include "engine/systems/goals/goal_fields.h"

namespace muster {

/// All doors at which a person who leaves may have a choice. A cache: it follows from the static ground for
/// bodies of the usual size and from the polygons of all exits.
class Doors {
public:
    /// Forgets all.
    void reset() { *this = Doors(); }
    /// Finds the doors again where ground or exits have changed.
    void update(const WorldState& state, GoalFields& fields);
    /// True where there are any.
    bool any() const { return !plan_.doors.empty(); }
    /// Number of ways through the doors: way_number.h.
    std::size_t ways() const { return wayCount(plan_.doors.size()); }
    /// Tells these doors from others; 0 where there are none.
    std::uint32_t key() const { return key_; }
    /// The door of a way.
    const Passage& door(std::int32_t way) const { return plan_.doors[passageOf(way)]; }
    /// True where moving obstacles fill a door now.
    bool isShut(std::int32_t way) const { return shut_[passageOf(way)] != 0; }

    /// The costs and ways that lead to one exit.
    struct ToExit {
        std::vector<double> onward;         ///< By way: cost from its door to the exit; infinite for none.
        std::vector<std::uint8_t> inRoom;   ///< By room: 1 where the exit is in it.
        std::vector<std::int16_t> nearest;  ///< By cell: the way of the shortest walk; -1 for no door.
        double free = kInfiniteCost;        ///< Cost from the nearest door whose room has the exit.
    };
    /// The costs to an exit, whose field is `field`. They hold until the next update().
    const ToExit& toExit(const Area& exit, const GoalField& field);

    /// The way of the shortest walk from a point to an exit; -1 for no door.
    std::int32_t nearestWay(const ToExit& to, Vec2 p) const {
        return to.nearest[grid_.index(grid_.nearestCell(p))];
    }
    /// The ways that lead out of the room at a point; none in walls.
    std::span<const std::int32_t> waysFrom(Vec2 p) const {
        const std::int32_t room = plan_.room[grid_.index(grid_.nearestCell(p))];
        return room < 0 ? std::span<const std::int32_t>() : std::span(waysFrom_[room]);
    }
    /// Cost of the walk from a point to the door of a way; infinite for a point on the other side.
    double walk(std::int32_t way, Vec2 p) const;
    /// True for a point behind the door of a way.
    bool isBehind(std::int32_t way, Vec2 p) const {
        return walks_[passageOf(way)].at(p).side == sideBehind(way);
    }
    /// True where the room behind a way has the exit.
    bool leadsTo(std::int32_t way, const ToExit& to) const { return to.inRoom[behind(way)] != 0; }
    /// A way that follows another one, and the walk between the doors.
    struct Next {
        std::int32_t way = 0;
        double cost = 0.0;
    };
    /// The ways through other doors that follow a way.
    std::span<const Next> next(std::int32_t way) const { return next_[way]; }

    /// The field that leads to the door of a way and through it; valid if it was prepared in this step.
    const GoalField& field(std::int32_t way) const { return *fields_[way]; }
    /// Solves the field of a way where it is not known.
    void prepareField(std::int32_t way, GoalFields& fields);

private:
    std::int32_t before(std::int32_t way) const {
        return plan_.beside[passageOf(way)][fromLeft(way) ? 1 : 0];
    }
    std::int32_t behind(std::int32_t way) const {
        return plan_.beside[passageOf(way)][fromLeft(way) ? 0 : 1];
    }
    Vec2 pointBehind(std::int32_t way, double away) const;
    void solveWalks(const UnitCost& unitCost);
    void findShut(const WorldState& state);
    void findOnward(const GoalField& field, ToExit& to) const;
    void findNearest(ToExit& to) const;

    std::uint32_t version_ = ~0u;  // Version of the ground.
    std::vector<std::uint32_t> ids_;
    std::vector<Polygon> exits_;
    std::uint32_t key_ = 0;
    Grid grid_;
    DoorPlan plan_;
    DoorSearch search_;
    WalkSolver solver_;
    std::vector<WalkField> walks_;                     // By door.
    std::vector<std::vector<std::int32_t>> waysFrom_;  // By room.
    std::vector<std::vector<Next>> next_;              // By way.
    std::vector<std::unique_ptr<ToExit>> toExit_;      // By exit; null where nobody has asked.
    std::vector<std::unique_ptr<GoalField>> fields_;   // By way.
    std::vector<std::uint8_t> shut_;                   // By door.
    EikonalSolver eikonal_;
};

}  // namespace muster
