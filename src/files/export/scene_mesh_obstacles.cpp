// Obstacles: buildings, pillars, fountains, trees, hedges and cars, distinguished by their names.
#include <algorithm>
#include <array>
#include <cctype>

#include "files/export/scene_mesh.h"

namespace muster {
namespace {

constexpr double kCarLength[] = {2.8, 7.0};  // Length of moving obstacles that look like cars [m].
constexpr double kCarWidth[] = {1.3, 2.6};
constexpr double kVanHeight = 1.9;

/// True where the name contains one of the words, ignoring case.
template <std::size_t N>
bool named(const std::string& name, const std::array<const char*, N>& words) {
    std::string small = name;
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return std::any_of(words.begin(), words.end(),
                       [&](const char* word) { return small.find(word) != std::string::npos; });
}

constexpr std::array kTreeWords{"tree", "oak", "pine", "birch", "linden", "elm", "maple", "beech"};
constexpr std::array kCarWords{"car", "coupe", "van", "bus", "taxi", "truck", "lorry"};

bool carSized(const Polygon& outline) {
    const OutlineBox box = outlineBox(outline);
    const double length = 2.0 * box.halfLength, width = 2.0 * box.halfWidth;
    return length >= kCarLength[0] && length <= kCarLength[1] && width >= kCarWidth[0] &&
           width <= kCarWidth[1];
}

void addTree(const ObstacleDef& tree, SceneShapes& shapes) {
    // Lower than real trees, as in the studio, so that people under them stay visible.
    const double s = std::clamp(tree.radius / 0.4, 0.65, 1.0);
    // By way of 64 bits: what becomes of a negative number otherwise differs from processor to processor.
    const auto place = [](double metres) {
        return static_cast<std::uint32_t>(static_cast<std::int64_t>(metres * 64.0));
    };
    const auto seed = static_cast<std::uint32_t>(thrown(place(tree.centre.x), place(tree.centre.y)) * 1e6);
    const double trunk = std::min(tree.radius, 0.22 * s);
    shapes.frustum(Finish::Trunk, pointAt(tree.centre, 0.0), 2.2 * s, trunk, 0.65 * trunk, 9);
    const auto crown = [&](double x, double y, double z, double radius, double height, std::uint32_t k) {
        const Vec2 middle = tree.centre + Rotation{0.8, 0.6}.apply({x, y}) * s;
        shapes.blob(Finish::Crown, pointAt(middle, z * s), radius * s, height * s, seed + k, 6, 11);
    };
    crown(0.0, 0.0, 2.95, 1.25, 1.05, 0);
    crown(0.55, 0.4, 2.55, 0.75, 0.6, 1);
    crown(-0.6, -0.25, 2.6, 0.7, 0.6, 2);
}

void addFountain(const ObstacleDef& fountain, SceneShapes& shapes) {
    const Polygon outer = circle(fountain.centre, fountain.radius, 36);
    const Polygon inner = circle(fountain.centre, 0.8 * fountain.radius, 36);
    shapes.walls(Finish::Stone, outer, 0.0, 0.55);
    shapes.walls(Finish::Stone, inner, 0.0, 0.55, true);
    for (std::size_t i = 0; i < outer.size(); ++i) {
        const std::size_t j = (i + 1) % outer.size();
        shapes.quad(Finish::Stone, pointAt(outer[i], 0.55), pointAt(outer[j], 0.55), pointAt(inner[j], 0.55),
                    pointAt(inner[i], 0.55));
    }
    shapes.floor(Finish::Water, inner, 0.42);
    shapes.frustum(Finish::Stone, pointAt(fountain.centre, 0.0), 1.25, 0.24 * fountain.radius,
                   0.17 * fountain.radius, 16);
}

/// Four corners of a car's layer, as shares of its half length and half width.
Polygon slab(const OutlineBox& box, double back, double front, double side) {
    const double l = box.halfLength, w = box.halfWidth * side;
    return {box.at(back * l, -w), box.at(front * l, -w), box.at(front * l, w), box.at(back * l, w)};
}

/// Adds sloping sides between two outlines with the same number of corners.
void addSkirt(SceneShapes& shapes, Finish finish, const Polygon& low, const Polygon& top, double from,
              double to) {
    for (std::size_t i = 0; i < low.size(); ++i) {
        const std::size_t j = (i + 1) % low.size();
        shapes.quad(finish, pointAt(low[i], from), pointAt(low[j], from), pointAt(top[j], to),
                    pointAt(top[i], to));
    }
}

void addCar(const ObstacleDef& car, SceneShapes& shapes) {
    const OutlineBox box = outlineBox(car.polygon);
    const auto paint = static_cast<Finish>(static_cast<int>(Finish::Paint1) +
                                           static_cast<int>(car.name.size() + car.polygon.size()) % 4);
    const double high = std::clamp(car.height, 1.3, 3.2);
    const bool van = high > kVanHeight;
    const double sill = (van ? 0.5 : 0.56) * high, pane = van ? sill + 0.55 * (high - sill) : high;
    for (const double u : {-0.62, 0.62}) {
        const Polygon wheels = slab(box, u - 0.15, u + 0.15, 1.0);
        shapes.prism(Finish::Tyre, Finish::Tyre, wheels, 0.0, 0.6);
    }
    shapes.prism(paint, paint, slab(box, -1.0, 1.0, 0.94), 0.22, sill);
    const Polygon low = van ? slab(box, -1.0, 0.94, 0.9) : slab(box, -0.72, 0.45, 0.9);
    const Polygon top = van ? slab(box, -0.99, 0.8, 0.78) : slab(box, -0.55, 0.2, 0.78);
    Polygon between = low;
    for (std::size_t i = 0; i < low.size(); ++i)
        between[i] = lerp(low[i], top[i], (pane - sill) / (high - sill));
    addSkirt(shapes, Finish::Glass, low, between, sill, pane);
    if (van) addSkirt(shapes, paint, between, top, pane, high);
    shapes.floor(paint, top, high);
}

}  // namespace

void addObstacle(const ObstacleDef& obstacle, SceneShapes& shapes) {
    if (obstacle.polygon.empty()) {
        if (named(obstacle.name, kTreeWords)) return addTree(obstacle, shapes);
        if (named(obstacle.name, std::array{"fountain"})) return addFountain(obstacle, shapes);
        const Polygon outline = circle(obstacle.centre, obstacle.radius, 28);
        return shapes.prism(Finish::Stone, Finish::Stone, outline, 0.0, obstacle.height);
    }
    const auto outline = cleanPolygon(obstacle.polygon);
    if (!outline.ok()) return;
    const bool moves = !obstacle.path.still();
    if (carSized(*outline) && (moves || named(obstacle.name, kCarWords))) return addCar(obstacle, shapes);
    if (named(obstacle.name, std::array{"hedge"}))
        return shapes.prism(Finish::Crown, Finish::Crown, *outline, 0.0, obstacle.height);
    shapes.prism(Finish::Wall, Finish::Roof, *outline, 0.0, obstacle.height);
}

}  // namespace muster
