#include <algorithm>
#include <cmath>

#include "lab/picture/canvas.h"
#include "lab/picture/debug_draw.h"

namespace muster {
namespace {

/// Maps the world to pixels and passes shapes to a canvas.
class PngDraw final : public DebugDraw {
public:
    PngDraw(const Box& view, std::int32_t width, Colour ground)
        : view_(view),
          scale_(width / view.width()),
          canvas_(width, std::max(1, static_cast<std::int32_t>(std::lround(view.height() * scale_))),
                  ground) {}

    void area(std::span<const std::vector<Vec2>> loops, Colour fill, const Stroke& stroke) override {
        std::vector<std::vector<Vec2>> pixels;
        for (const auto& loop : loops) pixels.push_back(toPixels(loop));
        canvas_.fill(pixels, fill);
        std::vector<std::vector<Vec2>> pen;
        for (const auto& loop : pixels) strokeLoops(loop, true, stroke.width, stroke.dash, pen);
        fillUnion(pen, stroke.colour);
    }
    void line(std::span<const Vec2> points, const Stroke& stroke) override {
        std::vector<std::vector<Vec2>> pen;
        strokeLoops(toPixels(points), false, stroke.width, stroke.dash, pen);
        fillUnion(pen, stroke.colour);
    }
    void disc(Vec2 centre, double radius, Colour fill, const Stroke& stroke) override {
        const std::vector<std::vector<Vec2>> loop{discLoop(toPixel(centre), radius * scale_)};
        canvas_.fill(loop, fill);
        std::vector<std::vector<Vec2>> pen;
        strokeLoops(loop[0], true, stroke.width, stroke.dash, pen);
        fillUnion(pen, stroke.colour);
    }
    void raster(const Box& box, std::int32_t width, std::int32_t height,
                std::span<const Colour> colours) override {
        const Vec2 a = toPixel({box.min.x, box.max.y}), b = toPixel({box.max.x, box.min.y});
        const auto x0 = static_cast<std::int32_t>(std::max(0.0, a.x)),
                   y0 = static_cast<std::int32_t>(std::max(0.0, a.y));
        for (std::int32_t y = y0; y < std::min<double>(canvas_.height(), b.y); ++y) {
            for (std::int32_t x = x0; x < std::min<double>(canvas_.width(), b.x); ++x) {
                const double u = (x + 0.5 - a.x) / (b.x - a.x) * width - 0.5;
                const double v = (b.y - y - 0.5) / (b.y - a.y) * height - 0.5;
                canvas_.blend(x, y, sampleRaster(width, height, colours, u, v), 1.0);
            }
        }
    }
    void text(Vec2 at, std::string_view words, double size, Colour colour, TextAnchor anchor) override {
        std::vector<std::vector<Vec2>> loops;
        const double width = letterLoops(words, size, loops);
        const double share = anchor == TextAnchor::Left ? 0.0 : (anchor == TextAnchor::Centre ? 0.5 : 1.0);
        const Vec2 origin = toPixel(at) - Vec2{width * share, 0.0};
        for (auto& loop : loops) {
            for (Vec2& p : loop) p += origin;
        }
        canvas_.fill(loops, colour);
    }
    double pixel() const override { return 1.0 / scale_; }
    Box view() const override { return view_; }
    std::string document() const override {
        const auto png = encodePng(canvas_.width(), canvas_.height(), 3, canvas_.bytes());
        return {png.begin(), png.end()};
    }

private:
    Vec2 toPixel(Vec2 p) const { return {(p.x - view_.min.x) * scale_, (view_.max.y - p.y) * scale_}; }
    std::vector<Vec2> toPixels(std::span<const Vec2> points) const {
        std::vector<Vec2> pixels;
        for (Vec2 p : points) pixels.push_back(toPixel(p));
        return pixels;
    }
    /// Gives all loops the same orientation, so that their areas unite; the mirrored y axis reverses it.
    void fillUnion(std::vector<std::vector<Vec2>>& loops, Colour colour) {
        for (auto& loop : loops) {
            if (signedArea(loop) < 0.0) std::reverse(loop.begin(), loop.end());
        }
        canvas_.fill(loops, colour);
    }

    Box view_;
    double scale_;  // Pixels per metre.
    Canvas canvas_;
};

}  // namespace

std::unique_ptr<DebugDraw> makePngDraw(const Box& view, std::int32_t width, Colour ground) {
    return std::make_unique<PngDraw>(view, width, ground);
}

}  // namespace muster
