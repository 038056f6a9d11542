// A drawing that records the shapes drawn into it.
#pragma once

#include <algorithm>
#include <string>
#include <vector>

#include "lab/picture/debug_draw.h"

namespace muster::testing {

enum class Kind { Area, Line, Disc, Raster, Text };

/// A recorded shape.
struct Shape {
    Kind kind;
    std::vector<std::vector<Vec2>> loops;  ///< A line, a centre and the corners of a raster are one loop.
    double radius = 0.0;
    Colour fill;
    Stroke stroke;
    std::string words;
    std::int32_t width = 0, height = 0;
    std::vector<Colour> colours;

    Box bounds() const {
        Box box{{1e9, 1e9}, {-1e9, -1e9}};
        for (const auto& loop : loops) {
            for (const Vec2 p : loop) {
                box.min = {std::min(box.min.x, p.x), std::min(box.min.y, p.y)};
                box.max = {std::max(box.max.x, p.x), std::max(box.max.y, p.y)};
            }
        }
        return box.grown(radius);
    }
    bool visible() const { return fill.opacity > 0 || (stroke.width > 0 && stroke.colour.opacity > 0); }
};

/// Records all shapes.
class Recorder final : public DebugDraw {
public:
    explicit Recorder(Box view) : view_(view) {}
    void area(std::span<const std::vector<Vec2>> loops, Colour fill, const Stroke& stroke) override {
        shapes.push_back({Kind::Area, {loops.begin(), loops.end()}, 0, fill, stroke, {}, 0, 0, {}});
    }
    void line(std::span<const Vec2> points, const Stroke& stroke) override {
        shapes.push_back({Kind::Line, {{points.begin(), points.end()}}, 0, {}, stroke, {}, 0, 0, {}});
    }
    void disc(Vec2 centre, double radius, Colour fill, const Stroke& stroke) override {
        shapes.push_back({Kind::Disc, {{centre}}, radius, fill, stroke, {}, 0, 0, {}});
    }
    void raster(const Box& box, std::int32_t width, std::int32_t height,
                std::span<const Colour> colours) override {
        shapes.push_back({Kind::Raster,
                          {{box.min, box.max}},
                          0,
                          {},
                          {},
                          {},
                          width,
                          height,
                          {colours.begin(), colours.end()}});
    }
    void text(Vec2 at, std::string_view words, double, Colour colour, TextAnchor) override {
        shapes.push_back({Kind::Text, {{at}}, 0, colour, {}, std::string(words), 0, 0, {}});
    }
    double pixel() const override { return view_.width() / 1280.0; }
    Box view() const override { return view_; }
    std::string document() const override { return {}; }

    std::vector<Shape> shapes;

private:
    Box view_;
};

}  // namespace muster::testing
