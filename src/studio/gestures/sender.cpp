#include "studio/gestures/sender.h"

#include <algorithm>

#include "studio/gestures/group_lookup.h"

namespace muster {
namespace {

constexpr double kShare = 0.6;  // Of those sent, who must be there before they go on to the next point.

struct Chosen {
    std::int32_t group = -1;         // Index of the group that most of them belong to.
    bool whole = false;              // All of that group are meant.
    bool alone = false;              // Nobody of another group is.
    std::vector<std::uint32_t> ids;  // Those of that group.
};

Chosen choose(const World& world, std::span<const std::uint32_t> ids) {
    const CharactersView characters = world.characters();
    std::vector<std::vector<std::uint32_t>> byGroup(world.groupCount());
    for (std::size_t i = 0; i < characters.size(); ++i)
        if (std::binary_search(ids.begin(), ids.end(), characters.id[i]))
            byGroup[characters.group[i]].push_back(characters.id[i]);
    Chosen chosen;
    std::size_t total = 0;
    for (std::size_t g = 0; g < byGroup.size(); ++g) {
        total += byGroup[g].size();
        if (byGroup[g].size() > chosen.ids.size()) {
            chosen.group = static_cast<std::int32_t>(g);
            chosen.ids = byGroup[g];
        }
    }
    if (chosen.group < 0) return chosen;
    chosen.whole = chosen.ids.size() == world.group(static_cast<std::size_t>(chosen.group)).members.size();
    chosen.alone = chosen.ids.size() == total;
    return chosen;
}

}  // namespace

void Sender::order(GroupId group, Vec2 to, bool add, std::vector<CommandBody>& commands) const {
    GiveOrder give;
    give.group = group;
    give.mode = add ? QueueMode::Append : QueueMode::Replace;
    give.order = Order::move(to);
    give.order.manner = movement_ == SchemeMovement::Continuum ? Manner::Continuum : Manner::Free;
    give.order.share = kShare;
    commands.emplace_back(std::move(give));
}

// Brings the selected of other groups into a group; groups that have become empty end.
void Sender::gather(const World& world, GroupId into, std::span<const std::uint32_t> ids,
                    std::vector<CommandBody>& commands) const {
    const CharactersView characters = world.characters();
    std::vector<std::uint32_t> others;
    std::vector<std::int32_t> left(world.groupCount(), 0);
    for (std::size_t i = 0; i < characters.size(); ++i) {
        const bool meant = std::binary_search(ids.begin(), ids.end(), characters.id[i]);
        const bool inside = world.group(characters.group[i]).id == into;
        if (meant && !inside) others.push_back(characters.id[i]);
        if (!meant || inside) ++left[characters.group[i]];
    }
    if (!others.empty()) commands.emplace_back(TransferCharacters{others, into});
    for (std::size_t g = 0; g < left.size(); ++g)
        if (left[g] == 0 && world.group(g).id != into) commands.emplace_back(RemoveGroup{world.group(g).id});
}

bool Sender::send(const World& world, std::span<const std::uint32_t> ids, Vec2 to, bool add,
                  std::vector<CommandBody>& commands) {
    for (Pending& pending : pending_) {
        if (!std::equal(ids.begin(), ids.end(), pending.ids.begin(), pending.ids.end())) continue;
        pending.points.push_back(to);
        pending.adds.push_back(add);
        return true;
    }
    const Chosen chosen = choose(world, ids);
    if (chosen.group < 0) return false;
    const GroupId group = world.group(static_cast<std::size_t>(chosen.group)).id;
    if (chosen.whole) {
        if (!chosen.alone) gather(world, group, ids, commands);
        order(group, to, add && chosen.alone, commands);
        return true;
    }
    SplitGroup split;
    split.group = group;
    split.ids = chosen.ids;
    split.shape = PartShape::Smaller;
    commands.emplace_back(std::move(split));
    pending_.push_back({{ids.begin(), ids.end()}, {to}, {false}, group, world.stepCount()});
    return true;
}

void Sender::stop(const World& world, std::span<const std::uint32_t> ids,
                  std::vector<CommandBody>& commands) {
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const auto members = membersOf(world, static_cast<std::int32_t>(g));
        const bool all = std::all_of(members.begin(), members.end(), [&](std::uint32_t id) {
            return std::binary_search(ids.begin(), ids.end(), id);
        });
        if (!members.empty() && all) commands.emplace_back(EditQueue{world.group(g).id, QueueEdit::Stop, 0});
    }
}

void Sender::beforeStep(const World& world, std::vector<CommandBody>& commands) {
    if (pending_.empty()) return;
    // Groups are added in the order in which they were asked for.
    std::vector<Pending> waiting = std::move(pending_);
    pending_.clear();
    std::vector<bool> used(world.events().size(), false);
    for (Pending& pending : waiting) {
        if (pending.step == world.stepCount()) {
            pending_.push_back(std::move(pending));
            continue;
        }
        GroupId made;
        for (std::size_t i = 0; i < world.events().size() && !made; ++i) {
            const Event& event = world.events()[i];
            if (used[i] || event.kind != EventKind::GroupAdded || event.value != pending.whole.value)
                continue;
            used[i] = true;
            made = GroupId{event.subject};
        }
        // Where the split was refused the whole group goes.
        if (!made) made = groupIndex(world, pending.whole) >= 0 ? pending.whole : GroupId{};
        if (!made) continue;
        gather(world, made, pending.ids, commands);
        for (std::size_t i = 0; i < pending.points.size(); ++i)
            order(made, pending.points[i], pending.adds[i], commands);
    }
}

}  // namespace muster
