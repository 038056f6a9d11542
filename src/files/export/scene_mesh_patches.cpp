// The look of patches by their clip: a net, a pool, a wall, a hurdle, branches.
#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>

#include "base/maths.h"
#include "files/export/scene_mesh.h"

namespace muster {
namespace {

constexpr double kWallHeight = 1.3;   // The height that the clips expect [m].
constexpr double kWallHalf = 0.2;     // Half of the wall's thickness [m].
constexpr double kCap = 0.08;         // Height of the wall's cap [m].
constexpr double kHurdle = 0.5;       // Height of the hurdle [m].
constexpr double kNet = 0.82;         // Height of the net's posts [m].
constexpr double kSag = 0.11;         // Sag of the net between the posts [m].
constexpr double kMesh = 0.45;        // Distance between the net's threads [m].
constexpr double kWaterLevel = -0.1;  // Height of the water [m].
constexpr double kBottom = -1.15;     // Height of the pool's bottom [m].
constexpr double kCoping = 0.34;      // Width of the pool's rim [m].
constexpr double kLeavesFrom = 1.3;   // Lowest leaves; ducking characters stay below [m].

/// Points along an outline, no farther apart than `spacing`, corners included.
Polygon along(const Polygon& outline, double spacing) {
    Polygon points;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        const int count = std::max(1, static_cast<int>(std::ceil(distance(a, b) / spacing - 1e-9)));
        for (int k = 0; k < count; ++k) points.push_back(lerp(a, b, static_cast<double>(k) / count));
    }
    return points;
}

/// Adds a thread that sags between two points, where it is inside the outline.
void addThread(const Polygon& outline, Vec2 from, Vec2 to, SceneShapes& shapes) {
    constexpr int kPieces = 10;
    const auto height = [&](double t) { return kNet - 4.0 * kSag * t * (1.0 - t); };
    for (int k = 0; k < kPieces; ++k) {
        const double s = static_cast<double>(k) / kPieces, t = static_cast<double>(k + 1) / kPieces;
        if (!containsPoint(outline, lerp(from, to, 0.5 * (s + t)))) continue;
        shapes.beam(Finish::Net, pointAt(lerp(from, to, s), height(s)), pointAt(lerp(from, to, t), height(t)),
                    0.014);
    }
}

void addNet(const Polygon& outline, double floor, SceneShapes& shapes) {
    shapes.floor(Finish::NetFloor, outline, floor);
    const Polygon posts = along(outline, 1.9);
    for (std::size_t i = 0; i < posts.size(); ++i) {
        shapes.frustum(Finish::Net, pointAt(posts[i], 0.0), kNet + 0.05, 0.05, 0.042, 8);
        shapes.beam(Finish::Net, pointAt(posts[i], kNet), pointAt(posts[(i + 1) % posts.size()], kNet),
                    0.025);
    }
    const OutlineBox box = outlineBox(outline);
    const auto threads = [](double half) { return std::max(2, static_cast<int>(2.0 * half / kMesh)); };
    const int across = threads(box.halfLength), lengthwise = threads(box.halfWidth);
    for (int i = 1; i < across; ++i) {
        const double u = box.halfLength * (2.0 * i / across - 1.0);
        addThread(outline, box.at(u, -box.halfWidth), box.at(u, box.halfWidth), shapes);
    }
    for (int i = 1; i < lengthwise; ++i) {
        const double v = box.halfWidth * (2.0 * i / lengthwise - 1.0);
        // Long threads lie on the cross threads, at the height to which those sag.
        const double t = static_cast<double>(i) / lengthwise;
        const double deep = kNet - 4.0 * kSag * t * (1.0 - t);
        shapes.beam(Finish::Net, pointAt(box.at(-box.halfLength, v), deep),
                    pointAt(box.at(box.halfLength, v), deep), 0.014);
    }
}

/// The outline moved outwards by `width` on every side.
Polygon widened(const Polygon& outline, double width) {
    Polygon wide;
    const std::size_t n = outline.size();
    for (std::size_t i = 0; i < n; ++i) {
        const Vec2 before = normalized(outline[i] - outline[(i + n - 1) % n]);
        const Vec2 after = normalized(outline[(i + 1) % n] - outline[i]);
        const Vec2 out{before.y + after.y, -before.x - after.x};
        wide.push_back(outline[i] + out * (width / std::max(0.3, 1.0 + dot(before, after))));
    }
    return wide;
}

void addPool(const Polygon& outline, bool open, double floor, SceneShapes& shapes) {
    const double rim = 0.022;
    if (open) {
        shapes.floor(Finish::Tile, outline, kBottom);
        shapes.walls(Finish::Tile, outline, kBottom, rim, true);
        shapes.floor(Finish::Water, outline, kWaterLevel);
    } else {
        shapes.floor(Finish::Water, outline, floor);
    }
    const Polygon outer = widened(outline, kCoping);
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const std::size_t j = (i + 1) % outline.size();
        shapes.quad(Finish::Coping, pointAt(outer[i], rim), pointAt(outer[j], rim), pointAt(outline[j], rim),
                    pointAt(outline[i], rim));
    }
    shapes.walls(Finish::Coping, outer, 0.0, rim);
}

void addWall(const Polygon& outline, double floor, SceneShapes& shapes) {
    shapes.floor(Finish::Floor, outline, floor);
    const OutlineBox box = outlineBox(outline);
    const double reach = std::max(0.2, box.halfLength - 0.04);
    const double half = std::min(kWallHalf, 0.5 * box.halfWidth);
    const auto slab = [&](double u, double v) {
        return Polygon{box.at(-u, -v), box.at(u, -v), box.at(u, v), box.at(-u, v)};
    };
    const double body = kWallHeight - kCap;
    shapes.prism(Finish::Brick, Finish::Brick, slab(reach - 0.01, half - 0.008), 0.0, body);
    shapes.prism(Finish::Coping, Finish::Coping, slab(reach, half), body, kWallHeight);
}

void addHedge(const OutlineBox& box, SceneShapes& shapes) {
    const int bushes = std::max(2, static_cast<int>(std::lround(2.0 * box.halfLength / 0.36)));
    for (int i = 0; i < bushes; ++i) {
        const auto k = static_cast<std::uint32_t>(i);
        const double u = box.halfLength * ((2.0 * i + 1.0) / bushes - 1.0);
        const double high = kHurdle * (0.94 + 0.06 * thrown(k, 1));
        const Vec2 middle = box.at(u, 0.03 * (thrown(k, 3) - 0.5));
        shapes.blob(Finish::Crown, pointAt(middle, 0.5 * high), 0.22, 0.5 * high, k, 5, 8);
    }
}

void addHurdle(const OutlineBox& box, SceneShapes& shapes) {
    const double reach = 0.96 * box.halfLength;
    const int spans = std::max(1, static_cast<int>(std::lround(2.0 * reach / 1.8)));
    const auto post = [&](int i) { return box.at(reach * (2.0 * i / spans - 1.0), 0.0); };
    for (int i = 0; i <= spans; ++i) {
        const Vec2 p = post(i), side = box.turn.apply({0.0, 0.3});
        shapes.frustum(Finish::Trunk, pointAt(p, 0.0), kHurdle, 0.04, 0.035, 8);
        shapes.beam(Finish::Trunk, pointAt(p - side, 0.02), pointAt(p + side, 0.02), 0.04);
        if (i == spans) break;
        const Finish paint = i % 2 == 0 ? Finish::Paint2 : Finish::Coping;
        shapes.beam(paint, pointAt(p, kHurdle - 0.045), pointAt(post(i + 1), kHurdle - 0.045), 0.08);
        shapes.beam(Finish::Trunk, pointAt(p, 0.2), pointAt(post(i + 1), 0.2), 0.04);
    }
}

bool named(const std::string& name, const char* word) {
    std::string small = name;
    std::transform(small.begin(), small.end(), small.begin(),
                   [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return small.find(word) != std::string::npos;
}

void addBeast(const OutlineBox& box, SceneShapes& shapes) {
    const double size = 0.62 * std::min(box.halfLength, box.halfWidth);
    const auto ball = [&](double x, double y, double z, double radius, double height) {
        shapes.blob(Finish::Fur, pointAt(box.at(x * size, y * size), z * size), radius * size, height * size,
                    7, 7, 12);
    };
    ball(-0.2, 0.0, 0.38, 0.52, 0.38);
    ball(0.42, 0.0, 0.33, 0.32, 0.27);
    for (const double side : {-1.0, 1.0}) ball(0.3, 0.26 * side, 0.6, 0.17, 0.19);
}

void addJump(const PatchDef& patch, const Polygon& outline, double floor, SceneShapes& shapes) {
    const OutlineBox box = outlineBox(outline);
    if (named(patch.name, "mouse") || named(patch.name, "mice")) return addBeast(box, shapes);
    shapes.floor(Finish::Floor, outline, floor);
    const bool hedge = named(patch.name, "hedge") || named(patch.name, "bush");
    hedge ? addHedge(box, shapes) : addHurdle(box, shapes);
}

void addBranches(const Polygon& outline, double floor, SceneShapes& shapes) {
    shapes.floor(Finish::Shade, outline, floor);
    const OutlineBox box = outlineBox(outline);
    const int count = std::max(4, static_cast<int>(5.0 * box.halfLength * box.halfWidth));
    for (int i = 0; i < count; ++i) {
        const auto k = static_cast<std::uint32_t>(i);
        // A sunflower spiral (golden angle), so that no two tufts coincide.
        const double far = 0.94 * std::sqrt((i + 0.5) / count);
        const double turn = 2.39996 * i;
        const Vec2 p = box.at(far * cosine(turn) * box.halfLength, far * sine(turn) * box.halfWidth);
        const double radius = 0.26 + 0.2 * thrown(k, 1);
        const double low = kLeavesFrom + 0.3 * thrown(k, 2) + 0.25 * (1.0 - far);
        shapes.blob(Finish::Leaves, pointAt(p, low + 0.6 * radius), radius, 0.6 * radius, k, 3, 6);
        if (i % 3 == 0)
            shapes.beam(Finish::Trunk, pointAt(lerp(box.centre, p, 0.2), 2.2), pointAt(p, low + 0.6 * radius),
                        0.03);
    }
}

}  // namespace

void addPatch(const PatchDef& patch, const std::string& clip, bool open, double floor, SceneShapes& shapes) {
    const auto outline = cleanPolygon(patch.polygon);
    if (!outline.ok()) return;
    if (clip == "crawl") return addNet(*outline, floor, shapes);
    if (clip == "swim") return addPool(*outline, open, floor, shapes);
    if (clip == "climb") return addWall(*outline, floor, shapes);
    if (clip == "jump") return addJump(patch, *outline, floor, shapes);
    if (clip == "duck") return addBranches(*outline, floor, shapes);
    shapes.floor(Finish::Floor, *outline, floor);
}

}  // namespace muster
