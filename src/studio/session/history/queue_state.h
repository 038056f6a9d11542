// The queue of a group at one moment, and how it changes.
#pragma once

#include <cstdint>
#include <vector>

#include "muster/command.h"
#include "muster/world.h"
#include "studio/session/history/names.h"

namespace muster {

/// A group's queue at one moment.
struct QueueState {
    std::vector<QueuedOrder> orders;
    bool held = false;
    bool patrols = false;
};

/// What a command of a batch brings: the thing that gets an id, or characters in their order.
struct Birth {
    std::size_t body = 0;  ///< Index of the command.
    SubjectKind kind = SubjectKind::Order;
    std::vector<std::uint32_t> names;
};

/// Commands, and what they bring.
struct Batch {
    std::vector<CommandBody> bodies;
    std::vector<Birth> births;
};

/// True where both are equal in all parts.
bool sameBody(const CommandBody& a, const CommandBody& b);
/// True where both hold the same orders in the same order, whatever their ids are.
bool sameOrders(const QueueState& a, const QueueState& b);
bool sameQueue(const QueueState& a, const QueueState& b);
QueueState queueOf(const GroupView& group);
/// True where the formation of a group is another one while, or after, it carries out the order.
bool shapes(const Order& order);
/// The group of the queue that a command changes; none for other commands.
GroupId queueChangedBy(const CommandBody& body);
/// Changes the queue as the world will; an order that is given has that id.
void apply(QueueState& queue, const CommandBody& body, std::uint32_t id);
/// The queue as it is now with what leads from one queue to another. What is done stays done, and where
/// others have given all orders since, these stay.
QueueState merged(const QueueState& now, const QueueState& from, const QueueState& to);
/// Adds the commands that lead from one queue of the group to another. Orders of other ids are new ones.
void lead(GroupId group, const QueueState& now, const QueueState& wanted, Names& names, Batch& batch);
/// Puts names in the place of ids, or ids in the place of names.
void toNames(QueueState& queue, Names& names);
void toIds(QueueState& queue, const Names& names);
std::size_t bytesOf(const QueueState& queue);

}  // namespace muster
