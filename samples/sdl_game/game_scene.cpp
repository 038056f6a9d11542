#include "game_scene.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace game {
namespace {

constexpr std::uint32_t kGrass = 0xb9c99a, kGrid = 0xafc08e, kShade = 0x1f2937;
constexpr std::uint32_t kRoof = 0xb7694b, kRoofDark = 0x9a543a, kRidge = 0xcf8a6c, kCrown = 0x4f7f45;
constexpr std::uint32_t kCrownLight = 0x66985a, kStone = 0x7d8491, kPaved = 0xa3aab6, kHead = 0xf6e3cd;
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
        s.painter.line(s.at({x, -height}), s.at({x, height}), s.px(0.06), {kGrid});
    for (double y = -13.0; y < height; y += 4.0)
        s.painter.line(s.at({-width, y}), s.at({width, y}), s.px(0.06), {kGrid});
}

/// A tree, or the foot of the tower.
void drawDisc(const Scene& s, Vec2 centre, double radius, Vec2 shade) {
    const bool tower = centre == kTower;
    s.painter.disc(s.at(centre) + shade, s.px(radius), {kShade, 0.3});
    s.painter.disc(s.at(centre), s.px(radius), {tower ? kStone : kCrown});
    if (tower)
        s.painter.disc(s.at(centre), s.px(radius - 0.2), {kPaved});
    else
        s.painter.disc(s.at(centre) - 0.6 * shade, s.px(0.68 * radius), {kCrownLight});
}

/// A house with a ridge along its middle.
void drawHouse(const Scene& s, const muster::Polygon& walls, Vec2 shade) {
    const Vec2 a = s.at(walls[0]), b = s.at(walls[1]), c = s.at(walls[2]), d = s.at(walls[3]);
    const Vec2 left = 0.5 * (a + d), right = 0.5 * (b + c);
    const std::array<Vec2, 4> shadow{a + shade, b + shade, c + shade, d + shade};
    s.painter.convex(shadow, {kShade, 0.3});
    s.painter.convex(std::array<Vec2, 4>{a, b, c, d}, {kRoof});
    s.painter.convex(std::array<Vec2, 4>{a, b, right, left}, {kRoofDark});
    s.painter.line(left, right, s.px(0.14), {kRidge});
}

void drawObstacle(const Scene& s, const muster::ObstacleDef& def) {
    const Vec2 shade{s.px(0.2), s.px(0.25)};
    if (def.polygon.empty())
        drawDisc(s, def.centre, def.radius, shade);
    else
        drawHouse(s, def.polygon, shade);
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
        const Paint paint{kShade, 0.8 * std::clamp(left, 0.0, 1.0)};
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
        Vec2 from = group.pose.position;
        for (const Vec2 corner : group.way) {
            s.painter.dots(s.at(from), s.at(corner), s.px(0.16), s.px(0.55), paint);
            from = corner;
        }
        if (!group.way.empty()) s.painter.ring(s.at(group.way.back()), s.px(0.5), s.px(0.12), paint);
        for (const Vec2 place : group.placeTargets)
            s.painter.ring(s.at(place), s.px(0.24), s.px(0.06), {colourOf(group.id.value), 0.45});
    }
}

void drawUnit(const Scene& s, const UnitPose& unit, bool selected) {
    const Vec2 p = s.at(unit.position), forward{unit.heading.x, -unit.heading.y};
    const Vec2 side = muster::perpendicular(forward);
    const std::uint32_t colour = colourOf(unit.group);
    s.painter.disc(p + Vec2{s.px(0.08), s.px(0.1)}, s.px(0.34), {kShade, 0.25});
    if (selected) s.painter.ring(p, s.px(0.45), s.px(0.1), {kSelect});
    // A spear ahead, shoulders, the head on top.
    const Vec2 hand = p + s.px(0.24) * side;
    s.painter.line(hand, hand + s.px(0.6) * forward, s.px(0.07), {kShade});
    s.painter.line(p - s.px(0.19) * side, p + s.px(0.19) * side, s.px(0.4), {kShade, 0.85});
    s.painter.line(p - s.px(0.19) * side, p + s.px(0.19) * side, s.px(0.3), {colour});
    s.painter.disc(p + s.px(0.03) * forward, s.px(0.15), {kHead});
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
        for (std::size_t i = 0; i < 4; ++i)
            s.painter.line(corners[i], corners[(i + 1) % 4], s.px(0.08), {kSelect});
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
