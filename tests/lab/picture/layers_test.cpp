// Each layer draws its objects at their positions, and nothing elsewhere.
#include <doctest.h>

#include <algorithm>

#include "engine/formation/mesh/formation_mesh.h"
#include "engine/formation/places/place_tracker.h"
#include "engine/ground/environment/environment.h"
#include "engine/world/inspect.h"
#include "lab/picture/picture.h"
#include "lab/picture/recorder.h"
#include "muster/views.h"

using namespace muster;
using namespace muster::testing;

namespace {

WorldDef sceneDef() {
    WorldDef def{.box = {{-12, -8}, {12, 8}}};
    ObstacleDef wall, tree;
    wall.polygon = {{1, -3}, {2, -3}, {2, 3}, {1, 3}};
    tree.centre = {8, 5};
    tree.radius = 0.5;
    def.obstacles = {wall, tree};
    def.patches = {{.name = "Pool", .polygon = {{4, -7}, {9, -7}, {9, -3}, {4, -3}}, .motion = 4}};
    def.groups = {{.count = 9, .position = {-6, 0}}};
    return def;
}

World sceneWorld(const WorldDef& def = sceneDef()) {
    World world = World::create(def).value();
    for (int i = 0; i < 3; ++i) world.step();
    return world;
}

/// The shapes of a layer, without the lines of the ground.
std::vector<Shape> layerOf(const World& world, std::string_view name, PictureDef def = {}) {
    const Box box = inspect::environment(world).def().box;
    Recorder ground(box), all(box);
    PictureDef bare{.dark = def.dark};
    bare.layers = 1u << 20;  // No layer has this bit.
    drawWorld(ground, world, bare);
    def.layers = *parseLayers(name);
    drawWorld(all, world, def);
    std::vector<Shape> kept;
    for (const Shape& shape : all.shapes) {
        const bool common = std::any_of(ground.shapes.begin(), ground.shapes.end(), [&](const Shape& other) {
            return other.kind == shape.kind && other.loops == shape.loops &&
                   other.stroke.colour == shape.stroke.colour;
        });
        if (!common) kept.push_back(shape);
    }
    REQUIRE(all.shapes.size() - kept.size() == ground.shapes.size());
    return kept;
}

std::size_t countOf(const std::vector<Shape>& shapes, Kind kind) {
    return static_cast<std::size_t>(
        std::count_if(shapes.begin(), shapes.end(), [&](const Shape& s) { return s.kind == kind; }));
}

bool within(const Box& inner, const Box& outer) {
    return outer.contains(inner.min) && outer.contains(inner.max);
}

/// The colour of a raster's sample nearest to a point.
Colour colourAt(const Shape& raster, Vec2 p) {
    const Box box{raster.loops[0][0], raster.loops[0][1]};
    const auto x = static_cast<std::size_t>((p.x - box.min.x) / box.width() * raster.width);
    const auto y = static_cast<std::size_t>((p.y - box.min.y) / box.height() * raster.height);
    return raster.colours.at(y * static_cast<std::size_t>(raster.width) + x);
}

const Shape& rasterOf(const std::vector<Shape>& shapes) {
    const auto found = std::find_if(shapes.begin(), shapes.end(),
                                    [](const Shape& s) { return s.kind == Kind::Raster; });
    REQUIRE(found != shapes.end());
    return *found;
}

}  // namespace

TEST_CASE("obstacles: their shapes, with shadows no longer than a person, and nothing elsewhere") {
    const auto shapes = layerOf(sceneWorld(), "obstacles");
    const Box wall = Box{{1, -3}, {2, 3}}.grown(0.55), tree = Box{{7.5, 4.5}, {8.5, 5.5}}.grown(0.55);
    int walls = 0, trees = 0;
    for (const Shape& shape : shapes) {
        CHECK((within(shape.bounds(), wall) || within(shape.bounds(), tree)));
        if (shape.kind == Kind::Area && shape.loops[0].size() == 4 &&
            within(shape.bounds(), {{1, -3}, {2, 3}}))
            ++walls;
        if (shape.kind == Kind::Disc && shape.loops[0][0] == Vec2{8, 5} && shape.radius == 0.5) ++trees;
    }
    CHECK(walls >= 1);
    CHECK(trees == 1);
    WorldDef none = sceneDef();
    none.obstacles.clear();
    CHECK(layerOf(sceneWorld(none), "obstacles").empty());
}

TEST_CASE("patches: their polygon, their texture and their name") {
    const auto shapes = layerOf(sceneWorld(), "patches");
    bool polygon = false, name = false;
    for (const Shape& shape : shapes) {
        CHECK(within(shape.bounds(), Box{{4, -7}, {9, -3}}.grown(0.3)));
        polygon = polygon || (shape.kind == Kind::Area && within({{4, -7}, {9, -3}}, shape.bounds()) &&
                              shape.fill.opacity > 0);
        name = name || (shape.kind == Kind::Text && shape.words == "Pool");
    }
    CHECK(polygon);
    CHECK(name);
    CHECK(countOf(shapes, Kind::Line) > 5);  // Waves.
}

TEST_CASE("items: filled before they are collected, a ring afterwards") {
    WorldDef def = sceneDef();
    def.patches.clear();
    def.items = {{{6, -5}, 0.4}, {{-6, 0}, 0.5}};  // The second lies in the crowd.
    const World world = sceneWorld(def);
    REQUIRE(world.collected()[0] == 0);
    REQUIRE(world.collected()[1] == 1);
    const auto shapes = layerOf(world, "patches");
    REQUIRE(countOf(shapes, Kind::Disc) == 3);
    for (const Shape& shape : shapes) {
        const bool first = shape.loops[0][0] == Vec2{6, -5};
        CHECK((first || shape.loops[0][0] == Vec2{-6, 0}));
        CHECK((shape.fill.opacity > 0.0) == first);
    }
}

TEST_CASE("characters: a disc at each position, pointing along the heading") {
    const World world = sceneWorld();
    const auto shapes = layerOf(world, "characters");
    const CharactersView c = world.characters();
    for (std::size_t i = 0; i < c.size(); ++i) {
        const bool drawn = std::any_of(shapes.begin(), shapes.end(), [&](const Shape& s) {
            return s.kind == Kind::Disc && s.loops[0][0] == c.position[i] && s.radius == 0.25 &&
                   s.stroke.width > 0;
        });
        CHECK(drawn);
        const bool nose = std::any_of(shapes.begin(), shapes.end(), [&](const Shape& s) {
            return s.kind == Kind::Area &&
                   distance(s.loops[0][0], c.position[i] + c.heading[i] * 0.25 * 0.95) < 1e-9;
        });
        CHECK(nose);
    }
    CHECK(shapes.size() == 3 * c.size());  // Each has a shadow.
    for (const Shape& shape : shapes) CHECK(shape.bounds().max.x < -3);
}

TEST_CASE("a chosen colour is drawn; a swatch has another on dark ground") {
    const auto drawn = [](std::uint32_t chosen, bool dark, std::uint32_t expected) {
        WorldDef def = sceneDef();
        def.groups[0].colour = chosen;
        PictureDef picture{.dark = dark};
        const auto shapes = layerOf(sceneWorld(def), "characters", picture);
        return std::any_of(shapes.begin(), shapes.end(), [&](const Shape& shape) {
            return Colour{shape.fill.red, shape.fill.green, shape.fill.blue, 1.0} == Colour::of(expected);
        });
    };
    CHECK(drawn(0x05536D, false, 0x05536D));
    CHECK(drawn(0x05536D, true, 0x17D7FF));
    CHECK_FALSE(drawn(0x05536D, true, 0x05536D));
    CHECK(drawn(0x123456, true, 0x123456));
}

TEST_CASE("places: a ring each, crossed out where the place is unfit") {
    WorldDef def = sceneDef();
    def.box = {{-2, -2}, {2, 2}};  // Too small for all.
    def.obstacles.clear();
    def.patches.clear();
    def.groups[0].count = 81;
    def.groups[0].position = {0, 0};
    const World world = sceneWorld(def);
    const PlaceTracker& places = inspect::places(world, 0);
    const auto unfit = static_cast<std::size_t>(std::count(places.fit().begin(), places.fit().end(), 0));
    const auto shapes = layerOf(world, "places");
    CHECK(unfit > 0);
    CHECK(countOf(shapes, Kind::Disc) == places.positions().size());
    CHECK(countOf(shapes, Kind::Line) == 2 * unfit);
    for (const Shape& shape : shapes) {
        const bool at = std::any_of(places.positions().begin(), places.positions().end(), [&](Vec2 p) {
            return distance(lerp(shape.bounds().min, shape.bounds().max, 0.5), p) < 1e-9;
        });
        CHECK(at);
    }
}

TEST_CASE("mesh: every edge of every triangle between the vertices' present positions") {
    const World world = sceneWorld();
    const FormationMesh& mesh = inspect::mesh(world, 0);
    const auto shapes = layerOf(world, "mesh");
    std::size_t outlined = 0;
    for (const Shape& shape : shapes) {
        for (const auto& loop : shape.loops) {
            for (const Vec2 p : loop)
                CHECK(std::find(mesh.finalMesh().begin(), mesh.finalMesh().end(), p) !=
                      mesh.finalMesh().end());
        }
        if (shape.kind == Kind::Area && shape.stroke.width > 0) outlined += shape.loops[0].size();
    }
    // Euler's formula: edges = vertices + triangles - 1 for a disc. Border edges are in the outline or drawn
    // as lines.
    const std::size_t vertices = mesh.finalMesh().size(), triangles = mesh.formation().mesh.triangles.size();
    const std::size_t edges = vertices + triangles - 1, lines = countOf(shapes, Kind::Line);
    CHECK(lines <= edges);
    CHECK(lines + outlined >= edges);
}

TEST_CASE("paths: drawn trajectories, and the past paths of characters") {
    World world = sceneWorld();
    PictureDef def;
    CHECK(layerOf(world, "paths", def).empty());
    REQUIRE(
        world.submit({world.stepCount(), 1, 0, Touch{TouchPhase::Down, 1, {-6, 0}, world.time(), {}}}).ok());
    world.step();
    for (std::uint32_t k = 1; k <= 8; ++k) {
        REQUIRE(world
                    .submit({world.stepCount(), 1, k,
                             Touch{TouchPhase::Move, 1, {-6 + 0.5 * k, 0.2 * k}, world.time(), {}}})
                    .ok());
        world.step();
    }
    def.trails = {{{-7, 1}, {-6.5, 1}, {-6, 1.2}}};
    const auto shapes = layerOf(world, "paths", def);
    const auto& point = world.group(0).controls[0].points[0];
    std::vector<Vec2> path{point.position};
    for (const Checkpoint& checkpoint : point.trajectory) path.push_back(checkpoint.position);
    REQUIRE(path.size() > 2);
    int paths = 0, trails = 0;
    for (const Shape& shape : shapes) {
        paths += shape.kind == Kind::Line && shape.loops[0] == path;
        trails += shape.kind == Kind::Line && shape.loops[0] == def.trails[0];
        CHECK(shape.visible());
    }
    CHECK(paths == 2);  // A white outline below, the colour above.
    CHECK(trails == 1);
}

TEST_CASE(
    "potential field: coloured within range of an obstacle, transparent beyond, nothing without obstacles") {
    const auto shapes = layerOf(sceneWorld(), "field");
    const Shape& raster = rasterOf(shapes);
    CHECK(within(raster.bounds(), Box{{-12, -8}, {12, 8}}.grown(0.3)));
    CHECK(colourAt(raster, {0.7, 0}).opacity > 0.3);
    CHECK(colourAt(raster, {2.4, 1}).opacity > 0.3);
    CHECK(colourAt(raster, {8, 4.2}).opacity > 0.3);
    CHECK(colourAt(raster, {-6, 0}).opacity == 0.0);
    CHECK(colourAt(raster, {6, -5}).opacity == 0.0);
    CHECK(colourAt(raster, {0.6, 0}).opacity > colourAt(raster, {-0.2, 0}).opacity - 1e-9);
    WorldDef none = sceneDef();
    none.obstacles.clear();
    CHECK(layerOf(sceneWorld(none), "field").empty());
}

TEST_CASE("cost: darker for longer paths, with contours and the place itself") {
    const World world = sceneWorld();
    PictureDef def{.place = 4};
    const auto shapes = layerOf(world, "cost", def);
    const Vec2 place = world.group(0).placePositions[4];
    const Shape& raster = rasterOf(shapes);
    const auto light = [&](Vec2 p) {
        return colourAt(raster, p).red + colourAt(raster, p).green + colourAt(raster, p).blue;
    };
    CHECK(light(place) > light({-2, 0}));
    CHECK(light({-2, 0}) > light({4, 0}));
    CHECK(light({4, 0}) > light({11, 0}));
    const auto& last = shapes.back();
    CHECK(last.kind == Kind::Disc);
    CHECK(distance(last.loops[0][0], place) < 0.3);
    CHECK(std::any_of(shapes.begin(), shapes.end(),
                      [](const Shape& s) { return s.words == "Cost to place 4"; }));
    CHECK(countOf(shapes, Kind::Line) > 50);
    def.place = 9;  // There are nine places: 0 to 8.
    CHECK(layerOf(world, "cost", def).empty());
    def.place = 0;
    def.group = 1;
    CHECK(layerOf(world, "cost", def).empty());
}

TEST_CASE("density: coloured in the crowd, transparent beyond a cell") {
    const World world = sceneWorld();
    const auto shapes = layerOf(world, "density");
    const Shape& raster = rasterOf(shapes);
    for (const Vec2 p : world.characters().position) CHECK(colourAt(raster, p).opacity > 0.0);
    CHECK(colourAt(raster, {0, 0}).opacity == 0.0);
    CHECK(colourAt(raster, {10, -7}).opacity == 0.0);
}

TEST_CASE("by default all layers except the coloured rasters are drawn, dark or light") {
    const World world = sceneWorld();
    Recorder plain({{-12, -8}, {12, 8}}), dark({{-12, -8}, {12, 8}});
    PictureDef def;
    drawWorld(plain, world, def);
    def.dark = true;
    drawWorld(dark, world, def);
    CHECK(countOf(plain.shapes, Kind::Raster) == 0);
    CHECK(countOf(plain.shapes, Kind::Disc) >= 9 * 3 + 1);
    REQUIRE(dark.shapes.size() == plain.shapes.size());
    int other = 0;
    for (std::size_t i = 0; i < plain.shapes.size(); ++i) {
        CHECK(dark.shapes[i].loops == plain.shapes[i].loops);
        other += !(dark.shapes[i].fill == plain.shapes[i].fill &&
                   dark.shapes[i].stroke.colour == plain.shapes[i].stroke.colour);
    }
    CHECK(other > 20);
}
