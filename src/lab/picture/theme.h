// Colours and sizes of pictures.
#pragma once

#include <array>
#include <cstdint>

#include "lab/picture/debug_draw.h"
#include "lab/picture/picture.h"

namespace muster {

/// Colours for light or dark backgrounds.
struct Theme {
    Colour ground, gridFine, gridCoarse, ink, ink2, panel;
    Colour obstacleFill, obstacleEdge, hatch, shadow;
    Colour water, net, brick, branch, jump, plain;  ///< Colours of patches, by motion.
    std::array<Colour, 6> accents;                  ///< Colours of groups.
    std::array<Colour, 5> ramp;                     ///< Colours of fields, from near to far.

    /// The concept's colours.
    static const Theme& of(bool dark);
    /// A colour of the ramp, 0 to 1.
    Colour shade(double share) const;
};

/// State that all drawing functions share.
struct Pen {
    DebugDraw& draw;
    const Theme& theme;
    const World& world;
    const PictureDef& def;
    double unit = 1.0;  ///< Scale of sizes, which are for a picture of 1280 px.

    /// A stroke of `width` pixels of a picture of 1280 px.
    Stroke stroke(Colour colour, double width, double dash = 0.0) const {
        return {colour, width * unit, dash * unit};
    }
    /// Length of `pixels` pixels of a picture of 1280 px [m].
    double metres(double pixels) const { return pixels * unit * draw.pixel(); }
    /// The colour of a group.
    Colour accent(std::size_t group, double opacity = 1.0) const;
};

/// The same colour with another opacity.
inline Colour faded(Colour colour, double opacity) {
    colour.opacity = opacity;
    return colour;
}

void drawGroundLines(const Pen& pen);
void drawObstacles(const Pen& pen);
void drawPatches(const Pen& pen);
void drawPatchTags(const Pen& pen);
void drawItems(const Pen& pen);
void drawMeshes(const Pen& pen);
void drawPlaces(const Pen& pen);
void drawTrails(const Pen& pen);
void drawPaths(const Pen& pen);
void drawControls(const Pen& pen);
void drawCharacters(const Pen& pen);
void drawPotentialField(const Pen& pen);
void drawCostField(const Pen& pen);
void drawDensity(const Pen& pen);

/// The colour for a dark background that belongs to a chosen colour, 0xRRGGBB: the other one of its pair; a
/// colour without a pair stays.
std::uint32_t darkSwatch(std::uint32_t colour);

}  // namespace muster
