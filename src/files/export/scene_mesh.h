// Ground, obstacles, patches and areas of a world as meshes, for all formats that hold meshes.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "engine/geometry/polygon.h"
#include "muster/ground.h"
#include "muster/vec3.h"
#include "muster/world.h"

namespace muster {

inline float toFloat(double value) {
    return static_cast<float>(value);
}
/// The point at height `z` above a point of the ground.
inline Vec3 pointAt(Vec2 p, double z) {
    return {toFloat(p.x), toFloat(p.y), toFloat(z)};
}

/// The material of a surface.
enum class Finish : std::uint8_t {
    Ground,
    Wall,
    Roof,
    Stone,
    Trunk,
    Crown,
    Leaves,
    Water,
    Tile,
    Coping,
    NetFloor,
    Net,
    Brick,
    Floor,
    Shade,
    Glass,
    Tyre,
    Paint1,
    Paint2,
    Paint3,
    Paint4,
    Fur,
    Exit,
    Source,
    Waiting,
    Count
};

/// The look of a finish.
struct FinishLook {
    const char* name;      ///< For example "ground".
    std::uint32_t colour;  ///< 0xRRGGBB in sRGB.
    float alpha = 1.0f;    ///< Opacity; below 1 for transparent finishes.
    float roughness = 0.9f;
};
/// The look of that finish.
const FinishLook& finishLook(Finish finish);
/// Red, green and blue of 0xRRGGBB in linear light, 0 to 1.
Vec3 linearColour(std::uint32_t colour);

/// Triangles of one finish with flat shading, anticlockwise when seen from outside.
struct SceneSurface {
    Finish finish = Finish::Ground;
    std::vector<Vec3> positions;  ///< Relative to the thing's pivot [m]; three per triangle unless shared.
    std::vector<Vec3> normals;    ///< Unit vectors, one per position.
    std::vector<std::uint32_t> indices;
};

/// An object that stands or moves as a whole.
struct SceneThing {
    std::string name;                    ///< Unique within the scene, not empty.
    Vec2 pivot;                          ///< Centre of rotation and origin of its surfaces [m].
    TimedPath path;                      ///< Its motion; empty for a static object.
    std::vector<SceneSurface> surfaces;  ///< At least one; each has a different finish.

    /// Position of the pivot at `time` [s]; turn() gives the rotation there.
    Vec2 place(double time) const { return pivot + path.at(time).position; }
    double turn(double time) const { return path.at(time).angle; }  ///< [rad]
};

/// The ground, then obstacles, patches and areas, in the world's present state.
std::vector<SceneThing> makeScene(const World& world);

/// What one object of a scene is made of. Makers of objects call it; what becomes of the shapes is up to
/// those who implement it.
class SceneShapes {
public:
    virtual ~SceneShapes() = default;

    /// Adds a flat quadrangle, anticlockwise when seen from outside.
    virtual void quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d) = 0;
    /// Adds a horizontal polygon at a height [m], counter-clockwise, seen from above.
    virtual void floor(Finish finish, const Polygon& outline, double z) = 0;
    /// Adds a horizontal mesh at height 0, seen from above. Where its triangles begin and end does not
    /// matter, so that others may be made from the same outline and holes.
    virtual void level(Finish finish, const PolygonWithHoles& shape, const TriangleMesh& mesh) = 0;
    /// Adds vertical walls along a counter-clockwise polygon, seen from outside or from inside.
    virtual void walls(Finish finish, const Polygon& outline, double low, double high,
                       bool inside = false) = 0;
    /// Adds a truncated vertical cone with a lid; its sides have smooth shading.
    virtual void frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius,
                         int sides) = 0;
    /// Adds a beam of square section between two points.
    virtual void beam(Finish finish, Vec3 a, Vec3 b, double width) = 0;
    /// Adds an irregular ball of flat facets: radius on the ground and half its height [m]; `seed` varies its
    /// shape.
    virtual void blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed,
                      int rows = 5, int sides = 9) = 0;

    /// Adds walls with a lid.
    void prism(Finish side, Finish lid, const Polygon& outline, double low, double high);
};

/// The definition of an object of a scene.
struct ScenePlan {
    std::string name;  ///< Unique within the scene, not empty.
    Vec2 pivot;        ///< Centre of rotation [m].
    TimedPath path;    ///< Its motion; empty for a static object.
};
/// Calls `visit` for the ground, then for obstacles, patches and areas, in the world's present state. `visit`
/// gets what the object is and a function that adds its shapes, at their places in the world.
void visitScene(const World& world,
                const std::function<void(const ScenePlan&, const std::function<void(SceneShapes&)>&)>& visit);

/// Collects the surfaces of one object.
class SceneMeshBuilder final : public SceneShapes {
public:
    /// Everything added is moved by -pivot.
    explicit SceneMeshBuilder(Vec2 pivot) : pivot_(pivot) {}

    /// Adds a flat triangle, anticlockwise when seen from outside.
    void triangle(Finish finish, Vec3 a, Vec3 b, Vec3 c);
    void quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d) override;
    void floor(Finish finish, const Polygon& outline, double z) override;
    void level(Finish finish, const PolygonWithHoles& shape, const TriangleMesh& mesh) override;
    void walls(Finish finish, const Polygon& outline, double low, double high, bool inside = false) override;
    void frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius,
                 int sides) override;
    void beam(Finish finish, Vec3 a, Vec3 b, double width) override;
    void blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed, int rows = 5,
              int sides = 9) override;

    /// The surfaces so far.
    std::vector<SceneSurface> take() { return std::move(surfaces_); }

private:
    SceneSurface& surface(Finish finish);
    std::uint32_t corner(SceneSurface& surface, Vec3 position, Vec3 normal);

    Vec2 pivot_;
    std::vector<SceneSurface> surfaces_;
};

/// The rectangle around an outline, aligned with the outline's longest side.
struct OutlineBox {
    Vec2 centre;
    Rotation turn;            ///< Rotation from +x to the long side.
    double halfLength = 0.0;  ///< [m]
    double halfWidth = 0.0;   ///< [m]
    /// The point at these distances from the centre, along the long side and across it [m].
    Vec2 at(double along, double across) const { return centre + turn.apply({along, across}); }
};
OutlineBox outlineBox(const Polygon& outline);  ///< The box of an outline with at least two corners.

/// A pseudo-random number from 0 to 1; the same arguments give the same number.
double thrown(std::uint32_t a, std::uint32_t b);

/// A regular polygon about `centre`, counter-clockwise.
Polygon circle(Vec2 centre, double radius, int corners);

/// Adds an obstacle as defined.
void addObstacle(const ObstacleDef& obstacle, SceneShapes& shapes);
/// Adds a patch as defined, with the look of the clip of that name. `open` is true where the ground below it
/// is left out; `floor` is the height of its own floor [m].
void addPatch(const PatchDef& patch, const std::string& clip, bool open, double floor, SceneShapes& shapes);

}  // namespace muster
