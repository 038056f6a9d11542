#include "studio/session/history/group_body.h"

#include <algorithm>
#include <string>

#include "engine/world/inspect.h"

namespace muster {
namespace {

/// The bodies of all in a group once they have these numbers.
Result<ChangeCharacters> bodiesOf(const protocol::GroupBodyEdit& edit, const World& world) {
    const auto g = inspect::indexOfGroup(world, GroupId{edit.group});
    if (!g || world.group(*g).members.empty())
        return invalidArgument("found group " + std::to_string(edit.group) +
                               ", expected a group with people in it");
    ChangeCharacters set;
    std::vector<Body>& bodies = set.bodies.emplace();
    for (const std::int32_t member : world.group(*g).members) {
        const auto i = static_cast<std::size_t>(member);
        set.ids.push_back(world.characters().id[i]);
        Body& body = bodies.emplace_back(world.characters().body[i]);
        body.radius = edit.radius.value_or(body.radius);
        body.maxSpeed = edit.maxSpeed.value_or(body.maxSpeed);
        body.unitClass = edit.unitClass.value_or(body.unitClass);
    }
    if (std::all_of(bodies.begin(), bodies.end(), [&](const Body& one) { return one == bodies.front(); }))
        bodies.resize(1);
    return set;
}

}  // namespace

Result<std::vector<CommandBody>> bodiesOf(const std::vector<protocol::GroupBodyEdit>& edits,
                                          const World& world) {
    if (edits.size() > world.groupCount())
        return Status(StatusCode::LimitExceeded, "found bodies of " + std::to_string(edits.size()) +
                                                     " groups, expected one for each group");
    std::vector<CommandBody> bodies;
    for (const protocol::GroupBodyEdit& edit : edits) {
        auto set = bodiesOf(edit, world);
        if (!set.ok()) return set.status().within("bodies[" + std::to_string(bodies.size()) + "]");
        bodies.emplace_back(std::move(set).value());
    }
    return bodies;
}

protocol::GroupBody groupBody(const World& world, std::size_t group) {
    const Parameters& parameters = world.parameters();
    protocol::GroupBody common{parameters.character.radius, parameters.character.maxSpeed, std::uint8_t{0}};
    bool first = true;
    for (const std::int32_t member : world.group(group).members) {
        const Body& body = world.characters().body[static_cast<std::size_t>(member)];
        const double radius = body.radius > 0.0 ? body.radius : parameters.character.radius;
        const double maxSpeed = body.maxSpeed > 0.0 ? body.maxSpeed : parameters.character.maxSpeed;
        if (first) common = {radius, maxSpeed, body.unitClass};
        first = false;
        if (common.radius != radius) common.radius.reset();
        if (common.maxSpeed != maxSpeed) common.maxSpeed.reset();
        if (common.unitClass != body.unitClass) common.unitClass.reset();
    }
    return common;
}

}  // namespace muster
