// A software raster: anti-aliased polygons by exact horizontal and sampled vertical coverage; and text as
// polygons.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/geometry/polygon.h"
#include "lab/picture/debug_draw.h"

namespace muster {

/// RGB pixels from the top left; coordinates in pixels, y downwards.
class Canvas {
public:
    Canvas(std::int32_t width, std::int32_t height, Colour ground);

    /// Blends the union of loops (non-zero winding) in one colour.
    void fill(std::span<const std::vector<Vec2>> loops, Colour colour);
    /// Blends one pixel.
    void blend(std::int32_t x, std::int32_t y, Colour colour, double coverage);

    std::int32_t width() const { return width_; }    ///< Width of the picture [px].
    std::int32_t height() const { return height_; }  ///< Height of the picture [px].
    /// All pixels, row by row, as red, green and blue.
    std::vector<std::uint8_t> bytes() const;

private:
    struct Edge {
        double x0, y0, x1, y1;  // Both ends, y0 < y1 [px].
        int winding;
    };
    struct Crossing {
        double x;
        int winding;
    };
    void addSpan(double from, double to, double weight);
    void sampleRow(double y, double weight);

    std::int32_t width_;
    std::int32_t height_;
    std::vector<float> pixels_;  // Red, green and blue of each pixel, 0 to 255.
    std::vector<Edge> edges_;    // Working memory.
    std::vector<Crossing> crossings_;
    std::vector<double> coverage_;  // Coverage of one row.
};

/// Outlines of a line drawn with a round pen, as overlapping loops of the same orientation.
void strokeLoops(std::span<const Vec2> points, bool closed, double width, double dash,
                 std::vector<std::vector<Vec2>>& loops);
/// A regular polygon that approximates a disc of `radius` [px].
std::vector<Vec2> discLoop(Vec2 centre, double radius);

/// Encodes a PNG file.
std::vector<std::uint8_t> encodePng(std::int32_t width, std::int32_t height, std::int32_t channels,
                                    std::span<const std::uint8_t> bytes);
/// Bilinear interpolation of a raster at (u, v) [samples]; edge samples repeat.
Colour sampleRaster(std::int32_t width, std::int32_t height, std::span<const Colour> colours, double u,
                    double v);

/// Converts UTF-8 text to the characters that can be drawn, ASCII 32 to 126: Latin letters without
/// diacritics, "?" for each other code point and for invalid bytes.
std::string plainLetters(std::string_view words);

/// Appends the strokes of a line of text, in plain letters, that starts at x = 0 and is centred on y = 0
/// [px], y downwards; 200 letters at most. Returns its width [px].
double letterLoops(std::string_view words, double size, std::vector<std::vector<Vec2>>& loops);

}  // namespace muster
