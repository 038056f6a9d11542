// All objects of a world.
#include <algorithm>
#include <array>
#include <optional>
#include <set>

#include "engine/geometry/triangulation.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "files/export/scene_mesh.h"

namespace muster {
namespace {

constexpr double kFloor = 0.006;  // Height of the lowest patch floor above the ground [m].
// Each further floor lies higher by this much [m], so that the upper one shows where floors overlap.
constexpr double kFloorStep = 0.0007;
constexpr double kHighestFloor = 0.0155;  // Height of the highest floor [m].
constexpr double kAreaFloor = 0.0165;     // Height of exits, sources and waiting areas [m].
constexpr double kApron = 40.0;           // Width of the ground beyond the world's edge [m].

/// A unique name. An unnamed object is called by `kind`; later ones get a number.
std::string nameOf(const std::string& given, const char* kind, std::set<std::string>& names) {
    const std::string base = given.empty() ? kind : given;
    std::string name = base;
    for (int k = 2; !names.insert(name).second; ++k) name = base + " " + std::to_string(k);
    return name;
}

const std::string& clipOf(const Environment& environment, const PatchDef& patch) {
    const auto motion = static_cast<std::size_t>(patch.motion);
    static const std::string kRun = "run";
    return motion < environment.def().clips.size() ? environment.def().clips[motion].name : kRun;
}

/// The ground with holes for pools, as an outline and as a mesh.
struct GroundShape {
    PolygonWithHoles outline;
    std::optional<TriangleMesh> mesh;  ///< None where there are no holes, or they cannot be cut.
};

GroundShape groundShape(const Box& box, const std::vector<Polygon>& pools) {
    GroundShape ground;
    ground.outline.outline = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    if (pools.empty()) return ground;
    for (const Polygon& pool : pools) ground.outline.holes.emplace_back(pool.rbegin(), pool.rend());
    auto mesh = triangulate(ground.outline, std::max(box.width(), box.height()) / 40.0);
    if (mesh.ok()) ground.mesh = std::move(mesh).value();
    return ground;
}

std::vector<Polygon> poolsOf(const Environment& environment) {
    std::vector<Polygon> pools;
    for (const PatchId id : environment.patchIds()) {
        const PatchDef& patch = *environment.patch(id);
        const auto outline = cleanPolygon(patch.polygon);
        if (patch.path.still() && outline.ok() && clipOf(environment, patch) == "swim")
            pools.push_back(*outline);
    }
    return pools;
}

Vec2 pivotOf(const Polygon& polygon) {
    const auto outline = cleanPolygon(polygon);
    return centroid(outline.ok() ? *outline : polygon);
}

using Visit = std::function<void(const ScenePlan&, const std::function<void(SceneShapes&)>&)>;

void visitAreas(const World& world, std::set<std::string>& names, const Visit& visit) {
    struct Look {
        const char* name;
        Finish finish;
    };
    constexpr std::array<Look, 3> kAreas{
        {{"Exit", Finish::Exit}, {"Source", Finish::Source}, {"Waiting area", Finish::Waiting}}};
    for (std::size_t a = 0; a < world.areaCount(); ++a) {
        const AreaDef def = world.area(a).def;
        const auto outline = cleanPolygon(def.polygon);
        if (!outline.ok()) continue;
        const Look& look = kAreas[static_cast<std::size_t>(def.kind)];
        visit({nameOf(def.name, look.name, names), pivotOf(def.polygon), {}},
              [&](SceneShapes& shapes) { shapes.floor(look.finish, *outline, kAreaFloor); });
    }
}

}  // namespace

void visitScene(
    const World& world,
    const std::function<void(const ScenePlan&, const std::function<void(SceneShapes&)>&)>& visit) {
    const Environment& environment = inspect::environment(world);
    std::set<std::string> names;
    const std::vector<Polygon> pools = poolsOf(environment);
    const GroundShape ground = groundShape(environment.def().box.grown(kApron), pools);
    const bool open = pools.empty() || ground.mesh.has_value();
    visit({nameOf("Ground", "Ground", names), {}, {}}, [&](SceneShapes& shapes) {
        if (ground.mesh)
            shapes.level(Finish::Ground, ground.outline, *ground.mesh);
        else
            shapes.floor(Finish::Ground, ground.outline.outline, 0.0);
    });
    for (const ObstacleId id : environment.obstacleIds()) {
        const ObstacleDef& def = *environment.obstacle(id);
        const Vec2 pivot = def.polygon.empty() ? def.centre : pivotOf(def.polygon);
        visit({nameOf(def.name, "Obstacle", names), pivot, def.path},
              [&](SceneShapes& shapes) { addObstacle(def, shapes); });
    }
    double floor = kFloor;
    for (const PatchId id : environment.patchIds()) {
        const PatchDef& def = *environment.patch(id);
        visit({nameOf(def.name, "Patch", names), pivotOf(def.polygon), def.path}, [&](SceneShapes& shapes) {
            addPatch(def, clipOf(environment, def), open && def.path.still(), floor, shapes);
        });
        floor = floor < kHighestFloor ? floor + kFloorStep : kFloor;
    }
    visitAreas(world, names, visit);
}

std::vector<SceneThing> makeScene(const World& world) {
    std::vector<SceneThing> things;
    visitScene(world, [&](const ScenePlan& plan, const std::function<void(SceneShapes&)>& addShapes) {
        SceneMeshBuilder builder(plan.pivot);
        addShapes(builder);
        auto surfaces = builder.take();
        if (!surfaces.empty()) things.push_back({plan.name, plan.pivot, plan.path, std::move(surfaces)});
    });
    return things;
}

}  // namespace muster
