// Makes a selection of characters one group, and gives it orders.
#pragma once

#include <cstdint>
#include <vector>

#include "studio/gestures/control_scheme.h"

namespace muster {

/// Sends characters of any groups to points. Those who were not one group before become one, which takes a
/// step.
class Sender {
public:
    explicit Sender(SchemeMovement movement) : movement_(movement) {}

    /// Sends the characters of these ids, ascending, to a point [m]; `add`: after what they have been sent to
    /// already. False where none of them is there.
    bool send(const World& world, std::span<const std::uint32_t> ids, Vec2 to, bool add,
              std::vector<CommandBody>& commands);
    /// They stand where they are.
    void stop(const World& world, std::span<const std::uint32_t> ids, std::vector<CommandBody>& commands);
    /// Call before every step: goes on with what waited for a new group.
    void beforeStep(const World& world, std::vector<CommandBody>& commands);
    /// True while it waits for a step.
    bool busy() const { return !pending_.empty(); }

private:
    /// Characters that a group is being made for, and the points that it will be sent to.
    struct Pending {
        std::vector<std::uint32_t> ids;
        std::vector<Vec2> points;
        std::vector<bool> adds;
        GroupId whole;           ///< From which the new group is split off.
        std::uint32_t step = 0;  ///< In which that was asked for.
    };
    void order(GroupId group, Vec2 to, bool add, std::vector<CommandBody>& commands) const;
    void gather(const World& world, GroupId into, std::span<const std::uint32_t> ids,
                std::vector<CommandBody>& commands) const;

    SchemeMovement movement_;
    std::vector<Pending> pending_;
};

}  // namespace muster
