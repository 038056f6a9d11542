// Made by schema/generate.mjs from schema/definitions.txt: change these, not this file.
// What groups are to do, one after the other, and how they behave meanwhile (SPEC B3, B11, B12, B14, B15).
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "muster/generated/enumerations.h"
#include "muster/generated/ground_definitions.h"
#include "muster/geometry.h"
#include "muster/id.h"
#include "muster/vec2.h"

namespace muster {

/// Describes a formation in its local axes: it faces +x, its centre is the origin.
struct FormationDef {
    FormationKind kind = FormationKind::Square;  ///< Shape.
    double spacing = 1.0;                        ///< Distance between neighbouring places, 0.05 to 100 [m].
    double opening = 1.2;                        ///< Full angle of Pacman's mouth or of the crescent's gap,
                                                 ///< above 0 and at most 6 [rad].
    PolygonWithHoles outline;                    ///< For Outline: the shape, in any size [m].
    std::vector<Vec2> points;                    ///< For Points: the places in this order [m]; at least as
                                                 ///< many as characters.
    std::int32_t files = 0;                      ///< For Square: how many stand abreast, 0 to 200,000; 0 for
                                                 ///< about as many as there are ranks.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, spacing, opening, outline, points);
        archive.since(2, files);
    }
    /// Equal in all parts.
    friend bool operator==(const FormationDef&, const FormationDef&) = default;
};

/// One order of a group.
struct Order {
    OrderKind kind = OrderKind::Move;          ///< What it asks for.
    Vec2 target;                               ///< Centre of the formation at the end [m]; of the rectangle
                                               ///< for Guard.
    std::optional<double> facing;              ///< Heading at the end [rad]; none for that of the last
                                               ///< stretch.
    double width = 0.0;                        ///< Width of the front of a formation in ranks (square, line,
                                               ///< column), which becomes a square of so many files [m]; 0
                                               ///< for its own. Other shapes keep theirs.
    std::vector<Vec2> route;                   ///< Drawn way to the target [m]; followed as drawn, round
                                               ///< obstacles.
    std::optional<FormationDef> formation;     ///< New formation, which is taken up on the way; none to keep
                                               ///< it.
    Manner manner = Manner::March;             ///< How it goes.
    Turn turn = Turn::Flow;                    ///< How it turns on a march.
    double pace = 0.0;                         ///< Speed of a march [m/s]; 0 for as fast as all can keep up
                                               ///< with.
    double share = 0.95;                       ///< Share of the group that must have arrived before the next
                                               ///< order begins, (0, 1].
    GroupId group;                             ///< For Follow and Guard: the group to stay with; none for a
                                               ///< character or a place.
    std::uint32_t character = 0;               ///< For Follow and Guard: id of the character to stay with; 0
                                               ///< for none.
    Vec2 offset;                               ///< For Follow: from its centre to the formation's, in its
                                               ///< axes [m].
    Vec2 halfSize;                             ///< For Guard: half the length and half the width of the
                                               ///< rectangle [m].
    TimedPath path;                            ///< For Guard: how the rectangle moves from `target` on.
    std::vector<AreaId> exits;                 ///< For Leave: by which exits; empty for all.
    ExitChoice choice = ExitChoice::Quickest;  ///< For Leave: by which of them each goes.
    std::vector<double> attractions;           ///< For Leave: seconds by which each of `exits` counts as
                                               ///< nearer than it is, -1e6 to 1e6 [s]; empty for none.
    double herding = 0.0;                      ///< For Leave: seconds by which an exit counts as nearer if
                                               ///< all others nearby choose it, 0 to 1e6 [s].
    double misjudgement = 0.0;                 ///< For Leave: deviation of the error by which each misjudges
                                               ///< the time by an exit, drawn by the world's seed, 0 to 1e6
                                               ///< [s].
    AreaId area;                               ///< For Wait: the waiting area.
    double seconds = 0.0;                      ///< For Wait: how long, from when its share has come, 0 to 1e9
                                               ///< [s]; 0 for no end.

    /// Goes to `target` in formation.
    static Order move(Vec2 target, std::optional<double> facing = {});
    /// Takes up a front from `left` to `right` [m]: its middle, width and facing.
    static Order moveToLine(Vec2 left, Vec2 right);
    /// Goes to `target`, each by the shortest way.
    static Order go(Vec2 target, std::optional<double> facing = {});
    /// Turns to a heading [rad].
    static Order face(double facing);
    /// Follows a group.
    static Order follow(GroupId group, Vec2 offset);
    /// Follows a character.
    static Order followCharacter(std::uint32_t character, Vec2 offset);
    /// Stands round a rectangle.
    static Order guard(Vec2 centre, Vec2 halfSize, double facing);
    /// Leaves by exits: by the quickest of those named, of all where none is.
    static Order leave(std::vector<AreaId> exits = {});
    /// Waits in an area for some seconds; 0 for no end.
    static Order wait(AreaId area, double seconds = 0.0);
    /// Walks on towards a heading [rad].
    static Order walk(double facing);

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(kind, target, facing, width, route, formation, manner, turn, pace, share, group, character,
                offset, halfSize, path);
        archive.since(7, exits, choice, attractions, herding, misjudgement, area, seconds);
    }
    /// Equal in all parts.
    friend bool operator==(const Order&, const Order&) = default;
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
    /// Equal in all parts.
    friend bool operator==(const QueuedOrder&, const QueuedOrder&) = default;
};

/// How a group behaves, whatever its orders.
struct Conduct {
    Stance stance = Stance::Normal;  ///< Who makes room.
    double cohesion = 0.0;           ///< 0: everybody walks at their own pace; 1: at that of the slowest, [0,
                                     ///< 1].
    double squeeze = 1.0;            ///< Share of its width that it may give up in narrow passages, [0, 1]; 0
                                     ///< for none.
    bool avoids = false;             ///< True: its mesh gives way to other meshes and to moving obstacles
                                     ///< (SPEC B3).

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(stance, cohesion, squeeze, avoids);
    }
    /// Equal in all parts.
    friend bool operator==(const Conduct&, const Conduct&) = default;
};

}  // namespace muster
