#include "studio/session/history/step_births.h"

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

/// Id of the first thing above `after` that equals the definition; 0 for none.
template <class Ids, class Same>
std::uint32_t firstAbove(const Ids& ids, std::uint32_t after, Same same) {
    for (std::size_t k = 0; k < ids.size(); ++k)
        if (ids[k].value > after && same(k)) return ids[k].value;
    return 0;
}

/// Id of the thing that the command has added; 0 where it adds none.
std::uint32_t addedId(const CommandBody& body, const World& world, std::uint32_t after) {
    const Environment& ground = inspect::environment(world);
    const auto* put = std::get_if<PutThing>(&body);
    if (put == nullptr || put->id != 0) return 0;
    if (put->obstacle) {
        const auto ids = ground.obstacleIds();
        return firstAbove(ids, after,
                          [&](std::size_t k) { return *ground.obstacle(ids[k]) == *put->obstacle; });
    }
    if (put->patch) {
        const auto ids = ground.patchIds();
        return firstAbove(ids, after, [&](std::size_t k) { return *ground.patch(ids[k]) == *put->patch; });
    }
    if (put->item)
        return firstAbove(world.itemIds(), after,
                          [&](std::size_t k) { return world.items()[k].position == put->item->position; });
    if (put->checkpoint)
        return firstAbove(world.checkpointIds(), after, [&](std::size_t k) {
            return world.checkpoints()[k].position == put->checkpoint->position;
        });
    for (std::size_t a = 0; a < world.areaCount(); ++a)
        if (const AreaView area = world.area(a); area.id.value > after && area.def == *put->area)
            return area.id.value;
    return 0;
}

std::optional<SubjectKind> addedKind(const CommandBody& body) {
    if (std::holds_alternative<AddGroup>(body)) return SubjectKind::Group;
    const auto* put = std::get_if<PutThing>(&body);
    if (put == nullptr || put->id != 0 || !thingOf(*put)) return std::nullopt;
    return subjectOf(*thingOf(*put));
}

}  // namespace

void StepBirths::begin(const World& world) {
    if (begun_) return;
    begun_ = true;
    const auto last = [](const auto& ids) { return ids.empty() ? 0u : ids.back().value; };
    const auto set = [&](SubjectKind kind, std::uint32_t id) {
        highest_[static_cast<std::size_t>(kind)] = id;
    };
    const Environment& ground = inspect::environment(world);
    const std::size_t groups = world.groupCount(), areas = world.areaCount();
    const auto characters = world.characters().id;
    set(SubjectKind::Obstacle, last(ground.obstacleIds()));
    set(SubjectKind::Patch, last(ground.patchIds()));
    set(SubjectKind::Item, last(world.itemIds()));
    set(SubjectKind::Checkpoint, last(world.checkpointIds()));
    set(SubjectKind::Group, groups == 0 ? 0u : world.group(groups - 1).id.value);
    set(SubjectKind::Area, areas == 0 ? 0u : world.area(areas - 1).id.value);
    set(SubjectKind::Character, characters.empty() ? 0u : characters.back());
}

void StepBirths::end(const World& world) {
    events_.assign(world.events().begin(), world.events().end());
    knownGroups_.clear();
    ofThemselves_.clear();
    for (const Event& event : events_) {
        if (event.kind == EventKind::GroupAdded && event.value != 0) knownGroups_.push_back(event.subject);
        if (event.kind == EventKind::Entered || event.kind == EventKind::Exited)
            ofThemselves_.push_back(event.subject);
    }
    std::sort(ofThemselves_.begin(), ofThemselves_.end());
}

std::vector<std::uint32_t> StepBirths::takeEvents(EventKind kind, std::uint32_t subject, std::uint32_t value,
                                                  std::size_t most) {
    std::vector<std::uint32_t> ids;
    for (Event& event : events_) {
        if (ids.size() == most) break;
        if (event.kind != kind || (subject != 0 && event.subject != subject) ||
            (value != 0 && event.value != value))
            continue;
        ids.push_back(subject != 0 ? event.value : event.subject);
        event.kind = EventKind::Count;  // It is of one command only.
    }
    return ids;
}

std::vector<std::uint32_t> StepBirths::added(const CommandBody& body, const World& world) {
    const auto kind = addedKind(body);
    if (!kind) return {};
    std::uint32_t& highest = highest_[static_cast<std::size_t>(*kind)];
    if (std::holds_alternative<AddGroup>(body)) return addedGroup(world, highest);
    const std::uint32_t id = addedId(body, world, highest);
    if (id == 0) return {};
    highest = id;
    return {id};
}

std::vector<std::uint32_t> StepBirths::addedGroup(const World& world, std::uint32_t after) {
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        const bool known = std::find(knownGroups_.begin(), knownGroups_.end(), view.id.value) !=
                           knownGroups_.end();
        if (view.id.value <= after || known) continue;
        knownGroups_.push_back(view.id.value);
        return {view.id.value};
    }
    return {};
}

std::vector<std::uint32_t> StepBirths::of(const CommandBody& body, const World& world) {
    if (const auto* give = std::get_if<GiveOrder>(&body))
        return takeEvents(EventKind::OrderGiven, give->group.value, 0, 1);
    if (const auto* split = std::get_if<SplitGroup>(&body)) {
        const std::size_t parts = split->by == SplitBy::Shares ? split->shares.size() - 1 : 1;
        return takeEvents(EventKind::GroupAdded, 0, split->group.value, parts);
    }
    if (const auto* add = std::get_if<AddCharacters>(&body))
        return takeEvents(EventKind::Joined, 0, add->group.value, add->positions.size());
    return added(body, world);
}

std::vector<std::uint32_t> StepBirths::newMembers(GroupId group, const World& world) const {
    std::vector<std::uint32_t> ids;
    const auto g = inspect::indexOfGroup(world, group);
    if (!g) return ids;
    for (const std::int32_t member : world.group(*g).members) {
        const std::uint32_t id = world.characters().id[static_cast<std::size_t>(member)];
        if (id > highest_[static_cast<std::size_t>(SubjectKind::Character)] && !cameOrLeft(id))
            ids.push_back(id);
    }
    return ids;
}

bool StepBirths::cameOrLeft(std::uint32_t character) const {
    return std::binary_search(ofThemselves_.begin(), ofThemselves_.end(), character);
}

}  // namespace muster
