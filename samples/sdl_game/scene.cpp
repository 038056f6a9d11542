#include "scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace game {
namespace {

constexpr std::uint32_t kGrass = 0xdfe6cf, kGrid = 0xcfd8bb, kStone = 0x8b93a1, kRoof = 0xa3aab6,
                        kShade = 0x2b3342;
constexpr std::uint32_t kSelect = 0xffffff, kFront = 0x1f2937, kFire = 0xdc2626, kTowerTop = 0x7f1d1d;
constexpr auto kGroups = std::to_array<std::uint32_t>(
    {0x2563eb, 0xe2711d, 0x7c3aed, 0x0f9d76, 0xc02675, 0x0e7fa8});
constexpr double kShotSeconds = 0.25;

std::uint32_t colourOf(std::uint32_t group) {
    return kGroups[(group - 1) % kGroups.size()];
}

/// What all drawing functions need.
struct Scene {
    Painter& painter;
    const Camera& camera;
    const Battle& battle;
    const Mouse& mouse;

    Vec2 at(Vec2 p) const { return camera.toWindow(p); }
    double px(double metres) const { return metres * camera.scale(); }
};

void drawGround(const Scene& s) {
    const double width = 24.0, height = 15.0;
    const std::array<Vec2, 4> field{s.at({-width, -height}), s.at({width, -height}), s.at({width, height}),
                                    s.at({-width, height})};
    s.painter.convex(field, {kGrass});
    for (double x = -22.0; x < width; x += 4.0)
        s.painter.line(s.at({x, -height}), s.at({x, height}), 1.0, {kGrid});
    for (double y = -13.0; y < height; y += 4.0)
        s.painter.line(s.at({-width, y}), s.at({width, y}), 1.0, {kGrid});
}

void drawObstacle(const Scene& s, const muster::ObstacleDef& def) {
    const Vec2 shade = Vec2{s.px(0.18), s.px(0.22)};
    if (def.polygon.empty()) {
        s.painter.disc(s.at(def.centre) + shade, s.px(def.radius), {kShade, 0.25});
        s.painter.disc(s.at(def.centre), s.px(def.radius), {kStone});
        s.painter.disc(s.at(def.centre), s.px(def.radius - 0.18), {kRoof});
        return;
    }
    Vec2 middle;
    for (const Vec2 p : def.polygon) middle += p / static_cast<double>(def.polygon.size());
    std::vector<Vec2> shadow, wall, roof;
    for (const Vec2 p : def.polygon) {
        wall.push_back(s.at(p));
        shadow.push_back(wall.back() + shade);
        const Vec2 inward = middle - p;
        roof.push_back(s.at(p + 0.18 * Vec2{std::copysign(1.0, inward.x), std::copysign(1.0, inward.y)}));
    }
    s.painter.convex(shadow, {kShade, 0.25});
    s.painter.convex(wall, {kStone});
    s.painter.convex(roof, {kRoof});
}

void drawTower(const Scene& s) {
    for (int k = 0; k < 72; ++k) {
        const double angle = k * 3.141592653589793 / 36.0;
        s.painter.disc(s.at(kTower + kTowerReach * Vec2{std::cos(angle), std::sin(angle)}), 1.2,
                       {kFire, 0.5});
    }
    s.painter.disc(s.at(kTower), s.px(0.7), {kTowerTop});
    s.painter.disc(s.at(kTower), s.px(0.3), {kFire});
    const auto shot = s.battle.lastShot();
    const double age = shot ? s.battle.world().time() - shot->time : kShotSeconds;
    if (age >= kShotSeconds) return;
    const double left = 1.0 - age / kShotSeconds;
    s.painter.line(s.at(kTower), s.at(shot->position), s.px(0.10), {kFire, left});
    s.painter.ring(s.at(shot->position), s.px(0.3 + 0.6 * (1.0 - left)), s.px(0.1), {kFire, left});
}

void drawFallen(const Scene& s) {
    for (const Fallen& fallen : s.battle.fallen()) {
        const double left = 1.0 - (s.battle.world().time() - fallen.time) / kFallenSeconds;
        const Vec2 p = s.at(fallen.position);
        const double r = s.px(0.2);
        const Paint paint{kShade, 0.55 * std::clamp(left, 0.0, 1.0)};
        s.painter.line(p - Vec2{r, r}, p + Vec2{r, r}, s.px(0.09), paint);
        s.painter.line(p - Vec2{r, -r}, p + Vec2{r, -r}, s.px(0.09), paint);
    }
}

/// Ways that are still ahead, and the places in the formation.
void drawOrders(const Scene& s) {
    const muster::World& world = s.battle.world();
    for (std::size_t g = 0; g < world.groupCount(); ++g) {
        const muster::GroupView group = world.group(g);
        const Paint paint{colourOf(group.id.value), 0.75};
        for (std::size_t i = 1; i < group.way.size(); ++i)
            s.painter.dots(s.at(group.way[i - 1]), s.at(group.way[i]), s.px(0.16), s.px(0.55), paint);
        if (!group.way.empty()) s.painter.ring(s.at(group.way.back()), s.px(0.5), s.px(0.12), paint);
        for (const Vec2 place : group.placeTargets)
            s.painter.ring(s.at(place), s.px(0.24), 1.2, {colourOf(group.id.value), 0.45});
    }
}

void drawUnit(const Scene& s, const UnitPose& unit, bool selected) {
    const Vec2 p = s.at(unit.position), forward{unit.heading.x, -unit.heading.y};
    const Vec2 side = muster::perpendicular(forward);
    const std::uint32_t colour = colourOf(unit.group);
    s.painter.disc(p + Vec2{s.px(0.06), s.px(0.08)}, s.px(0.29), {kShade, 0.25});
    if (selected) s.painter.ring(p, s.px(0.38), s.px(0.08), {kSelect});
    // Shoulders, a spear ahead, the head on top.
    s.painter.line(p + s.px(0.2) * side, p + s.px(0.2) * side + s.px(0.5) * forward, s.px(0.06), {kShade});
    s.painter.line(p - s.px(0.17) * side, p + s.px(0.17) * side, s.px(0.3), {kShade, 0.8});
    s.painter.line(p - s.px(0.17) * side, p + s.px(0.17) * side, s.px(0.22), {colour});
    s.painter.disc(p + s.px(0.03) * forward, s.px(0.13), {0xf6e3cd});
}

void drawStrokes(const Scene& s) {
    if (const auto front = s.mouse.front()) {
        const Vec2 a = s.at(front->from), b = s.at(front->to);
        s.painter.line(a, b, s.px(0.14), {kFront, 0.9});
        s.painter.disc(a, s.px(0.22), {kFront});
        s.painter.disc(b, s.px(0.22), {kFront});
        // The way that they will face: to the left of the stroke, as it is seen.
        const Vec2 middle = 0.5 * (a + b), ahead = muster::perpendicular(muster::normalized(a - b));
        s.painter.line(middle, middle + s.px(1.2) * ahead, s.px(0.14), {kFront, 0.9});
        for (const double turn : {-0.5, 0.5})
            s.painter.line(middle + s.px(1.2) * ahead,
                           middle + s.px(0.75) * ahead + turn * s.px(0.8) * muster::normalized(b - a),
                           s.px(0.14), {kFront, 0.9});
    }
    if (const auto box = s.mouse.box()) {
        const std::array<Vec2, 4> corners{s.at(box->from), s.at({box->to.x, box->from.y}), s.at(box->to),
                                          s.at({box->from.x, box->to.y})};
        s.painter.convex(corners, {kSelect, 0.25});
        for (std::size_t i = 0; i < 4; ++i) s.painter.line(corners[i], corners[(i + 1) % 4], 1.5, {kSelect});
    }
}

}  // namespace

void drawScene(Painter& painter, const Camera& camera, const Battle& battle, const Mouse& mouse,
               double share) {
    const Scene scene{painter, camera, battle, mouse};
    drawGround(scene);
    drawFallen(scene);
    drawOrders(scene);
    for (const muster::ObstacleId id : battle.world().obstacleIds())
        drawObstacle(scene, battle.world().obstacle(id).def);
    for (const UnitPose& unit : battle.poses(share))
        drawUnit(scene, unit, mouse.selected().contains(unit.id));
    drawTower(scene);
    drawStrokes(scene);
    painter.show();
}

}  // namespace game
