// What stands in a world, as meshes: ground, obstacles, patches. Shared by all formats that hold meshes.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "geometry/polygon.h"
#include "muster/obstacle.h"
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

/// What a surface is made of.
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
    Count
};

/// How a finish looks.
struct FinishLook {
    const char* name;      ///< "ground"...
    std::uint32_t colour;  ///< 0xRRGGBB, as screens take it (sRGB).
    float alpha = 1.0f;    ///< Below 1 for what one sees through.
    float roughness = 0.9f;
};
/// Of that finish.
const FinishLook& finishLook(Finish finish);
/// Red, green and blue of 0xRRGGBB in linear light, 0 to 1.
Vec3 linearColour(std::uint32_t colour);

/// Triangles of one finish, shaded flat; anticlockwise seen from outside.
struct SceneSurface {
    Finish finish = Finish::Ground;
    std::vector<Vec3> positions;  ///< From the thing's pivot [m]; three a triangle unless shared.
    std::vector<Vec3> normals;    ///< Unit; as many.
    std::vector<std::uint32_t> indices;
};

/// Something that stands or moves as a whole.
struct SceneThing {
    std::string name;                    ///< Unique within the scene, not empty.
    Vec2 pivot;                          ///< It turns about here; its surfaces start from here [m].
    TimedPath path;                      ///< Moves it; empty for one that stands still.
    std::vector<SceneSurface> surfaces;  ///< At least one, each of another finish.

    /// Where its pivot is at `time` [s], and how it is turned there [rad].
    Vec2 place(double time) const { return pivot + path.at(time).position; }
    double turn(double time) const { return path.at(time).angle; }  ///< [rad]
};

/// The ground, then obstacles, then patches, as they are in the world now.
std::vector<SceneThing> makeScene(const World& world);

/// Collects the surfaces of one thing.
class SceneMeshBuilder {
public:
    /// All that is added is moved by -pivot.
    explicit SceneMeshBuilder(Vec2 pivot) : pivot_(pivot) {}

    /// A flat triangle, anticlockwise seen from outside.
    void triangle(Finish finish, Vec3 a, Vec3 b, Vec3 c);
    /// A flat quadrangle likewise.
    void quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d);
    /// A polygon, counter-clockwise, at a height [m], seen from above.
    void floor(Finish finish, const Polygon& outline, double z);
    /// Upright walls along a polygon, counter-clockwise, seen from outside or from inside.
    void walls(Finish finish, const Polygon& outline, double low, double high, bool inside = false);
    /// Walls with a lid.
    void prism(Finish side, Finish lid, const Polygon& outline, double low, double high);
    /// An upright cone cut off, with a lid; its sides are smooth.
    void frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius, int sides);
    /// A beam of square section between two points.
    void beam(Finish finish, Vec3 a, Vec3 b, double width);
    /// A lumpy ball of facets: radius on the ground and half its height [m]; `seed` makes the lumps.
    void blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed, int rows = 5,
              int sides = 9);

    /// The surfaces so far.
    std::vector<SceneSurface> take() { return std::move(surfaces_); }

private:
    SceneSurface& surface(Finish finish);
    std::uint32_t corner(SceneSurface& surface, Vec3 position, Vec3 normal);

    Vec2 pivot_;
    std::vector<SceneSurface> surfaces_;
};

/// The rectangle round an outline whose longest side gives the direction.
struct OutlineBox {
    Vec2 centre;
    Rotation turn;            ///< Of the long side from +x.
    double halfLength = 0.0;  ///< [m]
    double halfWidth = 0.0;   ///< [m]
    /// A point, from the centre along the long side and across it [m].
    Vec2 at(double along, double across) const { return centre + turn.apply({along, across}); }
};
OutlineBox outlineBox(const Polygon& outline);  ///< Of that outline; at least two corners.

/// A number from 0 to 1 that looks thrown, always the same for the same two.
double thrown(std::uint32_t a, std::uint32_t b);

/// A regular polygon about `centre`, counter-clockwise.
Polygon circle(Vec2 centre, double radius, int corners);

/// Adds an obstacle as defined.
void addObstacle(const ObstacleDef& obstacle, SceneMeshBuilder& builder);
/// Adds a patch as defined, played by the clip of that name; `open` where the ground below it is left out,
/// `floor` how high its own lies [m].
void addPatch(const PatchDef& patch, const std::string& clip, bool open, double floor,
              SceneMeshBuilder& builder);

}  // namespace muster
