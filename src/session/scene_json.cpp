#include "session/scene_json.h"

#include "base/hash.h"
#include "base/json.h"
#include "environment/environment.h"
#include "muster/formation.h"
#include "muster/parameter_table.h"
#include "world/inspect.h"

namespace muster {
namespace {

constexpr int kColours = 6;  // Number of accent colours that the page has.

Json point(Vec2 p) {
    return Json::array({p.x, p.y});
}

Json points(const Polygon& polygon) {
    Json list = Json::array();
    for (const Vec2 p : polygon) list.push(point(p));
    return list;
}

Json obstacles(const Environment& environment) {
    Json list = Json::array();
    for (const ObstacleId id : environment.obstacleIds()) {
        const ObstacleDef& def = *environment.obstacle(id);
        Json item{{"id", id.value}, {"name", def.name}};
        if (def.polygon.empty()) {
            item["centre"] = point(def.centre);
            item["radius"] = def.radius;
        } else {
            item["polygon"] = points(def.polygon);
        }
        item["height"] = def.height;
        item["moving"] = !def.path.still();
        list.push(std::move(item));
    }
    return list;
}

Json patches(const Environment& environment) {
    Json list = Json::array();
    const auto& clips = environment.def().clips;
    for (const PatchId id : environment.patchIds()) {
        const PatchDef& def = *environment.patch(id);
        const auto motion = static_cast<std::size_t>(def.motion);
        const double clipSpeed = motion < clips.size() ? clips[motion].speed : 1.0;
        list.push(Json{{"id", id.value},
                       {"name", def.name},
                       {"polygon", points(def.polygon)},
                       {"motion", def.motion},
                       {"speed", def.speed > 0.0 ? def.speed : clipSpeed},
                       {"moving", !def.path.still()}});
    }
    return list;
}

Json clips(const Environment& environment) {
    Json list = Json::array();
    for (const ClipFacts& clip : environment.def().clips)
        list.push(Json{{"name", clip.name}, {"speed", clip.speed}, {"cyclic", clip.cyclic}});
    return list;
}

Json groups(const World& world) {
    Json list = Json::array();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        list.push(Json{{"id", view.id.value},
                       {"name", view.name},
                       {"count", view.count},
                       {"formation", formationName(view.formation)},
                       {"colour", (view.id.value + kColours - 1) % kColours}});
    }
    return list;
}

Json checkpoints(const World& world) {
    Json list = Json::array();
    for (const FormationCheckpointDef& checkpoint : world.checkpoints()) {
        list.push(Json{{"position", point(checkpoint.position)},
                       {"radius", checkpoint.radius},
                       {"formation", formationName(checkpoint.formation.kind)},
                       {"group", checkpoint.group}});
    }
    return list;
}

Json items(const World& world) {
    Json list = Json::array();
    for (const ItemDef& item : world.items())
        list.push(Json{{"position", point(item.position)}, {"radius", item.radius}});
    return list;
}

Json parameters(const World& world) {
    Json list = Json::array();
    for (const ParameterInfo& info : parameterTable()) {
        list.push(Json{{"name", info.name},
                       {"unit", info.unit},
                       {"minimum", info.minimum},
                       {"maximum", info.maximum},
                       {"description", info.description},
                       {"value", info.get(world.parameters())}});
    }
    return list;
}

}  // namespace

std::string buildSceneJson(const std::string& name, const WorldDef& def, const World& world,
                           bool demonstration) {
    const Environment& environment = inspect::environment(world);
    Json scene;
    scene["name"] = name;
    scene["title"] = def.name;
    scene["description"] = def.description;
    scene["credit"] = def.credit;
    scene["demonstration"] = demonstration;
    scene["box"] = Json{{"min", point(environment.def().box.min)}, {"max", point(environment.def().box.max)}};
    scene["cell"] = environment.def().cell;
    scene["radius"] = world.parameters().character.radius;
    scene["obstacles"] = obstacles(environment);
    scene["patches"] = patches(environment);
    scene["clips"] = clips(environment);
    scene["groups"] = groups(world);
    scene["items"] = items(world);
    scene["checkpoints"] = checkpoints(world);
    scene["parameters"] = parameters(world);
    // Names come from files. Bytes that are not UTF-8 are replaced, without an exception.
    return compactJson(scene);
}

std::uint64_t sceneSignature(const World& world) {
    Hash hash;
    hash.add(inspect::environment(world).staticVersion());
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        hash.add(view.id.value);
    }
    for (const ParameterInfo& info : parameterTable()) hash.add(info.get(world.parameters()));
    return hash.value();
}

}  // namespace muster
