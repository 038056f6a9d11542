// Measures of the two bodies.
#pragma once

#include <span>

#include "muster/vec3.h"

namespace muster::bodies {

/// A cross section of a trunk, limb or head: two half ellipses.
struct Section {
    float along = 0.0f;   ///< Height of the section; for arms its distance to the side [m].
    float side = 0.0f;    ///< Half the width; for arms half the height [m].
    float front = 0.0f;   ///< Extent forward of x = 0 [m].
    float back = 0.0f;    ///< Extent backward of x = 0 [m].
    bool far = false;     ///< True if it is part of the coarse mesh too.
    float middle = 0.0f;  ///< Centre: of legs to the side, of arms in height [m].
};

/// The measures in which bodies differ.
struct Shape {
    std::span<const Section> pelvis;  ///< Sections from the crotch to under the shirt.
    std::span<const Section> shirt;   ///< Sections from the hem of the shirt to the collar.
    std::span<const Section> leg;     ///< Sections from below the crotch to the trousers' hem.
    std::span<const Section> sleeve;  ///< Sections from the shoulder to the sleeve's hem.
    std::span<const Section> arm;     ///< Sections from inside the sleeve to the finger tips.
    std::span<const Section> neck;    ///< Sections from inside the collar into the head.
    std::span<const Section> head;    ///< Sections from the chin to the crown.
    std::size_t holeBegin = 0;        ///< First section of the shirt at the sleeves, fine mesh.
    std::size_t holeEnd = 0;
    float midDrop = 0.0f;    ///< Drop of the pelvis' first section in the middle [m].
    float crotch = 0.0f;     ///< Height of the crotch [m].
    float hairSides = 0.0f;  ///< Height of the hairline at the temples [m].
    float hairNape = 0.0f;   ///< Height of the hairline at the nape [m].
    float hairThick = 0.0f;  ///< Thickness of the hair [m].
    bool tied = false;       ///< True if hair hangs in a tail.
    float handSize = 1.0f;   ///< Factor on the size of the thumb.
    float footWidth = 1.0f;  ///< Factor on the width of the shoes.
};

/// Wide shoulders, short hair.
const Shape& broadShape();
/// Narrow shoulders, wider hips, tied hair.
const Shape& narrowShape();

}  // namespace muster::bodies
