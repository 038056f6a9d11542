#include "studio/session/history/group_body.h"

#include <algorithm>
#include <string>

#include "engine/world/inspect.h"
#include "files/scenario/describe_forms.h"
#include "json/json.h"

namespace muster {
namespace {

constexpr const char* kKind = "groupBody";

/// One event. `failure` gets a sentence where it is bad.
SetBodies readEvent(const Json& event, const std::string& path, const World& world, std::string& failure) {
    SetBodies set;
    FieldReader reader(event, path, failure);
    std::string kind;
    reader.choice("kind", kind, {kKind}, "What the event is.", Need::Required);
    std::uint32_t id = 0;
    reader.whole("group", id, {1.0, 4294967295.0}, "Which group.", Need::Required);
    const Json* body = reader.find("body", Need::Required);
    reader.finish();
    if (reader.failed()) return set;
    const auto g = inspect::indexOfGroup(world, GroupId{id});
    if (!g || world.group(*g).members.empty()) {
        reader.fail("group", std::to_string(id), "a group with people in it");
        return set;
    }
    for (const std::int32_t member : world.group(*g).members) {
        const auto i = static_cast<std::size_t>(member);
        set.ids.push_back(world.characters().id[i]);
        FieldReader fields(*body, path + ".body", failure);
        describe(fields, set.bodies.emplace_back(world.characters().body[i]));
        fields.finish();
        if (fields.failed()) return set;
    }
    if (std::all_of(set.bodies.begin(), set.bodies.end(),
                    [&](const Body& one) { return one == set.bodies.front(); }))
        set.bodies.resize(1);
    return set;
}

}  // namespace

bool changesGroupBody(std::string_view text) {
    return text.find("\"groupBody\"") != std::string_view::npos;
}

Result<std::vector<CommandBody>> parseGroupBodies(std::string_view text, const SessionLimits& limits,
                                                  const World& world) {
    if (text.size() > limits.commandBytes)
        return Status(StatusCode::LimitExceeded, "found " + std::to_string(text.size()) +
                                                     " bytes of commands, expected at most " +
                                                     std::to_string(limits.commandBytes));
    const auto events = parseJson(text, "commands");
    if (!events.ok()) return events.status();
    if (!events->isArray()) return invalidArgument("commands: $: found no array, expected one of events");
    if (events->size() > limits.commandsPerMessage || events->size() > world.groupCount())
        return Status(StatusCode::LimitExceeded, "found " + std::to_string(events->size()) +
                                                     " events groupBody, expected one for each group");
    std::vector<CommandBody> bodies;
    for (std::size_t k = 0; k < events->size(); ++k) {
        std::string failure;
        SetBodies set = readEvent((*events)[k], "$[" + std::to_string(k) + "]", world, failure);
        if (!failure.empty()) return invalidArgument("commands: " + failure);
        bodies.emplace_back(std::move(set));
    }
    return bodies;
}

GroupBody groupBody(const World& world, std::size_t group) {
    const Parameters& parameters = world.parameters();
    GroupBody common{parameters.character.radius, parameters.character.maxSpeed, 0};
    bool first = true;
    for (const std::int32_t member : world.group(group).members) {
        const Body& body = world.characters().body[static_cast<std::size_t>(member)];
        const double radius = body.radius > 0.0 ? body.radius : parameters.character.radius;
        const double maxSpeed = body.maxSpeed > 0.0 ? body.maxSpeed : parameters.character.maxSpeed;
        const std::int32_t unitClass = body.unitClass;
        if (first) common = {radius, maxSpeed, unitClass};
        first = false;
        if (common.radius != radius) common.radius = -1.0;
        if (common.maxSpeed != maxSpeed) common.maxSpeed = -1.0;
        if (common.unitClass != unitClass) common.unitClass = -1;
    }
    return common;
}

}  // namespace muster
