#include "studio/session/history/crowd_change.h"

#include <algorithm>
#include <map>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/place_edit.h"

namespace muster {
namespace {

bool names(const std::vector<QueuedOrder>& orders, std::uint32_t id) {
    return std::any_of(orders.begin(), orders.end(), [&](const QueuedOrder& one) { return one.id == id; });
}

/// True where the formation of the group is another one while, or after, it carries out the order.
bool shapes(const Order& order) {
    return order.formation || order.width > 0.0 || order.kind == OrderKind::Guard;
}

/// One change of a queue, from a change of the crowd to commands.
class QueueCommands {
public:
    QueueCommands(const QueueChange& crowdChange, const GroupView& now, CrowdCommands& commands)
        : crowdChange_(crowdChange), now_(now), commands_(commands), held_(now.held), patrols_(now.patrols) {}

    void add() {
        std::vector<std::uint32_t> lost;
        for (const QueuedOrder& order : now_.orders) {
            const bool goes = names(crowdChange_.before.orders, order.id) &&
                              !names(crowdChange_.after.orders, order.id);
            (goes ? lost : kept_).push_back(order.id);
        }
        std::vector<std::size_t> back;
        for (std::size_t k = 0; k < crowdChange_.after.orders.size(); ++k) {
            const std::uint32_t id = crowdChange_.after.orders[k].id;
            if (!names(crowdChange_.before.orders, id) &&
                std::find(kept_.begin(), kept_.end(), id) == kept_.end())
                back.push_back(k);
        }
        if (isOfOthers(lost)) return;
        if (kept_.empty())
            replaceAll(back, !lost.empty());
        else
            change(lost, back);
        mark(crowdChange_.before.held, crowdChange_.after.held, held_, now_.held, QueueEdit::Hold,
             QueueEdit::Resume);
        mark(crowdChange_.before.patrols, crowdChange_.after.patrols, patrols_, now_.patrols,
             QueueEdit::Patrol, QueueEdit::EndPatrol);
    }

private:
    /// True where others have given the group all its orders since.
    bool isOfOthers(const std::vector<std::uint32_t>& lost) const {
        if (!lost.empty() || kept_.empty() || crowdChange_.before.orders.empty()) return false;
        return std::none_of(kept_.begin(), kept_.end(),
                            [&](std::uint32_t id) { return names(crowdChange_.before.orders, id); });
    }

    void replaceAll(const std::vector<std::size_t>& back, bool stops) {
        for (const std::size_t k : back)
            give(k, k == back.front() ? QueueMode::Replace : QueueMode::Append, 0);
        if (!back.empty())
            held_ = patrols_ = false;
        else if (stops)
            commands_.bodies.push_back(EditQueue{crowdChange_.group, QueueEdit::Cancel, 0});
    }

    void change(const std::vector<std::uint32_t>& lost, const std::vector<std::size_t>& back) {
        for (const std::uint32_t id : lost)
            commands_.bodies.push_back(EditQueue{crowdChange_.group, QueueEdit::Cancel, id});
        // From the last one on, so that each finds those that stand behind it.
        for (auto k = back.rbegin(); k != back.rend(); ++k) {
            auto before = kept_.end();
            for (std::size_t next = *k + 1; next < crowdChange_.after.orders.size() && before == kept_.end();
                 ++next)
                before = std::find(kept_.begin(), kept_.end(), crowdChange_.after.orders[next].id);
            give(*k, QueueMode::Insert, static_cast<std::uint32_t>(before - kept_.begin()));
            kept_.insert(before, crowdChange_.after.orders[*k].id);
        }
    }

    void give(std::size_t k, QueueMode mode, std::uint32_t index) {
        const QueuedOrder& order = crowdChange_.after.orders[k];
        commands_.orders.push_back({commands_.bodies.size(), order.id});
        commands_.bodies.push_back(GiveOrder{crowdChange_.group, mode, index, order.order});
    }

    /// `is`: after the commands so far; `was`: before them.
    void mark(bool before, bool after, bool is, bool was, QueueEdit on, QueueEdit off) {
        const bool wanted = before == after ? was : after;
        if (wanted != is) commands_.bodies.push_back(EditQueue{crowdChange_.group, wanted ? on : off, 0});
    }

    const QueueChange& crowdChange_;
    const GroupView& now_;
    CrowdCommands& commands_;
    std::vector<std::uint32_t> kept_;  // The queue as the commands so far leave it.
    bool held_, patrols_;
};

/// Adds the commands of one kind of change of the crowd.
struct Doing {
    const World& world;
    CrowdCommands& commands;

    void operator()(QueueChange& crowdChange) const {
        const auto g = inspect::indexOfGroup(world, crowdChange.group);
        if (!g) return;
        const GroupView now = world.group(*g);
        const std::vector<QueuedOrder>& gone = crowdChange.before.orders;
        const bool shaped = crowdChange.undone && crowdChange.formation &&
                            std::any_of(gone.begin(), gone.end(), [&](const QueuedOrder& order) {
                                return shapes(order.order) && !names(crowdChange.after.orders, order.id);
                            });
        const SetFormation shape{crowdChange.group, crowdChange.formation.value_or(FormationDef{})};
        if (shaped &&
            !sameBody(shape, SetFormation{crowdChange.group, inspect::groupDef(world, *g).formation}))
            commands.bodies.push_back(shape);
        QueueCommands(crowdChange, now, commands).add();
    }
    void operator()(MemberChange& crowdChange) const {
        for (const CommandBody& body : crowdChange.redo) {
            const auto* remove = std::get_if<RemoveCharacters>(&body);
            commands.bodies.push_back(body);
            if (remove == nullptr) continue;
            // They come back where they stood last.
            CrowdChange again = memberChange(body, world);
            crowdChange.undo = std::move(std::get<MemberChange>(again).undo);
        }
    }
    void operator()(DivisionChange& crowdChange) const { divisionCommands(crowdChange, world, commands); }
};

std::vector<CommandBody> comeBack(const std::vector<std::uint32_t>& ids, const World& world) {
    std::vector<CommandBody> back;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        AddCharacters add{world.group(g).id, {}, {}};
        for (const std::int32_t member : world.group(g).members) {
            const auto i = static_cast<std::size_t>(member);
            if (std::find(ids.begin(), ids.end(), world.characters().id[i]) == ids.end()) continue;
            add.positions.push_back(world.characters().position[i]);
            add.bodies.push_back(world.characters().body[i]);
        }
        if (!add.positions.empty()) back.push_back(std::move(add));
    }
    return back;
}

std::vector<CommandBody> goBack(const TransferCharacters& transfer, const World& world) {
    std::vector<CommandBody> back;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        if (world.group(g).id == transfer.group) continue;
        TransferCharacters to{{}, world.group(g).id};
        for (const std::int32_t member : world.group(g).members) {
            const std::uint32_t id = world.characters().id[static_cast<std::size_t>(member)];
            if (std::find(transfer.ids.begin(), transfer.ids.end(), id) != transfer.ids.end())
                to.ids.push_back(id);
        }
        if (!to.ids.empty()) back.push_back(std::move(to));
    }
    return back;
}

}  // namespace

bool sameBody(const CommandBody& a, const CommandBody& b) {
    return encodeCommand({0, 0, 0, a}) == encodeCommand({0, 0, 0, b});
}

std::size_t bytesOf(const CommandBody& body) {
    return encodeCommand({0, 0, 0, body}).size();
}

std::size_t bytesOf(const CrowdChange& crowdChange) {
    const auto ofQueue = [](const QueueState& queue) {
        std::size_t bytes = 0;
        for (const QueuedOrder& order : queue.orders) bytes += bytesOf(GiveOrder{{}, {}, 0, order.order});
        return bytes;
    };
    const auto ofPart = [&](const PartState& part) {
        return ofQueue(part.queue) + part.members.size() * sizeof(std::uint32_t) +
               bytesOf(AddGroup{part.def});
    };
    std::size_t bytes = sizeof(CrowdChange);
    if (const auto* queue = std::get_if<QueueChange>(&crowdChange)) {
        bytes += ofQueue(queue->before) + ofQueue(queue->after);
        if (queue->formation) bytes += bytesOf(SetFormation{{}, *queue->formation});
    }
    if (const auto* member = std::get_if<MemberChange>(&crowdChange)) {
        for (const CommandBody& body : member->redo) bytes += bytesOf(body);
        for (const CommandBody& body : member->undo) bytes += bytesOf(body);
    }
    if (const auto* division = std::get_if<DivisionChange>(&crowdChange)) {
        bytes += bytesOf(division->asked) + ofPart(division->whole);
        for (const PartState& part : division->parts) bytes += ofPart(part);
    }
    return bytes;
}

QueueState queueOf(const GroupView& group) {
    return {{group.orders.begin(), group.orders.end()}, group.held, group.patrols};
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

void giveAll(const PartState& wanted, const GroupView& now, CrowdCommands& commands) {
    const std::vector<QueuedOrder>& orders = wanted.queue.orders;
    const auto same = [](const QueuedOrder& a, const QueuedOrder& b) {
        return sameBody(GiveOrder{{}, {}, 0, a.order}, GiveOrder{{}, {}, 0, b.order});
    };
    bool held = now.held, patrols = now.patrols;
    if (!std::equal(orders.begin(), orders.end(), now.orders.begin(), now.orders.end(), same)) {
        if (orders.empty()) commands.bodies.push_back(EditQueue{wanted.id, QueueEdit::Cancel, 0});
        for (const QueuedOrder& order : orders) {
            commands.orders.push_back({commands.bodies.size(), order.id});
            commands.bodies.push_back(GiveOrder{
                wanted.id, &order == orders.data() ? QueueMode::Replace : QueueMode::Append, 0, order.order});
            held = patrols = false;
        }
    }
    const auto mark = [&](bool is, bool want, QueueEdit on, QueueEdit off) {
        if (is != want) commands.bodies.push_back(EditQueue{wanted.id, want ? on : off, 0});
    };
    mark(held, wanted.queue.held, QueueEdit::Hold, QueueEdit::Resume);
    mark(patrols, wanted.queue.patrols, QueueEdit::Patrol, QueueEdit::EndPatrol);
}

CrowdChange memberChange(const CommandBody& body, const World& world) {
    MemberChange crowdChange{{body}, {}};
    if (const auto* remove = std::get_if<RemoveCharacters>(&body))
        crowdChange.undo = comeBack(remove->ids, world);
    if (const auto* transfer = std::get_if<TransferCharacters>(&body))
        crowdChange.undo = goBack(*transfer, world);
    if (std::holds_alternative<AddCharacters>(body)) crowdChange.undo = {RemoveCharacters{}};
    return crowdChange;
}

CrowdChange reversed(CrowdChange crowdChange) {
    if (auto* queue = std::get_if<QueueChange>(&crowdChange)) {
        std::swap(queue->before, queue->after);
        queue->undone = !queue->undone;
    }
    if (auto* member = std::get_if<MemberChange>(&crowdChange)) std::swap(member->redo, member->undo);
    if (auto* division = std::get_if<DivisionChange>(&crowdChange)) division->undone = !division->undone;
    return crowdChange;
}

void commandsOf(CrowdChange& crowdChange, const World& world, CrowdCommands& commands) {
    std::visit(Doing{world, commands}, crowdChange);
}

void renameOrder(CrowdChange& crowdChange, std::uint32_t from, std::uint32_t to) {
    const auto in = [&](QueueState& queue) {
        for (QueuedOrder& order : queue.orders)
            if (order.id == from) order.id = to;
    };
    if (auto* queue = std::get_if<QueueChange>(&crowdChange)) in(queue->before), in(queue->after);
    if (auto* division = std::get_if<DivisionChange>(&crowdChange)) {
        in(division->whole.queue);
        for (PartState& part : division->parts) in(part.queue);
    }
}

void renameGroup(CrowdChange& crowdChange, GroupId from, GroupId to) {
    const auto inBody = [&](CommandBody& body) { rename(body, {ThingKind::Group, from.value}, to.value); };
    const auto inId = [&](GroupId& id) { id = id == from ? to : id; };
    const auto inQueue = [&](QueueState& queue) {
        for (QueuedOrder& order : queue.orders) inId(order.order.group);
    };
    if (auto* queue = std::get_if<QueueChange>(&crowdChange)) {
        inId(queue->group);
        inQueue(queue->before);
        inQueue(queue->after);
    }
    if (auto* member = std::get_if<MemberChange>(&crowdChange)) {
        for (CommandBody& body : member->redo) inBody(body);
        for (CommandBody& body : member->undo) inBody(body);
    }
    if (auto* division = std::get_if<DivisionChange>(&crowdChange)) {
        inBody(division->asked);
        if (auto* merge = std::get_if<MergeGroups>(&division->asked))
            for (GroupId& id : merge->groups) inId(id);
        inId(division->whole.id);
        for (PartState& part : division->parts) inId(part.id);
    }
}

}  // namespace muster
