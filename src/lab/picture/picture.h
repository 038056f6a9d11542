// Draws a world in layers, in the colours of the concept.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "lab/picture/debug_draw.h"
#include "muster/status.h"
#include "muster/world.h"

namespace muster {

/// The layers of a picture; a set of bits.
enum class Layer : std::uint32_t {
    Obstacles = 1u << 0,
    Patches = 1u << 1,
    Mesh = 1u << 2,
    Places = 1u << 3,
    Paths = 1u << 4,  ///< Drawn trajectories, and the past paths of characters.
    Field = 1u << 5,  ///< Potential field of obstacles.
    Cost = 1u << 6,   ///< Cost field of one place (the paper's figure 6).
    Density = 1u << 7,
    Characters = 1u << 8,
};

/// Parses names of layers, separated by commas: "obstacles,mesh,cost". Fails naming an unknown layer.
Result<std::uint32_t> parseLayers(std::string_view names);
/// All names of layers, in the order of drawing.
std::vector<std::string> layerNames();

/// Options of a picture.
struct PictureDef {
    std::uint32_t layers = 0;   ///< Layer bits; 0 for all except the three coloured rasters.
    std::int32_t width = 1280;  ///< Width of the picture [px], 64 to 8192.
    std::optional<Box> view;    ///< Visible area [m]; empty for the whole world.
    bool dark = false;          ///< Uses colours for a dark background.
    /// The place whose cost field is shown; -1 for that of the character with the most expensive path.
    std::int32_t place = -1;
    std::size_t group = 0;                  ///< Index of the group that the place belongs to.
    std::vector<std::vector<Vec2>> trails;  ///< Past positions by character; may be empty.
};

/// Draws a world.
void drawWorld(DebugDraw& draw, const World& world, const PictureDef& def);
/// Draws a world as an SVG document that can be embedded in another document. Fails with InvalidArgument.
Result<std::string> svgPicture(const World& world, const PictureDef& def);
/// Draws a world into a .png or .svg file, by the file's extension. Fails with InvalidArgument or IoError.
Status writePicture(const World& world, const PictureDef& def, const std::string& path);

/// Lines of equal value through a grid of samples (marching squares), row-major from the lower left. Samples
/// that are not finite break the lines. Each segment is a pair of points in sample coordinates.
std::vector<std::pair<Vec2, Vec2>> contourSegments(std::int32_t width, std::int32_t height,
                                                   std::span<const double> samples, double level);

}  // namespace muster
