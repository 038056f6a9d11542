#include "studio/session/frames/scene_message.h"

#include <string>
#include <vector>

#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "muster/order.h"
#include "muster/parameter_table.h"
#include "studio/session/history/group_body.h"

namespace muster {
namespace {

constexpr std::uint32_t kAccents = 6;  // Number of accent colours that the page has.

void addGround(const Environment& environment, protocol::Scene& scene) {
    const EnvironmentDef& def = environment.def();
    scene.box = {def.box.min, def.box.max};
    scene.cell = def.cell;
    for (const ClipFacts& clip : def.clips) scene.clips.push_back({clip.name, clip.speed});
    for (const ObstacleId id : environment.obstacleIds())
        scene.obstacles.push_back({id.value, *environment.obstacle(id)});
    for (const PatchId id : environment.patchIds())
        scene.patches.push_back({id.value, *environment.patch(id)});
}

void addSpots(const World& world, protocol::Scene& scene) {
    for (std::size_t i = 0; i < world.items().size(); ++i)
        scene.items.push_back({world.itemIds()[i].value, world.items()[i]});
    for (std::size_t c = 0; c < world.checkpoints().size(); ++c)
        scene.checkpoints.push_back(
            {world.checkpointIds()[c].value, world.checkpoints()[c], world.checkpointGroups()[c].value});
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        const AreaView area = world.area(a);
        scene.areas.push_back({area.id.value, area.def, area.group.value});
    }
}

/// The body of another group like this one: what the parameters would give it is left to them.
std::vector<Body> startBodies(const protocol::GroupBody& common, const Parameters& parameters) {
    Body body;
    if (common.radius != parameters.character.radius) body.radius = common.radius.value_or(body.radius);
    if (common.maxSpeed != parameters.character.maxSpeed)
        body.maxSpeed = common.maxSpeed.value_or(body.maxSpeed);
    body.unitClass = common.unitClass.value_or(body.unitClass);
    return body == Body() ? std::vector<Body>() : std::vector<Body>{body};
}

/// What the page takes hold of. Positions and first orders are left out: they may be long.
GroupDef startOf(const GroupView& now, const GroupDef& current, const PlaceGroupDef* placed) {
    GroupDef def;
    def.name = now.name;
    def.colour = now.colour;
    def.build = now.build;
    def.motions = now.motions;
    def.roles = current.roles;
    if (!placed) return def;
    def.count = placed->def.count;
    def.position = placed->def.position;
    def.angle = placed->def.angle;
    def.formation = placed->def.formation;
    def.people = placed->def.people;
    return def;
}

void addGroups(const World& world, const Place& place, protocol::Scene& scene) {
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView now = world.group(g);
        const PlaceGroupDef* placed = place.group(now.id);
        protocol::SceneGroup group;
        group.id = now.id.value;
        group.accent = static_cast<std::uint8_t>((now.id.value + kAccents - 1) % kAccents);
        group.count = static_cast<std::uint32_t>(now.count);
        group.formation = formationName(now.formation);
        group.placed = placed != nullptr;
        group.definition = startOf(now, inspect::groupDef(world, g), placed);
        group.body = groupBody(world, g);
        group.definition.bodies = startBodies(group.body, world.parameters());
        scene.groups.push_back(std::move(group));
    }
}

}  // namespace

protocol::Scene sceneMessage(const SceneSource& source, std::uint32_t revision) {
    const World& world = source.world;
    protocol::Scene scene;
    scene.revision = revision;
    scene.world = source.worldNumber;
    scene.name = source.name;
    scene.title = source.def.name;
    scene.description = source.def.description;
    scene.credit = source.def.credit;
    scene.demonstration = source.demonstration;
    scene.radius = world.parameters().character.radius;
    scene.ring = world.ring();
    addGround(inspect::environment(world), scene);
    addSpots(world, scene);
    addGroups(world, source.place, scene);
    for (const ParameterInfo& info : parameterTable())
        scene.parameters.push_back({std::string(info.name), info.get(world.parameters())});
    return scene;
}

}  // namespace muster
