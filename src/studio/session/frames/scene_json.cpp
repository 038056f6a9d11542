#include "studio/session/frames/scene_json.h"

#include "base/appearance_text.h"
#include "base/archive.h"
#include "base/hash.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/scenario/describe_forms.h"
#include "json/json.h"
#include "muster/formation.h"
#include "muster/parameter_table.h"
#include "studio/session/history/group_body.h"

namespace muster {
namespace {

constexpr int kColours = 6;  // Number of accent colours that the page has.
constexpr std::uint32_t kNoColour = 0xFFFFFFFF;
constexpr std::uint8_t kUnchosen = 0xFF;

Json point(Vec2 p) {
    return Json::array({p.x, p.y});
}

Json points(const Polygon& polygon) {
    Json list = Json::array();
    for (const Vec2 p : polygon) list.push(point(p));
    return list;
}

void putPath(Json& item, const TimedPath& path) {
    if (path.still()) return;
    Json waypoints = Json::array();
    for (const Waypoint& w : path.waypoints)
        waypoints.push(Json{{"t", w.time}, {"x", w.position.x}, {"y", w.position.y}, {"angle", w.angle}});
    item["path"] = Json{{"waypoints", std::move(waypoints)}, {"loop", path.loop}};
}

/// As in scenario files.
Json shape(const FormationDef& formation) {
    Json item;
    FieldWriter writer(item);
    FormationDef copy = formation;
    describe(writer, copy);
    return item;
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
        putPath(item, def.path);
        if (def.range >= 0.0) item["range"] = def.range;
        if (def.strength >= 0.0) item["strength"] = def.strength;
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
        Json item{{"id", id.value},
                  {"name", def.name},
                  {"polygon", points(def.polygon)},
                  {"motion", def.motion},
                  {"speed", def.speed > 0.0 ? def.speed : clipSpeed},
                  {"moving", !def.path.still()}};
        putPath(item, def.path);
        if (def.speed > 0.0) item["ownSpeed"] = def.speed;
        if (def.ascent) item["ascent"] = *def.ascent;
        if (def.speedDown > 0.0) item["speedDown"] = def.speedDown;
        list.push(std::move(item));
    }
    return list;
}

Json clips(const Environment& environment) {
    Json list = Json::array();
    for (const ClipFacts& clip : environment.def().clips)
        list.push(Json{{"name", clip.name}, {"speed", clip.speed}, {"cyclic", clip.cyclic}});
    return list;
}

/// What all in a group have in common.
Json body(const GroupBody& common) {
    Json item = Json::object();
    if (common.radius >= 0.0) item["radius"] = common.radius;
    if (common.maxSpeed >= 0.0) item["maxSpeed"] = common.maxSpeed;
    if (common.unitClass >= 0) item["class"] = common.unitClass;
    return item;
}

/// As in scenario files.
Json roles(const std::vector<RoleDef>& roles) {
    Json item;
    FieldWriter writer(item);
    std::vector<RoleDef> copy = roles;
    describeRoles(writer, copy, Need::Required);
    return item["roles"];
}

/// As in scenario files.
Json people(const std::vector<PeopleDef>& people) {
    Json item;
    FieldWriter writer(item);
    std::vector<PeopleDef> copy = people;
    describePeople(writer, copy);
    return item["people"];
}

Json groups(const World& world, const Place& place) {
    Json list = Json::array();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const GroupView view = world.group(g);
        Json item{{"id", view.id.value},
                  {"name", view.name},
                  {"count", view.count},
                  {"formation", formationName(view.formation)},
                  {"colour", (view.id.value + kColours - 1) % kColours}};
        if (view.colour) item["chosenColour"] = colourText(*view.colour);
        if (view.build) item["build"] = kBodyBuildWords[static_cast<std::size_t>(*view.build)];
        if (view.motions) item["motions"] = kMotionSetWords[static_cast<std::size_t>(*view.motions)];
        if (const PlaceGroupDef* start = place.group(view.id)) {
            Json begins{
                {"count", start->def.count},         {"position", point(start->def.position)},
                {"angle", start->def.angle},         {"formation", shape(start->def.formation)},
                {"body", body(groupBody(world, g))}, {"roles", roles(inspect::groupDef(world, g).roles)}};
            if (!start->def.people.empty()) begins["people"] = people(start->def.people);
            item["start"] = std::move(begins);
        }
        list.push(std::move(item));
    }
    return list;
}

Json checkpoints(const World& world) {
    Json list = Json::array();
    for (std::size_t c = 0; c < world.checkpoints().size(); ++c) {
        const FormationCheckpointDef& checkpoint = world.checkpoints()[c];
        list.push(Json{{"id", world.checkpointIds()[c].value},
                       {"position", point(checkpoint.position)},
                       {"radius", checkpoint.radius},
                       {"formation", formationName(checkpoint.formation.kind)},
                       {"shape", shape(checkpoint.formation)},
                       {"group", world.checkpointGroups()[c].value},
                       {"once", checkpoint.once},
                       {"trigger", checkpoint.trigger == CheckpointTrigger::Mesh ? "mesh" : "crowd"},
                       {"share", checkpoint.share}});
    }
    return list;
}

Json items(const World& world) {
    Json list = Json::array();
    for (std::size_t i = 0; i < world.items().size(); ++i)
        list.push(Json{{"id", world.itemIds()[i].value},
                       {"position", point(world.items()[i].position)},
                       {"radius", world.items()[i].radius}});
    return list;
}

/// As in scenario files, with ids.
Json areas(const World& world) {
    Json list = Json::array();
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        AreaView area = world.area(a);
        Json item;
        FieldWriter writer(item);
        describe(writer, area.def, [] {});
        item["id"] = area.id.value;
        if (area.group) item["group"] = area.group.value;
        list.push(std::move(item));
    }
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

std::string buildSceneJson(const SceneSource& source) {
    const World& world = source.world;
    const WorldDef& def = source.def;
    const Environment& environment = inspect::environment(world);
    Json scene;
    scene["world"] = source.worldNumber;
    scene["name"] = source.name;
    scene["title"] = def.name;
    scene["description"] = def.description;
    scene["credit"] = def.credit;
    scene["demonstration"] = source.demonstration;
    scene["box"] = Json{{"min", point(environment.def().box.min)}, {"max", point(environment.def().box.max)}};
    scene["cell"] = environment.def().cell;
    scene["radius"] = world.parameters().character.radius;
    scene["obstacles"] = obstacles(environment);
    scene["patches"] = patches(environment);
    scene["clips"] = clips(environment);
    scene["groups"] = groups(world, source.place);
    scene["items"] = items(world);
    scene["checkpoints"] = checkpoints(world);
    scene["areas"] = areas(world);
    if (world.ring()) scene["ring"] = true;
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
        for (const char c : view.name) hash.add(static_cast<std::uint8_t>(c));
        hash.add(view.colour.value_or(kNoColour));
        hash.add(view.build ? static_cast<std::uint8_t>(*view.build) : kUnchosen);
        hash.add(view.motions ? static_cast<std::uint8_t>(*view.motions) : kUnchosen);
    }
    for (std::size_t i = 0; i < world.items().size(); ++i) {
        hash.add(world.itemIds()[i].value);
        hash.add(world.items()[i].position.x);
        hash.add(world.items()[i].position.y);
        hash.add(world.items()[i].radius);
    }
    for (std::size_t c = 0; c < world.checkpoints().size(); ++c) {
        hash.add(world.checkpointIds()[c].value);
        hash.add(world.checkpoints()[c].position.x);
        hash.add(world.checkpoints()[c].position.y);
        hash.add(world.checkpoints()[c].radius);
    }
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        AreaView area = world.area(a);
        hash.add(area.id.value);
        hash.add(area.group.value);
        Hasher def;
        def(area.def);
        hash.add(def.value());
    }
    for (const ParameterInfo& info : parameterTable()) hash.add(info.get(world.parameters()));
    return hash.value();
}

}  // namespace muster
