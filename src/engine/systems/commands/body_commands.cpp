#include "engine/systems/commands/body_commands.h"

#include <algorithm>
#include <string>

#include "engine/steering/crowd_bodies.h"
#include "engine/systems/commands/generated/command_functions.h"
#include "engine/systems/commands/not_found.h"

namespace muster {
namespace {

constexpr double kTopSpeedOutside = 1e5;  // Top speed of a character that is moved from outside [m/s].

Status allExist(const Characters& characters, const std::vector<std::uint32_t>& ids) {
    for (const std::uint32_t id : ids)
        if (characters.indexOf(id) < 0) return noCharacter(id);
    return {};
}

}  // namespace

Status apply(CommandContext& context, const ChangeCharacters& change) {
    WorldState& state = context.groups();
    Characters& c = state.characters;
    if (Status s = allExist(c, change.ids); !s.ok()) return s;
    for (std::size_t k = 0; k < change.ids.size(); ++k) {
        const std::int32_t i = c.indexOf(change.ids[k]);
        if (change.bodies) c.body[i] = (*change.bodies)[std::min(k, change.bodies->size() - 1)];
        if (change.driver) c.driver[i] = *change.driver;
    }
    return {};
}

Status apply(CommandContext& context, const WriteMotion& command) {
    WorldState& state = context.state;
    Characters& c = state.characters;
    if (Status s = allExist(c, command.ids); !s.ok()) return s;
    for (const std::uint32_t id : command.ids)
        if (c.driver[c.indexOf(id)] != Driver::Outside)
            return invalidArgument("character " + std::to_string(id) +
                                   " is moved by Muster, not from outside");
    const Box& box = state.environment.def().box;
    for (std::size_t k = 0; k < command.ids.size(); ++k) {
        const std::int32_t i = c.indexOf(command.ids[k]);
        const double radius = radiusOf(state.parameters.character, c.body[i]);
        const Vec2 to = box.grown(-std::min({radius, 0.5 * box.width(), 0.5 * box.height()}))
                            .clamp(command.positions[k]);
        const Vec2 by = command.velocities.empty() ? (to - c.position[i]) / state.parameters.stepTime
                                                   : command.velocities[k];
        c.position[i] = to;
        c.velocity[i] = clampLength(by, kTopSpeedOutside);
    }
    return {};
}

void restOutside(WorldState& state) {
    Characters& c = state.characters;
    for (std::size_t i = 0; i < c.size(); ++i)
        if (c.driver[i] == Driver::Outside) c.velocity[i] = {};
}

}  // namespace muster
