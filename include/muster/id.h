// Typed ids, and the indices of motions.
#pragma once

#include <cstdint>

namespace muster {

/// A number that names one thing of one kind for as long as the world lives; 0 names nothing.
/// Ids are given in ascending order and never used again.
template <class Tag>
struct Id {
    std::uint32_t value = 0;  ///< 0 for none.

    /// True where it names something.
    explicit operator bool() const { return value != 0; }
    friend bool operator==(const Id&, const Id&) = default;
    friend auto operator<=>(const Id&, const Id&) = default;

    /// Lets an archive read or write the id.
    template <class Archive>
    void visit(Archive& archive) {
        archive(value);
    }
};

/// Index of a motion clip in the world's table of clips; 0 is running in the open.
using MotionId = std::int32_t;

using ObstacleId = Id<struct ObstacleTag>;      ///< Names an obstacle.
using PatchId = Id<struct PatchTag>;            ///< Names a patch.
using GroupId = Id<struct GroupTag>;            ///< Names a group.
using ItemId = Id<struct ItemTag>;              ///< Names an item.
using CheckpointId = Id<struct CheckpointTag>;  ///< Names a formation checkpoint.
using AreaId = Id<struct AreaTag>;              ///< Names an exit, a source or a waiting area.
using ControlId = Id<struct ControlTag>;        ///< Names a control.

}  // namespace muster
