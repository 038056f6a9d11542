#include "studio/words/crews.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/bounds.h"
#include "engine/state/order_queue.h"
#include "engine/world/inspect.h"
#include "muster/views.h"

namespace muster::words {
namespace {

/// Numbers of ids that stand in for those of parts: no world has so many groups.
constexpr std::uint32_t kFirstStandIn = 0xFFFF0000u;

bool has(const std::vector<GroupId>& groups, GroupId group) {
    return std::find(groups.begin(), groups.end(), group) != groups.end();
}

Status sentence(std::string text) {
    return {StatusCode::NotFound, std::move(text)};
}

}  // namespace

std::vector<std::uint32_t> Crews::members(GroupId group) const {
    std::vector<std::uint32_t> ids;
    const auto g = inspect::indexOfGroup(scene_.world, group);
    if (!g) return ids;
    for (const std::int32_t i : scene_.world.group(*g).members)
        ids.push_back(scene_.world.characters().id[static_cast<std::size_t>(i)]);
    return ids;
}

std::vector<std::uint32_t> Crews::left(GroupId group) const {
    std::vector<std::uint32_t> all = members(group), rest;
    const auto taken = taken_.find(group);
    if (taken == taken_.end()) return all;
    std::set_difference(all.begin(), all.end(), taken->second.begin(), taken->second.end(),
                        std::back_inserter(rest));
    return rest;
}

Vec2 Crews::placeOf(std::uint32_t character) const {
    const std::span ids = scene_.world.characters().id;
    const auto at = std::lower_bound(ids.begin(), ids.end(), character);
    return scene_.world.characters().position[static_cast<std::size_t>(at - ids.begin())];
}

Crew Crews::whole(GroupId group) const {
    Crew crew;
    crew.group = crew.address = group;
    crew.ids = left(group);
    const std::size_t g = *inspect::indexOfGroup(scene_.world, group);
    const GroupView view = scene_.world.group(g);
    crew.label = std::string(view.name);
    const bool divided = taken_.contains(group);
    crew.all = !divided;
    if (divided) crew.label = "the rest of " + crew.label + " (" + std::to_string(crew.ids.size()) + ")";
    std::vector<Vec2> points;
    if (divided || view.placePositions.empty())
        for (const std::uint32_t id : crew.ids) points.push_back(placeOf(id));
    crew.middle = points.empty() ? view.pose.position : meanOf(points);
    crew.front = view.pose.rotation;
    crew.formation = inspect::ownFormation(scene_.world, g);
    return crew;
}

// A part gets a stand-in for the id that the world will give it.
Crew Crews::part(GroupId group, std::vector<std::uint32_t> ids) {
    std::sort(ids.begin(), ids.end());
    if (ids == left(group)) return whole(group);
    Crew crew = whole(group);
    crew.whole = crew.all = false;
    crew.ids = std::move(ids);
    crew.label = std::to_string(crew.ids.size()) + " of " + names_.nameOf(group);
    std::vector<Vec2> points;
    for (const std::uint32_t id : crew.ids) points.push_back(placeOf(id));
    crew.middle = meanOf(points);
    crew.address = GroupId{kFirstStandIn + static_cast<std::uint32_t>(parts_.size())};
    parts_.push_back({crew.address, crew.ids.front(), group});
    SplitGroup split;
    split.group = group;
    split.ids = crew.ids;
    splits_.emplace_back(std::move(split));
    std::vector<std::uint32_t>& taken = taken_[group];
    std::vector<std::uint32_t> both;
    std::merge(taken.begin(), taken.end(), crew.ids.begin(), crew.ids.end(), std::back_inserter(both));
    taken = std::move(both);
    return crew;
}

// The rest of the groups that were divided, else the groups that nobody has spoken of.
std::vector<GroupId> Crews::restOf(const Who& who) const {
    std::vector<GroupId> groups;
    const auto divided = [&](GroupId group) { return taken_.contains(group) && !left(group).empty(); };
    if (who.named && !who.everybody) return who.groups;
    for (const GroupId group : base_)
        if (divided(group) && !who.everybody) groups.push_back(group);
    if (!groups.empty()) return groups;
    for (std::size_t g = 0; g < scene_.world.groupCount(); ++g) {
        const GroupId group = scene_.world.group(g).id;
        if (divided(group) || (!taken_.contains(group) && !has(mentioned_, group))) groups.push_back(group);
    }
    return groups;
}

Result<std::vector<GroupId>> Crews::base(const Who& who) {
    std::vector<GroupId> groups;
    if (who.amount == Amount::Rest) {
        groups = restOf(who);
        if (groups.empty()) return sentence("There is nobody else.");
    } else if (who.everybody || (who.nearest && !who.named)) {
        for (std::size_t g = 0; g < scene_.world.groupCount(); ++g)
            groups.push_back(scene_.world.group(g).id);
    } else if (who.named) {
        groups = who.groups;
    } else if (who.amount != Amount::All && !base_.empty()) {
        groups = base_;
    } else {
        for (const GroupId group : scene_.chosen)
            if (inspect::indexOfGroup(scene_.world, group)) groups.push_back(group);
        if (groups.empty() && scene_.world.groupCount() == 1) groups.push_back(scene_.world.group(0).id);
    }
    std::erase_if(groups, [&](GroupId group) { return has(who.except, group) || members(group).empty(); });
    if (groups.empty())
        return sentence(scene_.world.groupCount() == 0
                            ? "There is no group here."
                            : "Who? Begin with a group, as “" + std::string(scene_.world.group(0).name) +
                                  "”, or with “everybody”.");
    return groups;
}

// Who is nearest, or farthest to a side, comes first; of two that are as far the one with the smaller id.
void Crews::sortBy(std::vector<std::uint32_t>& ids, const Who& who, GroupId group, const Vec2* near) const {
    const Crew crew = whole(group);
    const auto key = [&](std::uint32_t id) {
        const Vec2 p = placeOf(id);
        const Vec2 own = crew.front.applyInverse(p - crew.middle);
        switch (who.side) {
            case Side::Left:
                return -own.y;
            case Side::Right:
                return own.y;
            case Side::Front:
                return -own.x;
            case Side::Rear:
                return own.x;
            case Side::Any:
                break;
        }
        return near != nullptr ? distance(p, *near) : -own.x;
    };
    std::vector<std::pair<double, std::uint32_t>> keyed;
    for (const std::uint32_t id : ids) keyed.emplace_back(key(id), id);
    std::sort(keyed.begin(), keyed.end());
    for (std::size_t k = 0; k < ids.size(); ++k) ids[k] = keyed[k].second;
}

Result<std::vector<Crew>> Crews::some(const Who& who, const std::vector<GroupId>& groups, const Vec2* near) {
    std::vector<Crew> crews;
    if (who.amount == Amount::Share) {
        for (const GroupId group : groups) {
            std::vector<std::uint32_t> ids = left(group);
            const double all = static_cast<double>(members(group).size());
            const auto wanted = static_cast<std::size_t>(std::max(1.0, std::floor(all * who.share + 0.5)));
            if (ids.empty()) continue;
            sortBy(ids, who, group, near);
            ids.resize(std::min(ids.size(), wanted));
            crews.push_back(part(group, std::move(ids)));
        }
        return crews;
    }
    // The nearest of all groups together.
    std::vector<std::pair<double, std::pair<std::uint32_t, GroupId>>> all;
    for (const GroupId group : groups) {
        std::vector<std::uint32_t> ids = left(group);
        sortBy(ids, who, group, near);
        for (std::size_t k = 0; k < ids.size(); ++k)
            all.push_back({near != nullptr && who.side == Side::Any ? distance(placeOf(ids[k]), *near)
                                                                    : static_cast<double>(k),
                           {ids[k], group}});
    }
    const auto wanted = static_cast<std::size_t>(who.count);
    if (wanted > all.size())
        return sentence("There are only " + std::to_string(all.size()) + " people, not " +
                        std::to_string(wanted) + ".");
    std::sort(all.begin(), all.end());
    for (const GroupId group : groups) {
        std::vector<std::uint32_t> ids;
        for (std::size_t k = 0; k < wanted; ++k)
            if (all[k].second.second == group) ids.push_back(all[k].second.first);
        if (!ids.empty()) crews.push_back(part(group, std::move(ids)));
    }
    return crews;
}

Result<std::vector<Crew>> Crews::of(const std::optional<Who>& said, const Vec2* near) {
    const Who who = said.value_or(Who{});
    if (who.sameAgain && !last_.empty() && who.amount == Amount::All) return last_;
    const Result<std::vector<GroupId>> groups = base(who);
    if (!groups.ok()) return groups.status();
    std::vector<Crew> crews;
    if (who.amount == Amount::Share || who.amount == Amount::Count) {
        Result<std::vector<Crew>> found = some(who, *groups, near);
        if (!found.ok()) return found.status();
        crews = std::move(found).value();
    } else {
        for (const GroupId group : *groups)
            if (!left(group).empty()) crews.push_back(whole(group));
    }
    if (crews.empty()) return sentence("Nobody of them is left.");
    base_ = *groups;
    for (const GroupId group : *groups)
        if (!has(mentioned_, group)) mentioned_.push_back(group);
    last_ = crews;
    return crews;
}

}  // namespace muster::words
