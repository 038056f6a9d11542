#include "files/export/scene_mesh.h"

#include <algorithm>
#include <cmath>

#include "base/maths.h"
#include "engine/geometry/triangulation.h"

namespace muster {
const FinishLook& finishLook(Finish finish) {
    static constexpr std::array<FinishLook, static_cast<std::size_t>(Finish::Count)> kLooks{{
        {"ground", 0xE6E1D9},
        {"wall", 0xDDD6CA},
        {"roof", 0xEDE8DF},
        {"stone", 0xE4DED2},
        {"trunk", 0x8A6D52},
        {"crown", 0x9DBB8B},
        {"leaves", 0x9DBB8B, 0.6f},
        {"water", 0xA8CFDA, 0.6f, 0.15f},
        {"tile", 0x9CC6D3, 1.0f, 0.4f},
        {"coping", 0xD9D1C2},
        {"net floor", 0xE2D2AB},
        {"net", 0x6A5A36},
        {"brick", 0xD3B899},
        {"floor", 0xD8D2C6},
        {"shade", 0xC9CFB7},
        {"glass", 0x2B3640, 1.0f, 0.2f},
        {"tyre", 0x1B1E22},
        {"paint 1", 0xC4BEB3, 1.0f, 0.4f},
        {"paint 2", 0xB5523F, 1.0f, 0.4f},
        {"paint 3", 0x7F93A8, 1.0f, 0.4f},
        {"paint 4", 0x5F8A7F, 1.0f, 0.4f},
        {"fur", 0xB4B0AC},
        {"exit", 0xCFE3CE},
        {"source", 0xD2DDEA},
        {"waiting area", 0xEADFBE},
    }};
    return kLooks[static_cast<std::size_t>(finish)];
}

Vec3 linearColour(std::uint32_t colour) {
    const auto part = [colour](int shift) {
        const double s = static_cast<double>((colour >> shift) & 255u) / 255.0;
        return toFloat(s <= 0.04045 ? s / 12.92 : power((s + 0.055) / 1.055, 2.4));
    };
    return {part(16), part(8), part(0)};
}

OutlineBox outlineBox(const Polygon& outline) {
    OutlineBox box;
    double longest = 0.0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 side = outline[(i + 1) % outline.size()] - outline[i];
        if (length(side) <= longest + 1e-9) continue;
        longest = length(side);
        box.turn = {side.x / longest, side.y / longest};
    }
    Polygon turned;
    for (const Vec2 p : outline) turned.push_back(box.turn.applyInverse(p));
    const Box bounds = boundsOf(turned);
    box.centre = box.turn.apply((bounds.min + bounds.max) * 0.5);
    box.halfLength = 0.5 * bounds.width();
    box.halfWidth = 0.5 * bounds.height();
    return box;
}

double thrown(std::uint32_t a, std::uint32_t b) {
    std::uint32_t h = a * 0x9e3779b9u + b * 0x85ebca6bu + 0x6b43a9b5u;
    h = (h ^ (h >> 16)) * 0x7feb352du;
    h = (h ^ (h >> 15)) * 0x846ca68bu;
    return static_cast<double>((h ^ (h >> 16)) >> 8) / static_cast<double>(1u << 24);
}

Polygon circle(Vec2 centre, double radius, int corners) {
    Polygon outline;
    for (int i = 0; i < corners; ++i) {
        const double angle = 2.0 * kPi * i / corners;
        outline.push_back(centre + Vec2{radius * cosine(angle), radius * sine(angle)});
    }
    return outline;
}

SceneSurface& SceneMeshBuilder::surface(Finish finish) {
    const auto found = std::find_if(surfaces_.begin(), surfaces_.end(),
                                    [&](const SceneSurface& s) { return s.finish == finish; });
    if (found != surfaces_.end()) return *found;
    surfaces_.emplace_back().finish = finish;
    return surfaces_.back();
}

std::uint32_t SceneMeshBuilder::corner(SceneSurface& surface, Vec3 position, Vec3 normal) {
    surface.positions.push_back(position - pointAt(pivot_, 0.0));
    surface.normals.push_back(normal);
    return static_cast<std::uint32_t>(surface.positions.size() - 1);
}

void SceneMeshBuilder::triangle(Finish finish, Vec3 a, Vec3 b, Vec3 c) {
    const Vec3 across = cross(b - a, c - a);
    if (!(length(across) > 1e-9f)) return;
    SceneSurface& s = surface(finish);
    const Vec3 normal = normalized(across);
    for (const Vec3 p : {a, b, c}) s.indices.push_back(corner(s, p, normal));
}

void SceneMeshBuilder::quad(Finish finish, Vec3 a, Vec3 b, Vec3 c, Vec3 d) {
    const Vec3 across = cross(c - a, d - b);
    if (!(length(across) > 1e-9f)) return;
    SceneSurface& s = surface(finish);
    const Vec3 normal = normalized(across);
    const std::uint32_t first = corner(s, a, normal);
    for (const Vec3 p : {b, c, d}) corner(s, p, normal);
    for (const std::uint32_t k : {0u, 1u, 2u, 0u, 2u, 3u}) s.indices.push_back(first + k);
}

void SceneMeshBuilder::floor(Finish finish, const Polygon& outline, double z) {
    const auto parts = decomposeConvex(outline);
    if (!parts.ok()) return;
    SceneSurface& s = surface(finish);
    for (const Polygon& part : *parts) {
        const auto first = static_cast<std::uint32_t>(s.positions.size());
        for (const Vec2 p : part) corner(s, pointAt(p, z), {0.0f, 0.0f, 1.0f});
        for (std::uint32_t k = 2; k < part.size(); ++k)
            s.indices.insert(s.indices.end(), {first, first + k - 1, first + k});
    }
}

void SceneMeshBuilder::walls(Finish finish, const Polygon& outline, double low, double high, bool inside) {
    for (std::size_t i = 0; i < outline.size(); ++i) {
        Vec2 a = outline[i], b = outline[(i + 1) % outline.size()];
        if (inside) std::swap(a, b);
        quad(finish, pointAt(a, low), pointAt(b, low), pointAt(b, high), pointAt(a, high));
    }
}

void SceneMeshBuilder::level(Finish finish, const PolygonWithHoles&, const TriangleMesh& mesh) {
    const auto at = [&](std::int32_t v) { return pointAt(mesh.vertices[static_cast<std::size_t>(v)], 0.0); };
    for (const Triangle& t : mesh.triangles) triangle(finish, at(t[0]), at(t[1]), at(t[2]));
}

void SceneShapes::prism(Finish side, Finish lid, const Polygon& outline, double low, double high) {
    walls(side, outline, low, high);
    floor(lid, outline, high);
}

void SceneMeshBuilder::frustum(Finish finish, Vec3 base, double height, double lowRadius, double highRadius,
                               int sides) {
    SceneSurface& s = surface(finish);
    const auto first = static_cast<std::uint32_t>(s.positions.size());
    const auto count = static_cast<std::uint32_t>(sides);
    for (int i = 0; i < sides; ++i) {
        const double angle = 2.0 * kPi * i / sides;
        const Vec3 out{toFloat(cosine(angle)), toFloat(sine(angle)), 0.0f};
        const Vec3 normal = normalized(out + Vec3{0.0f, 0.0f, toFloat((lowRadius - highRadius) / height)});
        corner(s, base + out * toFloat(lowRadius), normal);
        corner(s, base + out * toFloat(highRadius) + Vec3{0.0f, 0.0f, toFloat(height)}, normal);
    }
    for (std::uint32_t i = 0; i < count; ++i) {
        const std::uint32_t a = first + 2 * i, b = first + 2 * ((i + 1) % count);
        s.indices.insert(s.indices.end(), {a, b, b + 1, a, b + 1, a + 1});
    }
    floor(finish, circle({base.x, base.y}, highRadius, sides), static_cast<double>(base.z) + height);
}

void SceneMeshBuilder::beam(Finish finish, Vec3 a, Vec3 b, double width) {
    const Vec3 along = normalized(b - a, {1.0f, 0.0f, 0.0f});
    const Vec3 up{0.0f, 0.0f, 1.0f};
    const Vec3 side = normalized(cross(up, along), {0.0f, 1.0f, 0.0f}) * toFloat(0.5 * width);
    const Vec3 rise = normalized(cross(along, side)) * toFloat(0.5 * width);
    const std::array<Vec3, 4> ring{-side - rise, side - rise, side + rise, -side + rise};
    for (std::size_t i = 0; i < 4; ++i) {
        const Vec3 p = ring[i], q = ring[(i + 1) % 4];
        quad(finish, a + q, b + q, b + p, a + p);
    }
    quad(finish, a + ring[3], a + ring[2], a + ring[1], a + ring[0]);
    quad(finish, b + ring[0], b + ring[1], b + ring[2], b + ring[3]);
}

void SceneMeshBuilder::blob(Finish finish, Vec3 centre, double radius, double height, std::uint32_t seed,
                            int rows, int sides) {
    const auto point = [&](int row, int side) {
        const double tilt = kPi * row / rows - 0.5 * kPi;
        const bool pole = row == 0 || row == rows;
        const int s = pole ? 0 : side % sides;
        const double lump = 0.88 + 0.2 * thrown(seed, static_cast<std::uint32_t>(row * 64 + s));
        const double turn = 2.0 * kPi * (s + 0.5 * (row % 2)) / sides;
        const double flat = pole ? 0.0 : cosine(tilt) * radius * lump;
        return centre + Vec3{toFloat(flat * cosine(turn)), toFloat(flat * sine(turn)),
                             toFloat(sine(tilt) * height * lump)};
    };
    for (int row = 0; row < rows; ++row) {
        for (int side = 0; side < sides; ++side) {
            const Vec3 a = point(row, side), b = point(row, side + 1);
            const Vec3 c = point(row + 1, side + 1), d = point(row + 1, side);
            triangle(finish, a, b, c);
            triangle(finish, a, c, d);
        }
    }
}

}  // namespace muster
