// A sink for pictures: shapes in world coordinates, line widths and text in pixels.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "muster/status.h"
#include "muster/vec2.h"

namespace muster {

/// Colour with opacity.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    double opacity = 0.0;  ///< 0 to 1; 0 draws nothing.

    /// From 0xRRGGBB.
    static constexpr Colour of(std::uint32_t rgb, double opacity = 1.0) {
        return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
                static_cast<std::uint8_t>(rgb), opacity};
    }
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// How a line is drawn: round caps and joins.
struct Stroke {
    Colour colour;
    double width = 0.0;  ///< [px]; 0 draws nothing.
    double dash = 0.0;   ///< Length of dashes and of gaps [px]; 0 for a whole line.
};

/// Where a text stands against its point.
enum class TextAnchor : std::uint8_t { Left, Centre, Right };

/// What can be drawn. Later things lie above earlier ones.
class DebugDraw {
public:
    virtual ~DebugDraw() = default;

    /// Fills and outlines an area given by closed loops (non-zero winding: loops of opposite turn are holes).
    virtual void area(std::span<const std::vector<Vec2>> loops, Colour fill, const Stroke& stroke) = 0;
    /// An open line.
    virtual void line(std::span<const Vec2> points, const Stroke& stroke) = 0;
    /// Many open lines of one style: the same as line() for each, in less space.
    virtual void lines(std::span<const std::vector<Vec2>> lines, const Stroke& stroke);
    /// A disc of `radius` [m].
    virtual void disc(Vec2 centre, double radius, Colour fill, const Stroke& stroke) = 0;
    /// A picture of width x height colours over `box`, row-major from the lower left, smoothly scaled.
    virtual void raster(const Box& box, std::int32_t width, std::int32_t height,
                        std::span<const Colour> colours) = 0;
    /// A line of text (UTF-8; PNG knows plain Latin letters only) of `size` [px], vertically centred on `at`.
    virtual void text(Vec2 at, std::string_view words, double size, Colour colour, TextAnchor anchor) = 0;

    /// Metres per pixel: to give lengths on the screen in world units.
    virtual double pixel() const = 0;
    /// What the picture shows [m].
    virtual Box view() const = 0;
    /// The whole file as bytes: an SVG document, or a PNG picture.
    virtual std::string document() const = 0;

    /// Writes document() into a file. Fails with IoError.
    Status write(const std::string& path) const;

    /// One polygon.
    void polygon(std::span<const Vec2> corners, Colour fill, const Stroke& stroke);
};

/// Draws into an SVG document of `width` pixels that shows `view` on a ground of that colour.
std::unique_ptr<DebugDraw> makeSvgDraw(const Box& view, std::int32_t width, Colour ground);
/// Draws into a PNG picture, anti-aliased.
std::unique_ptr<DebugDraw> makePngDraw(const Box& view, std::int32_t width, Colour ground);

}  // namespace muster
