#include "studio/session/history/queue_state.h"

#include <algorithm>

namespace muster {
namespace {

/// The order of that id; null where the queue has none.
const QueuedOrder* orderOf(const QueueState& queue, std::uint32_t id) {
    const auto at = std::find_if(queue.orders.begin(), queue.orders.end(),
                                 [&](const QueuedOrder& one) { return one.id == id; });
    return at == queue.orders.end() ? nullptr : &*at;
}

bool sameOrder(const QueuedOrder& a, const QueuedOrder& b) {
    return sameBody(GiveOrder{{}, {}, 0, a.order}, GiveOrder{{}, {}, 0, b.order});
}

/// Where an order of `to` belongs among others: before the first that follows it there, or last.
std::vector<QueuedOrder>::iterator placeOf(QueueState& queue, const QueueState& to, std::size_t k) {
    for (std::size_t next = k + 1; next < to.orders.size(); ++next) {
        const auto at = std::find_if(queue.orders.begin(), queue.orders.end(),
                                     [&](const QueuedOrder& one) { return one.id == to.orders[next].id; });
        if (at != queue.orders.end()) return at;
    }
    return queue.orders.end();
}

/// Adds the commands of one queue.
class QueueLead {
public:
    QueueLead(GroupId group, const QueueState& now, const QueueState& wanted, Names& names, Batch& batch)
        : group_(group),
          now_(now),
          wanted_(wanted),
          names_(names),
          batch_(batch),
          held_(now.held),
          patrols_(now.patrols) {}

    void add() {
        for (const QueuedOrder& order : now_.orders)
            if (const QueuedOrder* same = orderOf(wanted_, order.id);
                same != nullptr && sameOrder(*same, order))
                kept_.push_back(order.id);
        if (!inOrder()) kept_.clear();
        if (kept_.empty())
            replaceAll();
        else
            change();
        mark(held_, wanted_.held, QueueEdit::Hold, QueueEdit::Resume);
        mark(patrols_, wanted_.patrols, QueueEdit::Patrol, QueueEdit::EndPatrol);
    }

private:
    bool keeps(std::uint32_t id) const { return std::find(kept_.begin(), kept_.end(), id) != kept_.end(); }

    /// True where the orders that stay follow each other as they are to.
    bool inOrder() const {
        auto next = kept_.begin();
        for (const QueuedOrder& order : wanted_.orders)
            if (next != kept_.end() && order.id == *next) ++next;
        return next == kept_.end();
    }

    void replaceAll() {
        for (std::size_t k = 0; k < wanted_.orders.size(); ++k)
            give(k, k == 0 ? QueueMode::Replace : QueueMode::Append, 0);
        if (!wanted_.orders.empty())
            held_ = patrols_ = false;
        else if (!now_.orders.empty())
            batch_.bodies.push_back(EditQueue{group_, QueueEdit::Cancel, 0});
    }

    void change() {
        for (const QueuedOrder& order : now_.orders)
            if (!keeps(order.id)) batch_.bodies.push_back(EditQueue{group_, QueueEdit::Cancel, order.id});
        for (std::size_t k = 0; k < wanted_.orders.size(); ++k)
            if (!keeps(wanted_.orders[k].id)) give(k, QueueMode::Insert, static_cast<std::uint32_t>(k));
    }

    void give(std::size_t k, QueueMode mode, std::uint32_t index) {
        const QueuedOrder& order = wanted_.orders[k];
        batch_.births.push_back(
            {batch_.bodies.size(), SubjectKind::Order, {names_.nameOf(SubjectKind::Order, order.id)}});
        batch_.bodies.push_back(GiveOrder{group_, mode, index, order.order});
    }

    void mark(bool is, bool wanted, QueueEdit on, QueueEdit off) {
        if (is != wanted) batch_.bodies.push_back(EditQueue{group_, wanted ? on : off, 0});
    }

    GroupId group_;
    const QueueState& now_;
    const QueueState& wanted_;
    Names& names_;
    Batch& batch_;
    std::vector<std::uint32_t> kept_;
    bool held_, patrols_;
};

}  // namespace

bool sameBody(const CommandBody& a, const CommandBody& b) {
    return a.index() == b.index() && encodeCommand({0, 0, 0, a}) == encodeCommand({0, 0, 0, b});
}

bool sameOrders(const QueueState& a, const QueueState& b) {
    return std::equal(a.orders.begin(), a.orders.end(), b.orders.begin(), b.orders.end(), sameOrder);
}

bool sameQueue(const QueueState& a, const QueueState& b) {
    const auto same = [](const QueuedOrder& x, const QueuedOrder& y) {
        return x.id == y.id && sameOrder(x, y);
    };
    return a.held == b.held && a.patrols == b.patrols &&
           std::equal(a.orders.begin(), a.orders.end(), b.orders.begin(), b.orders.end(), same);
}

QueueState queueOf(const GroupView& group) {
    return {{group.orders.begin(), group.orders.end()}, group.held, group.patrols};
}

bool shapes(const Order& order) {
    return order.formation || order.width > 0.0 || order.kind == OrderKind::Guard;
}

GroupId queueChangedBy(const CommandBody& body) {
    if (const auto* give = std::get_if<GiveOrder>(&body)) return give->group;
    if (const auto* edit = std::get_if<EditQueue>(&body)) return edit->group;
    if (const auto* set = std::get_if<SetPose>(&body)) return set->group;
    return {};
}

void apply(QueueState& queue, const CommandBody& body, std::uint32_t id) {
    std::vector<QueuedOrder>& orders = queue.orders;
    if (const auto* give = std::get_if<GiveOrder>(&body)) {
        if (give->mode == QueueMode::Replace) queue = {};
        const std::size_t at = give->mode == QueueMode::Insert
                                   ? std::min<std::size_t>(give->index, orders.size())
                                   : orders.size();
        orders.insert(orders.begin() + static_cast<std::ptrdiff_t>(at), {id, give->order});
        return;
    }
    const auto* edit = std::get_if<EditQueue>(&body);
    if (edit == nullptr || edit->edit == QueueEdit::Stop) {
        queue = {};
        return;
    }
    if (edit->edit == QueueEdit::Cancel)
        std::erase_if(orders,
                      [&](const QueuedOrder& one) { return edit->order == 0 || one.id == edit->order; });
    if (edit->edit == QueueEdit::Hold || edit->edit == QueueEdit::Resume)
        queue.held = edit->edit == QueueEdit::Hold;
    if (edit->edit == QueueEdit::Patrol || edit->edit == QueueEdit::EndPatrol)
        queue.patrols = edit->edit == QueueEdit::Patrol;
}

namespace {

/// Where the difference changes the order of those that stay, they stand among each other as in `to`.
void arrange(QueueState& wanted, const QueueState& from, const QueueState& to) {
    std::vector<std::uint32_t> before, after;
    for (const QueuedOrder& order : from.orders)
        if (orderOf(to, order.id) != nullptr) before.push_back(order.id);
    for (const QueuedOrder& order : to.orders)
        if (orderOf(from, order.id) != nullptr) after.push_back(order.id);
    if (before == after) return;
    std::vector<QueuedOrder> moved;
    for (const std::uint32_t id : after)
        if (const QueuedOrder* const order = orderOf(wanted, id)) moved.push_back(*order);
    auto next = moved.begin();
    for (QueuedOrder& order : wanted.orders)
        if (std::find(after.begin(), after.end(), order.id) != after.end()) order = *next++;
}

}  // namespace

QueueState merged(const QueueState& now, const QueueState& from, const QueueState& to) {
    const bool known = std::any_of(now.orders.begin(), now.orders.end(),
                                   [&](const QueuedOrder& one) { return orderOf(from, one.id) != nullptr; });
    if (!known && !now.orders.empty() && !from.orders.empty()) return now;
    QueueState wanted;
    for (const QueuedOrder& order : now.orders) {
        const QueuedOrder* is = orderOf(to, order.id);
        if (is == nullptr && orderOf(from, order.id) != nullptr) continue;
        wanted.orders.push_back(is == nullptr ? order : *is);
    }
    arrange(wanted, from, to);
    // From the last one on, so that each finds those that stand behind it.
    for (std::size_t k = to.orders.size(); k-- > 0;) {
        const QueuedOrder& order = to.orders[k];
        if (orderOf(from, order.id) != nullptr || orderOf(wanted, order.id) != nullptr) continue;
        wanted.orders.insert(placeOf(wanted, to, k), order);
    }
    wanted.held = from.held == to.held ? now.held : to.held;
    wanted.patrols = from.patrols == to.patrols ? now.patrols : to.patrols;
    return wanted;
}

void lead(GroupId group, const QueueState& now, const QueueState& wanted, Names& names, Batch& batch) {
    if (!sameQueue(now, wanted)) QueueLead(group, now, wanted, names, batch).add();
}

void toNames(QueueState& queue, Names& names) {
    for (QueuedOrder& order : queue.orders) names.toNames(order);
}

void toIds(QueueState& queue, const Names& names) {
    for (QueuedOrder& order : queue.orders) names.toIds(order);
}

std::size_t bytesOf(const QueueState& queue) {
    std::size_t bytes = 0;
    for (const QueuedOrder& order : queue.orders)
        bytes += encodeCommand({0, 0, 0, GiveOrder{{}, {}, 0, order.order}}).size();
    return bytes;
}

}  // namespace muster
