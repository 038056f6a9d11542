// Commands that give orders.
#pragma once

#include <cstdint>

#include "muster/id.h"
#include "muster/order.h"

namespace muster {

/// Puts an order into a group's queue. The event OrderGiven tells its id.
struct GiveOrder {
    GroupId group;                        ///< Who.
    QueueMode mode = QueueMode::Replace;  ///< Where it stands in the queue.
    std::uint32_t index = 0;              ///< For Insert: before which order, counted from 0.
    Order order;                          ///< What.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, mode, index, order);
    }
};
/// Changes a group's queue.
struct EditQueue {
    GroupId group;                       ///< Whose.
    QueueEdit edit = QueueEdit::Cancel;  ///< What is done to it.
    std::uint32_t order = 0;             ///< For Cancel: the id of the order; 0 for all.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, edit, order);
    }
};
/// Tells a group how to behave.
struct SetConduct {
    GroupId group;    ///< Whom.
    Conduct conduct;  ///< How.

    /// Lets an archive read or write the command.
    template <class Archive>
    void visit(Archive& archive) {
        archive(group, conduct);
    }
};

}  // namespace muster
