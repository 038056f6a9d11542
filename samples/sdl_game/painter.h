// Smooth shapes as triangles: their edges fade over a pixel. Everything is in pixels.
#pragma once

#include <SDL.h>
#include <muster/vec2.h>

#include <cstdint>
#include <span>
#include <vector>

namespace game {

using muster::Vec2;

/// A colour, 0xRRGGBB, and how much it covers.
struct Paint {
    std::uint32_t rgb = 0;
    double cover = 1.0;
};

/// Collects shapes in the order in which they cover each other; show() draws them.
class Painter {
public:
    explicit Painter(SDL_Renderer* renderer) : renderer_(renderer) {}

    void disc(Vec2 centre, double radius, Paint paint);
    void ring(Vec2 centre, double radius, double width, Paint paint);
    /// A line with round ends.
    void line(Vec2 a, Vec2 b, double width, Paint paint);
    /// A line of dots.
    void dots(Vec2 a, Vec2 b, double width, double spacing, Paint paint);
    /// A convex polygon.
    void convex(std::span<const Vec2> corners, Paint paint);
    void show();

private:
    int vertex(Vec2 p, Paint paint, double cover);
    void shape(std::span<const Vec2> outline, std::span<const Vec2> normals, Paint paint);

    SDL_Renderer* renderer_;
    std::vector<SDL_Vertex> vertices_;
    std::vector<int> indices_;
};

}  // namespace game
