#include "studio/session/history/step_births.h"

#include <algorithm>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"

namespace muster {
namespace {

/// Ids of all that is of a kind, ascending.
std::vector<std::uint32_t> idsOf(SubjectKind kind, const World& world) {
    std::vector<std::uint32_t> ids;
    const auto put = [&](const auto& all) {
        for (const auto id : all) ids.push_back(id.value);
    };
    if (kind == SubjectKind::Obstacle) put(inspect::environment(world).obstacleIds());
    if (kind == SubjectKind::Patch) put(inspect::environment(world).patchIds());
    if (kind == SubjectKind::Item) put(world.itemIds());
    if (kind == SubjectKind::Checkpoint) put(world.checkpointIds());
    if (kind == SubjectKind::Area)
        for (std::size_t a = 0; a < world.areaCount(); ++a) ids.push_back(world.area(a).id.value);
    if (kind == SubjectKind::Group)
        for (std::size_t g = 0; g < world.groupCount(); ++g) ids.push_back(world.group(g).id.value);
    if (kind == SubjectKind::Character)
        ids.assign(world.characters().id.begin(), world.characters().id.end());
    return ids;
}

}  // namespace

void StepBirths::begin(const World& world) {
    if (begun_) return;
    begun_ = true;
    for (std::size_t kind = 0; kind < kSubjectKinds; ++kind) {
        const std::vector<std::uint32_t> ids = idsOf(static_cast<SubjectKind>(kind), world);
        highest_[kind] = ids.empty() ? 0 : ids.back();
    }
}

void StepBirths::end(const World& world) {
    events_.assign(world.events().begin(), world.events().end());
    known_.clear();
    ofThemselves_.clear();
    for (const Event& event : events_) {
        if (event.kind == EventKind::GroupAdded && event.value != 0)
            known_.push_back({SubjectKind::Group, event.subject});
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

// Ids rise with the commands that bring things.
std::vector<std::uint32_t> StepBirths::nextNew(SubjectKind kind, const World& world) {
    for (const std::uint32_t id : idsOf(kind, world)) {
        const Subject one{kind, id};
        if (id <= highest_[static_cast<std::size_t>(kind)]) continue;
        if (std::find(known_.begin(), known_.end(), one) != known_.end()) continue;
        known_.push_back(one);
        return {id};
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
    if (std::holds_alternative<AddGroup>(body)) return nextNew(SubjectKind::Group, world);
    const auto* put = std::get_if<PutThing>(&body);
    return put != nullptr && put->id == 0 ? nextNew(subjectOf(*thingOf(*put)), world)
                                          : std::vector<std::uint32_t>();
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
