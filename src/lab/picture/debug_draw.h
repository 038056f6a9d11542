// The interface for drawing pictures: shapes in world coordinates, line widths and text sizes in pixels.
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

/// A colour with opacity.
struct Colour {
    std::uint8_t red = 0;
    std::uint8_t green = 0;
    std::uint8_t blue = 0;
    double opacity = 0.0;  ///< 0 to 1; 0 draws nothing.

    /// Makes a colour from 0xRRGGBB.
    static constexpr Colour of(std::uint32_t rgb, double opacity = 1.0) {
        return {static_cast<std::uint8_t>(rgb >> 16), static_cast<std::uint8_t>(rgb >> 8),
                static_cast<std::uint8_t>(rgb), opacity};
    }
    friend bool operator==(const Colour&, const Colour&) = default;
};

/// The style of a line; caps and joins are round.
struct Stroke {
    Colour colour;
    double width = 0.0;  ///< Width of the line [px]; 0 draws nothing.
    double dash = 0.0;   ///< Length of dashes and of gaps [px]; 0 for a solid line.
};

/// Horizontal alignment of a text relative to its point.
enum class TextAnchor : std::uint8_t { Left, Centre, Right };

/// The drawing functions. Later shapes cover earlier ones.
class DebugDraw {
public:
    virtual ~DebugDraw() = default;

    /// Fills and outlines an area given by closed loops (non-zero winding: loops of opposite orientation are
    /// holes).
    virtual void area(std::span<const std::vector<Vec2>> loops, Colour fill, const Stroke& stroke) = 0;
    /// Draws an open line.
    virtual void line(std::span<const Vec2> points, const Stroke& stroke) = 0;
    /// Draws many open lines of one style; the file is smaller than with line() for each.
    virtual void lines(std::span<const std::vector<Vec2>> lines, const Stroke& stroke);
    /// Draws a disc of `radius` [m].
    virtual void disc(Vec2 centre, double radius, Colour fill, const Stroke& stroke) = 0;
    /// Draws a raster of width x height colours over `box`, row-major from the lower left, with
    /// interpolation.
    virtual void raster(const Box& box, std::int32_t width, std::int32_t height,
                        std::span<const Colour> colours) = 0;
    /// Draws a line of text (UTF-8; PNG supports plain Latin letters only) of `size` [px], vertically centred
    /// on `at`.
    virtual void text(Vec2 at, std::string_view words, double size, Colour colour, TextAnchor anchor) = 0;

    /// Metres per pixel, for lengths that are given on the screen.
    virtual double pixel() const = 0;
    /// The visible area [m].
    virtual Box view() const = 0;
    /// The whole file: an SVG document or a PNG picture.
    virtual std::string document() const = 0;

    /// Writes document() to a file. Fails with IoError.
    Status write(const std::string& path) const;

    /// Draws one polygon.
    void polygon(std::span<const Vec2> corners, Colour fill, const Stroke& stroke);
};

/// Draws into an SVG document of `width` pixels that shows `view` on a background of the colour `ground`.
std::unique_ptr<DebugDraw> makeSvgDraw(const Box& view, std::int32_t width, Colour ground);
/// Draws into a PNG picture with anti-aliasing.
std::unique_ptr<DebugDraw> makePngDraw(const Box& view, std::int32_t width, Colour ground);

}  // namespace muster
