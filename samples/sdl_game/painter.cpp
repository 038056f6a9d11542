#include "painter.h"

#include <algorithm>
#include <cmath>

namespace game {
namespace {

constexpr double kFade = 0.6;  // Half the width of an edge [pixels].
constexpr double kPi = 3.141592653589793;

/// How many corners make a circle look round.
int cornersOf(double radius) {
    return std::clamp(static_cast<int>(6.0 + 2.5 * radius), 10, 96);
}

Vec2 direction(double angle) {
    return {std::cos(angle), std::sin(angle)};
}

}  // namespace

int Painter::vertex(Vec2 p, Paint paint, double cover) {
    const auto byte = [](double value) { return static_cast<Uint8>(std::lround(255.0 * value)); };
    SDL_Vertex vertex{};
    vertex.position = {static_cast<float>(p.x), static_cast<float>(p.y)};
    vertex.color = {static_cast<Uint8>(paint.rgb >> 16), static_cast<Uint8>(paint.rgb >> 8),
                    static_cast<Uint8>(paint.rgb), byte(paint.cover * cover)};
    vertices_.push_back(vertex);
    return static_cast<int>(vertices_.size()) - 1;
}

/// The inside of a convex outline, and a rim that fades outwards along the normals.
void Painter::shape(std::span<const Vec2> outline, std::span<const Vec2> normals, Paint paint) {
    const int count = static_cast<int>(outline.size());
    const int first = static_cast<int>(vertices_.size());
    for (int i = 0; i < count; ++i) {
        vertex(outline[i] - kFade * normals[i], paint, 1.0);
        vertex(outline[i] + kFade * normals[i], paint, 0.0);
    }
    for (int i = 0; i < count; ++i) {
        const int in = first + 2 * i, next = first + 2 * ((i + 1) % count);
        if (i > 0 && i + 1 < count) indices_.insert(indices_.end(), {first, in, next});
        indices_.insert(indices_.end(), {in, in + 1, next, next, in + 1, next + 1});
    }
}

void Painter::disc(Vec2 centre, double radius, Paint paint) {
    line(centre, centre, 2.0 * radius, paint);
}

void Painter::line(Vec2 a, Vec2 b, double width, Paint paint) {
    const double radius = 0.5 * width, forward = std::atan2(b.y - a.y, b.x - a.x);
    const int half = cornersOf(radius) / 2;
    std::vector<Vec2> outline, normals;
    for (int end = 0; end < 2; ++end)
        for (int i = 0; i <= half; ++i) {
            normals.push_back(direction(forward + kPi * (end + 0.5 + static_cast<double>(i) / half)));
            outline.push_back((end == 0 ? a : b) + radius * normals.back());
        }
    shape(outline, normals, paint);
}

void Painter::dots(Vec2 a, Vec2 b, double width, double spacing, Paint paint) {
    const int count = static_cast<int>(muster::distance(a, b) / spacing);
    for (int i = 0; i <= count; ++i) disc(a + muster::normalized(b - a) * (i * spacing), 0.5 * width, paint);
}

void Painter::ring(Vec2 centre, double radius, double width, Paint paint) {
    const int count = cornersOf(radius);
    const double radii[] = {radius - 0.5 * width - kFade, radius - 0.5 * width + kFade,
                            radius + 0.5 * width - kFade, radius + 0.5 * width + kFade};
    const int first = static_cast<int>(vertices_.size());
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 4; ++k)
            vertex(centre + radii[k] * direction(2.0 * kPi * i / count), paint, k == 1 || k == 2 ? 1.0 : 0.0);
    for (int i = 0; i < count; ++i)
        for (int k = 0; k < 3; ++k) {
            const int at = first + 4 * i + k, next = first + 4 * ((i + 1) % count) + k;
            indices_.insert(indices_.end(), {at, at + 1, next, next, at + 1, next + 1});
        }
}

void Painter::convex(std::span<const Vec2> corners, Paint paint) {
    // The normal of a corner, as long as both edges then move outwards by the same.
    double area = 0.0;
    for (std::size_t i = 0; i < corners.size(); ++i)
        area += cross(corners[i], corners[(i + 1) % corners.size()]);
    const double side = area > 0.0 ? -1.0 : 1.0;
    std::vector<Vec2> normals;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const Vec2 p = corners[(i + corners.size() - 1) % corners.size()],
                   q = corners[(i + 1) % corners.size()];
        const Vec2 one = side * muster::perpendicular(muster::normalized(corners[i] - p));
        const Vec2 other = side * muster::perpendicular(muster::normalized(q - corners[i]));
        normals.push_back((one + other) / std::max(1.0 + dot(one, other), 0.2));
    }
    shape(corners, normals, paint);
}

void Painter::show() {
    SDL_SetRenderDrawBlendMode(renderer_, SDL_BLENDMODE_BLEND);
    SDL_RenderGeometry(renderer_, nullptr, vertices_.data(), static_cast<int>(vertices_.size()),
                       indices_.data(), static_cast<int>(indices_.size()));
    vertices_.clear();
    indices_.clear();
}

}  // namespace game
