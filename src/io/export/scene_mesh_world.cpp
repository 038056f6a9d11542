// All objects of a world.
#include <algorithm>
#include <set>

#include "environment/environment.h"
#include "geometry/triangulation.h"
#include "io/export/scene_mesh.h"
#include "world/inspect.h"

namespace muster {
namespace {

constexpr double kFloor = 0.006;  // Height of the lowest patch floor above the ground [m].
// Each further floor lies higher by this much [m], so that the upper one shows where floors overlap.
constexpr double kFloorStep = 0.0007;
constexpr double kHighestFloor = 0.0155;  // Height of the highest floor [m].
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

/// Adds the ground with holes for pools; returns false and adds nothing where the holes cannot be cut.
bool addGround(const Environment& environment, const std::vector<Polygon>& pools, SceneMeshBuilder& builder) {
    const Box box = environment.def().box.grown(kApron);
    PolygonWithHoles shape;
    shape.outline = {box.min, {box.max.x, box.min.y}, box.max, {box.min.x, box.max.y}};
    for (const Polygon& pool : pools) shape.holes.emplace_back(pool.rbegin(), pool.rend());
    if (pools.empty()) return builder.floor(Finish::Ground, shape.outline, 0.0), true;
    const double spacing = std::max(box.width(), box.height()) / 40.0;
    const auto mesh = triangulate(shape, spacing);
    if (!mesh.ok()) return false;
    const auto corner = [&](std::int32_t v) {
        const Vec2 p = mesh->vertices[v];
        return Vec3{static_cast<float>(p.x), static_cast<float>(p.y), 0.0f};
    };
    for (const Triangle& t : mesh->triangles)
        builder.triangle(Finish::Ground, corner(t[0]), corner(t[1]), corner(t[2]));
    return true;
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

}  // namespace

std::vector<SceneThing> makeScene(const World& world) {
    const Environment& environment = inspect::environment(world);
    std::vector<SceneThing> things;
    std::set<std::string> names;
    const auto add = [&](const std::string& name, const char* kind, Vec2 pivot, const TimedPath& path,
                         SceneMeshBuilder&& builder) {
        auto surfaces = builder.take();
        if (!surfaces.empty())
            things.push_back({nameOf(name, kind, names), pivot, path, std::move(surfaces)});
    };
    SceneMeshBuilder ground({});
    const bool open = addGround(environment, poolsOf(environment), ground);
    if (!open) addGround(environment, {}, ground);
    add("Ground", "Ground", {}, {}, std::move(ground));
    for (const ObstacleId id : environment.obstacleIds()) {
        const ObstacleDef& def = *environment.obstacle(id);
        const Vec2 pivot = def.polygon.empty() ? def.centre : pivotOf(def.polygon);
        SceneMeshBuilder builder(pivot);
        addObstacle(def, builder);
        add(def.name, "Obstacle", pivot, def.path, std::move(builder));
    }
    double floor = kFloor;
    for (const PatchId id : environment.patchIds()) {
        const PatchDef& def = *environment.patch(id);
        const Vec2 pivot = pivotOf(def.polygon);
        SceneMeshBuilder builder(pivot);
        addPatch(def, clipOf(environment, def), open && def.path.still(), floor, builder);
        floor = floor < kHighestFloor ? floor + kFloorStep : kFloor;
        add(def.name, "Patch", pivot, def.path, std::move(builder));
    }
    return things;
}

}  // namespace muster
