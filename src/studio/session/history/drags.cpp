#include "studio/session/history/drags.h"

#include <algorithm>
#include <utility>

#include "engine/world/inspect.h"
#include "studio/session/history/group_fields.h"
#include "studio/session/inbox/received_commands.h"

namespace muster {
namespace {

constexpr double kMoved = 0.05;  // A finger that moves less only taps [m].
constexpr std::size_t kMostFingers = 64;
constexpr std::uint32_t kForgotten = 30;  // Since the last message about fingers that are not down [steps].
constexpr std::uint32_t kAgain = 2;       // In which fingers take a formation that they changed [steps].

bool isTouch(const CommandBody& body) {
    return isOneOf<Touch, AddControl>(body);
}

/// True where a finger of the director is down in the world.
bool isDown(std::uint32_t client, const std::vector<GroupId>& groups, const World& world) {
    return std::any_of(groups.begin(), groups.end(), [&](GroupId id) {
        const auto g = inspect::indexOfGroup(world, id);
        if (!g) return false;
        const auto controls = world.group(*g).controls;
        return std::any_of(controls.begin(), controls.end(), [&](const Control& control) {
            return control.client == client &&
                   std::any_of(control.points.begin(), control.points.end(),
                               [](const ControlPoint& point) { return point.down; });
        });
    });
}

/// The group whose pose, formation or queue the command changes; none for other commands.
GroupId ledGroup(const CommandBody& body) {
    if (changesField(body, &ChangeGroup::formation)) return std::get<ChangeGroup>(body).group;
    return queueChangedBy(body);
}

}  // namespace

Drags::Part Drags::note(std::uint32_t client, std::span<const CommandBody> bodies, const Scene& scene) {
    Part part;
    part.folds.assign(bodies.size(), 0);
    const bool touches = std::any_of(bodies.begin(), bodies.end(), isTouch);
    endForgotten(part, client, scene.world);
    for (const CommandBody& body : bodies) {
        if (const auto* touch = touchOf(body, TouchPhase::Down))
            down(client, touch->touch, touch->position, touch->group, scene);
        if (const auto* add = std::get_if<AddControl>(&body))
            for (std::size_t k = 0; k < add->touches.size() && k < add->positions.size(); ++k)
                down(client, add->touches[k], add->positions[k], add->group, scene);
        if (const auto open = open_.find(client); open != open_.end())
            follow(client, open->second, body, scene);
    }
    const auto open = open_.find(client);
    if (open == open_.end()) return part;
    Drag& drag = open->second;
    if (touches) drag.step = scene.world.stepCount();
    for (std::size_t k = 0; k < bodies.size() && touches; ++k) {
        const GroupId led = ledGroup(bodies[k]);
        if (!led || std::find(drag.groups.begin(), drag.groups.end(), led) == drag.groups.end()) continue;
        part.folds[k] = 1;
        drag.changed = true;
    }
    part.drag = drag.number;
    // A formation that fingers change lets them go, and they take it again.
    const bool takesAgain = std::any_of(bodies.begin(), bodies.end(), [](const CommandBody& body) {
        return changesField(body, &ChangeGroup::formation);
    });
    if (drag.fingers.empty() && !takesAgain) end(part, client);
    return part;
}

void Drags::endForgotten(Part& part, std::uint32_t client, const World& world) {
    const auto open = open_.find(client);
    if (open == open_.end()) return;
    const std::uint32_t quiet = world.stepCount() - open->second.step;
    const std::uint32_t most = open->second.fingers.empty() ? kAgain : kForgotten;
    // Fingers whose controls have ended otherwise do not always lift.
    if (quiet > most && !isDown(client, open->second.groups, world)) end(part, client);
}

void Drags::end(Part& part, std::uint32_t client) {
    const auto open = open_.find(client);
    if (!open->second.changed) return forget(client);
    part.ended.push_back(open->second.number);
    open_.erase(open);
}

void Drags::down(std::uint32_t client, std::uint32_t touch, Vec2 at, GroupId group, const Scene& scene) {
    if (!group) {
        const auto picked = inspect::pickedGroup(scene.world, at);
        if (!picked) return;
        group = scene.world.group(*picked).id;
    }
    const auto [open, isNew] = open_.try_emplace(client);
    Drag& drag = open->second;
    if (isNew) drag.number = ++last_;
    std::erase_if(drag.fingers, [&](const Finger& finger) { return finger.touch == touch; });
    if (drag.fingers.size() < kMostFingers) drag.fingers.push_back({touch, at});
    hold(drag, group, scene);
}

void Drags::hold(Drag& drag, GroupId group, const Scene& scene) {
    if (std::find(drag.groups.begin(), drag.groups.end(), group) != drag.groups.end()) return;
    drag.groups.push_back(group);
    for (const CommandBody& asked : {CommandBody(ChangeGroup{.group = group, .formation = FormationDef{}}),
                                     CommandBody(SetPose{group, {}, 0.0, false})}) {
        const std::optional<CommandBody> now = presentPart(asked, false, scene);
        if (!now) continue;
        Difference one;
        one.parts.push_back({keyOf(asked, scene.names), now, now, true});
        join(differences_[drag.number], std::move(one));
    }
}

void Drags::follow(std::uint32_t client, Drag& drag, const CommandBody& body, const Scene& scene) {
    const auto lift = [&](std::uint32_t touch) {
        std::erase_if(drag.fingers, [&](const Finger& finger) { return finger.touch == touch; });
    };
    if (const auto* move = touchOf(body, TouchPhase::Move))
        for (const Finger& finger : drag.fingers)
            drag.changed = drag.changed ||
                           (finger.touch == move->touch && distance(finger.from, move->position) > kMoved);
    if (const auto* up = touchOf(body, TouchPhase::Up)) lift(up->touch);
    if (std::holds_alternative<ReleaseClient>(body)) drag.fingers.clear();
    const auto* edit = std::get_if<EditControl>(&body);
    const auto* remove = edit != nullptr && edit->edit == ControlEdit::Remove ? edit : nullptr;
    const auto* cancel = touchOf(body, TouchPhase::Cancel);
    if (cancel != nullptr) lift(cancel->touch);
    if (cancel == nullptr && remove == nullptr) return;
    // The control ends, with all its fingers.
    const auto ends = [&](GroupId group, const Control& control) {
        if (remove != nullptr) return group == remove->group && control.id == remove->control;
        return control.client == client &&
               std::any_of(control.points.begin(), control.points.end(), [&](const ControlPoint& point) {
                   return point.down && point.touch == cancel->touch;
               });
    };
    for (const GroupId group : drag.groups)
        if (const auto g = inspect::indexOfGroup(scene.world, group))
            for (const Control& control : scene.world.group(*g).controls)
                if (ends(group, control))
                    for (const ControlPoint& point : control.points) lift(point.touch);
}

void Drags::add(std::uint32_t drag, Difference difference) {
    join(differences_[drag], std::move(difference));
}

Difference Drags::take(std::uint32_t drag) {
    const auto found = differences_.find(drag);
    if (found == differences_.end()) return {};
    Difference difference = std::move(found->second);
    differences_.erase(found);
    return difference;
}

void Drags::forget(std::uint32_t client) {
    const auto open = open_.find(client);
    if (open == open_.end()) return;
    differences_.erase(open->second.number);
    open_.erase(open);
}

void Drags::clear() {
    open_.clear();
    differences_.clear();
}

}  // namespace muster
