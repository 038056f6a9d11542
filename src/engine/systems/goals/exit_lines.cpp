#include "engine/systems/goals/exit_lines.h"

#include <algorithm>

#include "engine/steering/crowd_bodies.h"

namespace muster {
namespace {

// Distance from one person to the next in a line, in the sum of their radii.
constexpr double kLineSpacing = 1.2;
constexpr double kJoinReach = 1.0;  // Distance from the end of the line at which a person joins it [m].

// The point at a length along a line; beyond its end straight on.
Vec2 pointAfter(const std::vector<Vec2>& line, double length) {
    for (std::size_t k = 1; k < line.size(); ++k) {
        const double edge = distance(line[k - 1], line[k]);
        if (length <= edge || k + 1 == line.size())
            return edge > 0.0 ? line[k - 1] + (line[k] - line[k - 1]) * (length / edge) : line[k];
        length -= edge;
    }
    return line.front();
}

}  // namespace

// Keeps the people in the line that still want to leave by the exit; true where the exit has a line.
bool ExitLines::keep(WorldState& state, Area& area) {
    const Characters& c = state.characters;
    if (area.def.queue.empty()) return false;
    std::erase_if(area.exit.line, [&](std::uint32_t id) {
        const std::int32_t i = c.indexOf(id);
        return i < 0 || c.goal[i] != area.id.value;
    });
    return true;
}

void ExitLines::layOut(const WorldState& state, const Area& area) {
    const Characters& c = state.characters;
    const Parameters::Character& usual = state.parameters.character;
    double along = 0.0, before = 0.0;
    for (std::size_t k = 0; k < area.exit.line.size(); ++k) {
        const std::int32_t i = c.indexOf(area.exit.line[k]);
        const double radius = radiusOf(usual, c.body[i]);
        if (k > 1) along += kLineSpacing * (before + radius);
        before = radius;
        duty_[i] = k == 0 ? Duty::Free : Duty::Stand;
        spot_[i] = pointAfter(area.def.queue, along);
    }
    if (area.exit.line.size() > 1) along += kLineSpacing * (before + usual.radius);
    end_ = pointAfter(area.def.queue, along);
}

// The nearest of the people who have come to the end of the line joins it.
void ExitLines::join(WorldState& state, Area& area, GoalFields& fields,
                     std::span<const std::int32_t> groundClasses) {
    const Characters& c = state.characters;
    std::int32_t next = -1;
    double least = kJoinReach;
    for (std::size_t i = 0; i < c.size(); ++i) {
        if (c.goal[i] != area.id.value || duty_[i] != Duty::Join) continue;
        spot_[i] = end_;
        const double away = distance(c.position[i], end_);
        if (away > least || !fields.ground(groundClasses[i]).collisionFree(c.position[i], end_)) continue;
        if (away < least || next < 0) next = static_cast<std::int32_t>(i);
        least = away;
    }
    if (next < 0) return;
    duty_[next] = area.exit.line.empty() ? Duty::Free : Duty::Stand;
    area.exit.line.push_back(c.id[next]);
}

void ExitLines::run(WorldState& state, GoalFields& fields, std::span<const std::int32_t> groundClasses) {
    const Characters& c = state.characters;
    duty_.clear();
    const auto hasLine = [](const Area& area) { return !area.def.queue.empty(); };
    if (std::none_of(state.areas.begin(), state.areas.end(), hasLine)) return;
    duty_.assign(c.size(), Duty::Free);
    spot_.resize(c.size());
    for (std::size_t i = 0; i < c.size(); ++i) {
        const Area* const area = c.goal[i] == 0 ? nullptr : state.findArea(AreaId{c.goal[i]});
        if (area != nullptr && area->def.kind == AreaKind::Exit && hasLine(*area)) duty_[i] = Duty::Join;
    }
    for (Area& area : state.areas) {
        if (area.def.kind != AreaKind::Exit || !keep(state, area)) continue;
        layOut(state, area);
        join(state, area, fields, groundClasses);
    }
}

}  // namespace muster
