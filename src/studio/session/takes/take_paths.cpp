#include "studio/session/takes/take_paths.h"

#include <algorithm>
#include <variant>

namespace muster {
namespace {

using Entries = std::vector<std::pair<std::uint32_t, Vec2>>;

/// The unbroken run of points of one id.
template <class Moments, class List>
std::vector<Vec2> runOf(const Moments& moments, List list, std::uint32_t id, std::uint32_t& first) {
    std::vector<Vec2> points;
    for (const auto& [step, moment] : moments) {
        const Entries& entries = list(moment);
        const auto at = std::lower_bound(
            entries.begin(), entries.end(), id,
            [](const auto& entry, std::uint32_t wanted) { return entry.first < wanted; });
        const bool there = at != entries.end() && at->first == id;
        if (!there && !points.empty()) break;
        if (!there) continue;
        if (points.empty()) first = step;
        points.push_back(at->second);
    }
    return points;
}

}  // namespace

TakePaths::TakePaths(const Take& take) {
    for (const Command& command : take.commands)
        if (const auto* down = touchOf(command.body, TouchPhase::Down))
            downs_[command.step].emplace_back(command.client, down->touch);
}

void TakePaths::observe(const World& world) {
    observeTouches(world);
    const std::uint32_t step = world.stepCount();
    if (step % kPathSpacing != 0 || moments_.contains(step)) return;
    Moment& moment = moments_[step];
    const CharactersView all = world.characters();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        if (group.members.empty()) continue;
        Vec2 sum;
        for (const std::int32_t i : group.members) sum += all.position[static_cast<std::size_t>(i)];
        moment.groups.emplace_back(group.id.value, sum / static_cast<double>(group.members.size()));
    }
    if (all.size() > kMostPathCharacters) return;
    for (std::size_t i = 0; i < all.size(); ++i) moment.characters.emplace_back(all.id[i], all.position[i]);
}

void TakePaths::observeTouches(const World& world) {
    const std::uint32_t step = world.stepCount() - 1;  // The step that was made.
    const auto downs = downs_.find(step);
    if (downs == downs_.end()) return;
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView group = world.group(g);
        for (const Control& control : group.controls)
            for (const ControlPoint& point : control.points)
                for (const auto& down : downs->second)
                    if (down.first == control.client && down.second == point.touch)
                        holders_[{step, down}] = group.id;
    }
}

std::vector<Vec2> TakePaths::ofGroup(GroupId group, std::uint32_t& first) const {
    return runOf(
        moments_, [](const Moment& m) -> const Entries& { return m.groups; }, group.value, first);
}

std::vector<Vec2> TakePaths::ofCharacter(std::uint32_t character, std::uint32_t& first) const {
    return runOf(
        moments_, [](const Moment& m) -> const Entries& { return m.characters; }, character, first);
}

std::vector<RecordedPath> TakePaths::all(double stepTime) const {
    std::map<std::uint32_t, RecordedPath> paths;
    for (const auto& [step, moment] : moments_)
        for (const auto& [id, at] : moment.characters) {
            RecordedPath& path = paths[id];
            if (path.points.empty()) path.first = step * stepTime;
            path.points.push_back(at);
        }
    std::vector<RecordedPath> all;
    for (auto& [id, path] : paths) {
        path.person = id;
        all.push_back(std::move(path));
    }
    return all;
}

bool TakePaths::knows(std::uint32_t character) const {
    std::uint32_t first = 0;
    return !ofCharacter(character, first).empty();
}

bool TakePaths::knowsPeople() const {
    return std::any_of(moments_.begin(), moments_.end(),
                       [](const auto& entry) { return !entry.second.characters.empty(); });
}

GroupId TakePaths::heldBy(std::uint32_t client, std::uint32_t touch, std::uint32_t step) const {
    const auto found = holders_.find({step, {client, touch}});
    return found == holders_.end() ? GroupId{} : found->second;
}

}  // namespace muster
