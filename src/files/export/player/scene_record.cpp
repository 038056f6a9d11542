#include "files/export/player/scene_record.h"

#include <algorithm>

#include "engine/geometry/triangulation.h"
#include "files/export/player/player_format.h"

namespace muster {

void SceneRecord::begin(const ScenePlan& plan, bool moves) {
    coder_.bit(more_, true);
    coder_.bit(moves_, moves);
    pivot_ = moves ? plan.pivot : Vec2{};
}

void SceneRecord::end() {
    coder_.natural(kindModel_, static_cast<std::uint32_t>(PlayerShape::End));
}

std::string SceneRecord::finish() {
    coder_.bit(more_, false);
    return coder_.finish();
}

void SceneRecord::shape(PlayerShape kind, Finish finish) {
    kind_ = kind;
    coder_.natural(kindModel_, static_cast<std::uint32_t>(kind));
    coder_.natural(finishModel_, static_cast<std::uint32_t>(finish));
}

void SceneRecord::point(Vec2 at) {
    const Vec2 p = at - pivot_;
    const std::array<std::int32_t, 2> units{unitsOf(p.x, kShapeUnit), unitsOf(p.y, kShapeUnit)};
    for (std::size_t k = 0; k < 2; ++k) {
        coder_.whole(flat_[static_cast<std::size_t>(kind_)], units[k] - last_[k]);
        last_[k] = units[k];
    }
}

void SceneRecord::point(Vec3 at) {
    point(Vec2{static_cast<double>(at.x), static_cast<double>(at.y)});
    const std::int32_t z = unitsOf(static_cast<double>(at.z), kShapeUnit);
    coder_.whole(upright_[static_cast<std::size_t>(kind_)], z - last_[2]);
    last_[2] = z;
}

void SceneRecord::outline(const Polygon& polygon) {
    coder_.natural(countModel_, static_cast<std::uint32_t>(polygon.size()));
    for (const Vec2 p : polygon) point(p);
}

void SceneRecord::size(std::size_t slot, std::int32_t value) {
    const auto kind = static_cast<std::size_t>(kind_);
    coder_.whole(sizes_[kind][slot], value - lastSizes_[kind][slot]);
    lastSizes_[kind][slot] = value;
}

void SceneRecord::length(std::size_t slot, double metres) {
    size(slot, unitsOf(metres, kShapeUnit));
}

void SceneRecord::quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    shape(PlayerShape::Quad, finish);
    for (const Vec3 p : {a, b, c, d}) point(p);
}

void SceneRecord::floor(Finish finish, const Polygon& polygon, double z) {
    const auto parts = decomposeConvex(polygon);
    if (!parts.ok()) return;
    for (const Polygon& part : *parts) {
        shape(PlayerShape::Floor, finish);
        length(0, z);
        outline(part);
    }
}

void SceneRecord::level(Finish finish, const PolygonWithHoles& holed, const TriangleMesh& mesh) {
    // As few triangles as there can be.
    const Box box = boundsOf(holed.outline);
    const auto coarse = triangulate(holed, 2.0 * std::max(box.width(), box.height()));
    const TriangleMesh& used = coarse.ok() ? *coarse : mesh;
    shape(PlayerShape::Level, finish);
    outline(used.vertices);
    coder_.natural(countModel_, static_cast<std::uint32_t>(used.triangles.size()));
    std::int32_t last = 0;
    for (const Triangle& triangle : used.triangles) {
        for (const std::int32_t v : triangle) {
            coder_.whole(indexModel_, v - last);
            last = v;
        }
    }
}

void SceneRecord::walls(Finish finish, const Polygon& polygon, double low, double high, bool inside) {
    shape(PlayerShape::Walls, finish);
    length(0, low);
    length(1, high);
    size(2, inside ? 1 : 0);
    outline(polygon);
}

void SceneRecord::frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius,
                          int sides) {
    shape(PlayerShape::Frustum, finish);
    point(base);
    length(0, height);
    length(1, lowRadius);
    length(2, highRadius);
    size(3, sides);
}

void SceneRecord::beam(Finish finish, Vec3 a, Vec3 b, double width) {
    shape(PlayerShape::Beam, finish);
    point(a);
    point(b);
    length(0, width);
}

void SceneRecord::blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed, int rows,
                       int sides) {
    shape(PlayerShape::Blob, finish);
    point(centre);
    length(0, radius);
    length(1, height);
    size(2, rows);
    size(3, sides);
    coder_.natural(seedModel_, seed);
}

}  // namespace muster
