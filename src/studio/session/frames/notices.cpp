#include "studio/session/frames/notices.h"

#include <algorithm>
#include <string>
#include <variant>

#include "engine/state/command_archive.h"
#include "engine/world/inspect.h"
#include "engine/world/standings.h"

namespace muster {

namespace {

std::string ofAll(std::uint32_t number, const GroupView& group) {
    return std::to_string(number) + " of " + std::to_string(group.count);
}

/// What is said of a group; `number` is how many are concerned.
std::string sentence(EventKind kind, const GroupView& group, std::uint32_t number) {
    const bool all = std::cmp_equal(number, group.count);
    switch (kind) {
        case EventKind::Stuck:
            return ofAll(number, group) + (number == 1 ? " does" : " do") +
                   " not get on, and stood for 5 s away from " +
                   (number == 1 ? "its place." : "their places.");
        case EventKind::Blocked:
            return "the way of " + (all ? std::string("everybody") : ofAll(number, group)) + " is cut off.";
        case EventKind::Free:
            return "everybody has a way again.";
        case EventKind::NoPath:
            return "there is no way to any of the places.";
        case EventKind::Partial:
            return ofAll(number, group) + " places cannot be reached.";
        default:
            return "";
    }
}

/// The group of the character with that id; the number of groups for none.
std::size_t groupOfCharacter(const World& world, std::uint32_t id) {
    const CharactersView c = world.characters();
    const auto at = std::lower_bound(c.id.begin(), c.id.end(), id);
    return at == c.id.end() || *at != id ? world.groupCount() : c.group[at - c.id.begin()];
}

}  // namespace

void appendNotices(const World& world, std::vector<EventNotice>& notices) {
    std::vector<std::uint32_t> stuck(world.groupCount(), 0);
    std::vector<Vec2> where(world.groupCount());
    const auto say = [&](EventKind kind, const GroupView& group, std::uint32_t number, Vec2 position) {
        const std::string what = sentence(kind, group, number);
        if (what.empty()) return;
        const auto level = kind == EventKind::Free ? protocol::NoticeLevel::Info
                                                   : protocol::NoticeLevel::Warning;
        notices.push_back({level, eventKindName(kind), groupTitle(group) + ": " + what, position});
    };
    for (const Event& event : world.events()) {
        if (!isOrderEvent(event.kind)) continue;
        if (event.kind == EventKind::Stuck) {
            const std::size_t g = groupOfCharacter(world, event.subject);
            if (g < stuck.size() && stuck[g]++ == 0) where[g] = event.position;
            continue;
        }
        if (const auto g = inspect::indexOfGroup(world, GroupId{event.subject}))
            say(event.kind, world.group(*g), event.value, event.position);
    }
    for (std::size_t g = 0; g < stuck.size(); ++g)
        if (stuck[g] > 0) say(EventKind::Stuck, world.group(g), stuck[g], where[g]);
}

namespace {

std::optional<Vec2> finite(Vec2 position) {
    return isFinite(position) ? std::optional<Vec2>(position) : std::nullopt;
}

// Returns the mean of pointAt(0) to pointAt(count - 1).
template <class PointAt>
std::optional<Vec2> middle(std::size_t count, PointAt pointAt) {
    if (count == 0) return std::nullopt;
    Vec2 sum{0.0, 0.0};
    for (std::size_t i = 0; i < count; ++i) sum += pointAt(i);
    return finite(sum / static_cast<double>(count));
}

}  // namespace

std::optional<Vec2> positionOf(const CommandBody& command) {
    if (const auto* touch = touchOf(command, TouchPhase::Down)) return finite(touch->position);
    const auto* add = std::get_if<AddControl>(&command);
    if (add == nullptr) return std::nullopt;
    return middle(add->positions.size(), [&](std::size_t i) { return add->positions[i]; });
}

namespace {

/// The first position that commands have, as far as their bytes can be read.
std::optional<Vec2> positionIn(std::span<const std::uint8_t> bytes) {
    Reader reader(bytes);
    while (reader.remaining() > 0) {
        const Result<CommandBody> body = decodeBody(reader);
        if (!body.ok()) return std::nullopt;
        if (const auto position = positionOf(body.value())) return position;
    }
    return std::nullopt;
}

}  // namespace

std::optional<Vec2> positionOf(const protocol::ClientMessage& message) {
    if (const auto* list = std::get_if<protocol::Commands>(&message)) return positionIn(list->commands);
    const auto* touches = std::get_if<protocol::Touches>(&message);
    if (touches == nullptr) return std::nullopt;
    for (const protocol::TouchEvent& event : touches->events)
        if (event.phase == TouchPhase::Down) return finite({event.x, event.y});
    return std::nullopt;
}

}  // namespace muster
