#include "studio/session/takes/take_news.h"

#include "engine/state/command_order.h"

namespace muster {

TakeNews::TakeNews(const Take& take) : refused_(&comesBefore) {
    std::uint32_t id = 0;
    for (const GroupDef& group : take.def.groups) {
        ++id;
        groups_[id] = {GroupId{id}, group.name, 0, kNever};
    }
}

void TakeNews::observe(const World& world) {
    const std::uint32_t step = world.stepCount();
    std::vector<Given> given;
    for (const Event& event : world.events()) {
        if (event.kind == EventKind::OrderGiven) given.push_back({GroupId{event.subject}, event.value});
        if (event.kind == EventKind::OrderBegun) begun_.try_emplace(event.value, step);
        if (event.kind == EventKind::OrderDone || event.kind == EventKind::OrderSkipped)
            ended_.try_emplace(event.value, step);
        if (event.kind == EventKind::GroupRemoved)
            if (const auto gone = groups_.find(event.subject); gone != groups_.end()) gone->second.to = step;
        if (event.kind == EventKind::GroupAdded)
            groups_.try_emplace(event.subject, GroupTimes{GroupId{event.subject}, {}, step, kNever});
    }
    if (!given.empty()) given_[step - 1] = std::move(given);
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        const auto found = groups_.find(group.id.value);
        if (found != groups_.end() && found->second.name.empty()) found->second.name = group.name;
    }
    for (const Rejection& rejection : world.rejections())
        refused_.try_emplace(rejection.command, rejection.status.message());
}

TakeNews::OrderTimes TakeNews::order(GroupId group, std::uint32_t step, std::size_t nth) const {
    const auto found = given_.find(step);
    if (found == given_.end()) return {};
    for (const Given& one : found->second) {
        if (one.group != group || nth-- > 0) continue;
        const auto begun = begun_.find(one.id), ended = ended_.find(one.id);
        return {one.id, begun == begun_.end() ? kNever : begun->second,
                ended == ended_.end() ? kNever : ended->second};
    }
    return {};
}

std::vector<TakeNews::GroupTimes> TakeNews::groups() const {
    std::vector<GroupTimes> all;
    for (const auto& [id, group] : groups_) all.push_back(group);
    return all;
}

}  // namespace muster
