// Orders: what groups are to do, one after the other, and how they behave meanwhile (SPEC B3, B11, B12, B14,
// B15).
#pragma once

#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "muster/formation.h"
#include "muster/generated/enumerations.h"
#include "muster/id.h"
#include "muster/obstacle.h"
#include "muster/vec2.h"

namespace muster {

/// One order of a group.
struct Order {
    OrderKind kind = OrderKind::Move;  ///< What it asks for.
    Vec2 target;                   ///< Centre of the formation at the end; of the rectangle for Guard [m].
    std::optional<double> facing;  ///< Heading at the end [rad]; none for that of the last stretch.
    /// Width of the front of a formation in ranks (square, line, column) [m], which becomes a square of so
    /// many files; 0 for its own. Other shapes keep theirs.
    double width = 0.0;
    std::vector<Vec2> route;  ///< Drawn way to the target [m]; followed as drawn, round obstacles.
    std::optional<FormationDef> formation;  ///< New formation, which is taken up on the way; none to keep it.
    Manner manner = Manner::March;          ///< How it goes.
    Turn turn = Turn::Flow;                 ///< How it turns on a march.
    double pace = 0.0;    ///< Speed of a march [m/s]; 0 for as fast as all can keep up with.
    double share = 0.95;  ///< Share of the group that must have arrived before the next order begins, (0, 1].
    GroupId group;        ///< For Follow and Guard: the group to stay with; none for a character or a place.
    std::uint32_t character = 0;  ///< For Follow and Guard: id of the character to stay with; 0 for none.
    Vec2 offset;                  ///< For Follow: from its centre to the formation's, in its axes [m].
    Vec2 halfSize;                ///< For Guard: half the length and half the width of the rectangle [m].
    TimedPath path;               ///< For Guard: how the rectangle moves from `target` on.
    std::vector<AreaId> exits;    ///< For Leave: by which exits; empty for all.
    ExitChoice choice = ExitChoice::Quickest;  ///< For Leave: by which of them each goes.
    /// For Leave: seconds by which each of `exits` counts as nearer than it is, -1e6 to 1e6; empty for none.
    std::vector<double> attractions;
    /// For Leave: seconds by which an exit counts as nearer if all others nearby choose it, 0 to 1e6.
    double herding = 0.0;
    /// For Leave: deviation of the error by which each misjudges the time by an exit [s], drawn by the
    /// world's seed, 0 to 1e6.
    double misjudgement = 0.0;
    AreaId area;           ///< For Wait: the waiting area.
    double seconds = 0.0;  ///< For Wait: how long, from when its share has come, 0 to 1e9; 0 for no end.

    /// Goes to `target` in formation.
    static Order move(Vec2 target, std::optional<double> facing = {}) {
        Order order;
        order.target = target;
        order.facing = facing;
        return order;
    }
    /// Takes up a front from `left` to `right` [m]: its middle, width and facing.
    static Order moveToLine(Vec2 left, Vec2 right);
    /// Goes to `target`, each by the shortest way.
    static Order go(Vec2 target, std::optional<double> facing = {}) {
        Order order = move(target, facing);
        order.manner = Manner::Free;
        return order;
    }
    /// Turns to a heading [rad].
    static Order face(double facing) {
        Order order;
        order.kind = OrderKind::Face;
        order.facing = facing;
        return order;
    }
    /// Follows a group, or a character.
    static Order follow(GroupId group, Vec2 offset) {
        Order order;
        order.kind = OrderKind::Follow;
        order.group = group;
        order.offset = offset;
        return order;
    }
    /// Follows a character.
    static Order followCharacter(std::uint32_t character, Vec2 offset) {
        Order order = follow({}, offset);
        order.character = character;
        return order;
    }
    /// Stands round a rectangle.
    static Order guard(Vec2 centre, Vec2 halfSize, double facing) {
        Order order;
        order.kind = OrderKind::Guard;
        order.target = centre;
        order.halfSize = halfSize;
        order.facing = facing;
        return order;
    }

    /// Leaves by exits: by the quickest of those named, of all where none is.
    static Order leave(std::vector<AreaId> exits = {}) {
        Order order;
        order.kind = OrderKind::Leave;
        order.exits = std::move(exits);
        return order;
    }
    /// Waits in an area for some seconds; 0 for no end.
    static Order wait(AreaId area, double seconds = 0.0) {
        Order order;
        order.kind = OrderKind::Wait;
        order.area = area;
        order.seconds = seconds;
        return order;
    }
    /// Walks on towards a heading [rad].
    static Order walk(double facing) {
        Order order = face(facing);
        order.kind = OrderKind::Walk;
        return order;
    }

    /// Lets an archive read or write the order.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, target, facing, width, route, formation, manner, turn, pace, share, group, character,
                offset, halfSize, path);
        archive.since(7, exits, choice, attractions, herding, misjudgement, area, seconds);
    }
};

/// An order in a group's queue.
struct QueuedOrder {
    std::uint32_t id = 0;  ///< Unique in the world; it is not used again.
    Order order;           ///< What is to be done.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(id, order);
    }
};

/// How a group behaves, whatever its orders.
struct Conduct {
    Stance stance = Stance::Normal;  ///< Who makes room.
    double cohesion = 0.0;  ///< 0: everybody walks at their own pace; 1: at that of the slowest, [0, 1].
    double squeeze = 1.0;  ///< Share of its width that it may give up in narrow passages, [0, 1]; 0 for none.
    bool avoids = false;   ///< True: its mesh gives way to other meshes and to moving obstacles (SPEC B3).

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(stance, cohesion, squeeze, avoids);
    }
    friend bool operator==(const Conduct&, const Conduct&) = default;
};

/// What would come of an order.
struct OrderForecast {
    bool arrives = false;   ///< True where the target can be reached.
    std::vector<Vec2> way;  ///< The way of the formation's centre, both ends included [m].
    Vec2 end;               ///< Where the formation would stand: the target, or the nearest ground to it [m].
    double seconds = 0.0;   ///< Time until it would arrive [s]; infinite where it never does.
};

}  // namespace muster
