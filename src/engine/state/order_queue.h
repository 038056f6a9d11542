// The orders of a group, and how far it is with the first of them.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "engine/orders/march.h"
#include "muster/order.h"

namespace muster {

/// What a group is to do, one after the other.
struct OrderQueue {
    std::vector<QueuedOrder> orders;  ///< The first one is carried out.
    bool held = false;                ///< It waits.
    bool patrols = false;             ///< Orders that are done come last again.
    bool begun = false;               ///< The first order has begun.
    bool reachable = true;            ///< Its target can be reached.
    std::uint32_t ground = 0;         ///< Version of the ground for which that was found.
    std::uint32_t begunAt = 0;        ///< Step in which it began.
    std::uint32_t stoodAt = 0;        ///< Step in which somebody last got nearer to the end of it.
    std::int32_t arrived = 0;         ///< Most who have arrived so far.
    Vec2 target;                      ///< Where the formation goes [m].
    March march;                      ///< How it goes there.
    std::optional<FormationDef>
        own;  ///< The formation to take up again, where it has another one for a while.

    /// True while everybody goes to the target of an order by its own way: places are there already.
    bool goesFree() const {
        return begun && !orders.empty() && orders.front().order.kind == OrderKind::Move &&
               orders.front().order.manner == Manner::Free;
    }
    /// Forgets the order that is carried out, so that the next one can begin.
    void end() {
        begun = false;
        march.phase = MarchPhase::Idle;
        march.searched = 0;
        march.next = 0;
        march.way.clear();
        march.legs.clear();
        arrived = 0;
    }

    /// Lets an archive read or write it.
    template <class Archive>
    void visit(Archive& archive) {
        archive(orders, held, patrols, begun, reachable, ground, begunAt, stoodAt, arrived, target, march,
                own);
    }
};

}  // namespace muster
