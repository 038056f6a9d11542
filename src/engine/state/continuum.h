// Groups without places: their members go to one point by one cost field (Treuille, Cooper and Popovic 2006),
// or to areas, each on its own (docs/method/goals.md).
#pragma once

#include <algorithm>
#include <cstdint>
#include <utility>
#include <vector>

#include "base/archive.h"
#include "base/as_mutable.h"
#include "engine/assignment/planning/exact/unit_cost_archive.h"
#include "engine/fields/cost/unit_cost.h"
#include "muster/id.h"
#include "muster/order.h"
#include "muster/vec2.h"

namespace muster {

/// Where somebody stands who waits.
struct StandingSpot {
    std::uint32_t character = 0;  ///< Its id.
    Vec2 spot;                    ///< [m]

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(character, spot);
    }
};

/// The way through a door of somebody who leaves.
struct DoorWay {
    std::uint32_t character = 0;  ///< Its id.
    std::int32_t way = -1;        ///< -1 for the shortest.
    std::int32_t turns = 0;       ///< How often it has changed its mind.

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(character, way, turns);
    }
};

/// A group whose members have no places: they go to a point or to areas, or stand where they came to.
struct Gathering {
    GroupId group;                       ///< Whose members they are.
    OrderKind kind = OrderKind::Move;    ///< Move for one point; else Leave, Wait or Walk.
    Vec2 target;                         ///< For Move: where they go [m].
    AreaId area;                         ///< For Wait: where they stand.
    bool active = false;                 ///< They go; else all stand.
    std::uint32_t since = 0;             ///< For Wait: step in which enough had come; 0 while they have not.
    std::vector<std::uint32_t> arrived;  ///< Ids of those who have come near and stand, ascending.
    std::vector<StandingSpot> spots;     ///< For Wait: of those who have one, by ascending ids.
    std::uint32_t doors = 0;             ///< For Leave: key of the doors of `ways`; 0 for none.
    std::vector<DoorWay> ways;  ///< For Leave: of those who do not take the shortest, or have turned.

    /// True where the group has no formation meanwhile.
    bool isBare() const { return kind != OrderKind::Move; }
    /// Where somebody stands in the waiting area; null for who has no spot.
    const StandingSpot* spotOf(std::uint32_t id) const {
        const auto at = std::lower_bound(spots.begin(), spots.end(), id, isBefore);
        return at != spots.end() && at->character == id ? &*at : nullptr;
    }
    /// Gives somebody who has none a spot.
    void stand(std::uint32_t id, Vec2 spot) {
        spots.insert(std::lower_bound(spots.begin(), spots.end(), id, isBefore), {id, spot});
    }

    /// True for a member who has come near.
    bool hasArrived(std::uint32_t id) const { return std::binary_search(arrived.begin(), arrived.end(), id); }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, kind, target, area, active, since, arrived, spots);
        if (kind == OrderKind::Leave) archive(doors, ways);
    }

private:
    static bool isBefore(const StandingSpot& spot, std::uint32_t id) { return spot.character < id; }
};

/// True for orders that members carry out without a formation.
inline bool isBare(OrderKind kind) {
    return kind == OrderKind::Leave || kind == OrderKind::Wait || kind == OrderKind::Walk;
}

/// The unit cost of a class of ground as it was when fields were last solved.
struct FrozenCost {
    std::int32_t groundClass = 0;  ///< Whose it is.
    UnitCost cost;                 ///< With the crowd of that step.

    /// Lets an archive read or write it. Hashes leave the cells out, which follow from what was hashed then.
    template <class Archive>
    void visit(Archive& archive) {
        archive(groundClass);
        if constexpr (Archive::kReading) {
            if (!loadUnitCost(archive, cost)) archive.fail();
        } else if constexpr (requires { saveUnitCost(archive, cost); }) {
            saveUnitCost(archive, cost);
        } else {
            archive(cost.grid, cost.radius, cost.lowest);
        }
    }
};

/// All gatherings of a world, and what their fields are solved from.
struct Continuum {
    std::vector<Gathering> gatherings;  ///< In ascending order of groups.
    std::vector<FrozenCost> costs;      ///< In ascending order of classes.
    std::uint32_t frozenAt = 0;         ///< Step in which the costs were frozen.
    std::uint32_t groundEdits = 0;      ///< WorldState::groundEdits then.

    /// The gathering of a group; null where its members have places.
    const Gathering* find(GroupId group) const {
        const auto at = lowerBound(group);
        return at != gatherings.end() && at->group == group ? &*at : nullptr;
    }
    /// The same, to be changed.
    Gathering* find(GroupId group) {
        const Gathering* const found = std::as_const(*this).find(group);
        return found == nullptr ? nullptr : &asMutable(*found);
    }
    /// A group goes to `target`, and has no places from now on.
    void begin(GroupId group, Vec2 target) { begin(group, OrderKind::Move, {}).target = target; }
    /// The members of a group go to areas, or on; the group has no formation from now on unless `kind` is
    /// Move.
    Gathering& begin(GroupId group, OrderKind kind, AreaId area) {
        Gathering* found = find(group);
        if (found == nullptr) found = &*gatherings.insert(lowerBound(group), Gathering{});
        *found = {};
        found->group = group;
        found->kind = kind;
        found->area = area;
        found->active = true;
        return *found;
    }
    /// True for a group that has no formation now.
    bool isBare(GroupId group) const {
        const Gathering* const found = find(group);
        return found != nullptr && found->isBare();
    }
    /// The members of a group have places again, if they had none.
    void end(GroupId group) {
        std::erase_if(gatherings, [&](const Gathering& g) { return g.group == group; });
    }
    /// A part of a group goes on like the whole.
    void share(GroupId whole, GroupId part) {
        if (const Gathering* found = find(whole)) {
            Gathering copy = *found;
            copy.group = part;
            gatherings.insert(lowerBound(part), std::move(copy));
        }
    }

    /// Lets an archive read or write all.
    template <class Archive>
    void visit(Archive& archive) {
        archive(gatherings, costs, frozenAt, groundEdits);
    }

private:
    std::vector<Gathering>::const_iterator lowerBound(GroupId group) const {
        return std::lower_bound(gatherings.begin(), gatherings.end(), group,
                                [](const Gathering& g, GroupId id) { return g.group.value < id.value; });
    }
};

}  // namespace muster
