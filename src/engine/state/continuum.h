// Groups without places, whose members go to one point by one cost field (Treuille, Cooper and Popovic 2006).
#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "base/archive.h"
#include "engine/assignment/planning/exact/unit_cost_archive.h"
#include "engine/fields/cost/unit_cost.h"
#include "muster/id.h"
#include "muster/vec2.h"

namespace muster {

/// A group whose members have no places: they go to a point, or stand where they came to.
struct Gathering {
    GroupId group;                       ///< Whose members they are.
    Vec2 target;                         ///< Where they go [m].
    bool active = false;                 ///< They go; else all stand.
    std::vector<std::uint32_t> arrived;  ///< Ids of those who have come near and stand, ascending.

    /// True for a member who has come near.
    bool hasArrived(std::uint32_t id) const { return std::binary_search(arrived.begin(), arrived.end(), id); }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, target, active, arrived);
    }
};

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
        return const_cast<Gathering*>(static_cast<const Continuum&>(*this).find(group));
    }
    /// A group goes to `target`, and has no places from now on.
    void begin(GroupId group, Vec2 target) {
        Gathering* found = find(group);
        if (found == nullptr) found = &*gatherings.insert(lowerBound(group), Gathering{group, {}, false, {}});
        found->target = target;
        found->active = true;
        found->arrived.clear();
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
